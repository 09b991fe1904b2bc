// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/job_panel.hpp"

#include <QHBoxLayout>
#include <QResizeEvent>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>

#include "hmi/session/display_text.hpp"
#include "hmi/session/preflight.hpp"
#include "hmi/session/saved_piece.hpp"
#include "hmi/session/start_intent.hpp"
#include "hmi/session/start_place.hpp"
#include "hmi/ui/anew_dialog.hpp"
#include "hmi/ui/disk_piece_dialog.hpp"
#include "hmi/ui/job_pair_view.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/motion_buttons.hpp"
#include "hmi/ui/order_card.hpp"
#include "hmi/ui/preflight_list.hpp"
#include "hmi/ui/report_dialog.hpp"
#include "hmi/ui/start_from_dialog.hpp"
#include "hmi/ui/tick_box.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::Action;

constexpr int kFullPercent = 100;
constexpr int kCloseGap = 2;
constexpr int kLeastBox_px = 44;  // for four digits

}  // namespace

JobPanel::JobPanel(WindowContext& context, QWidget* parent) : Dock(tr("Job"), parent), context_(context) {
    make_jobs();
    body().addSpacing(kSmallGap);
    checks_ = new PreflightList;
    body().addWidget(checks_);
    body().addStretch();
    make_buttons();
    make_override();
}

void JobPanel::make_jobs() {
    jobs_ = new JobPairView{context_, title(), note()};
    report_ = new ActionButton{[](const WindowContext& now) -> std::optional<session::Phrase> {
                                   if (!now.runs.run()) return session::phrase("Report: no job was started");
                                   if (!now.job_of_run())
                                       return session::phrase("Report: the job is not known");
                                   return std::nullopt;
                               },
                               tr("Report"), [this] { show_report(); }};
    report_->setObjectName("report_button");
    report_->setProperty("small", true);
    jobs_->add_button(report_);
    body().addWidget(jobs_);
}

void JobPanel::let_keys_start(bool may_start) {
    start_->setShortcut(may_start ? QKeySequence{Qt::CTRL | Qt::Key_Return} : QKeySequence{});
}

void JobPanel::make_buttons() {
    const MotionButtons motion = make_motion_buttons(context_);
    start_ = motion.start;
    hold_ = motion.hold;
    resume_ = motion.resume;
    stop_ = motion.stop;
    start_->setProperty("main", true);
    start_->setObjectName("start");
    dry_run_ = new TickBox{tr("Dry run")};
    dry_run_->setObjectName("dry_run");
    dry_run_->setFocusPolicy(Qt::TabFocus);
    dry_run_->setChecked(context_.wanted_run == session::RunKind::dry);
    connect(dry_run_, &QCheckBox::toggled, this, [this](bool is_dry) {
        context_.wanted_run = is_dry ? session::RunKind::dry : session::RunKind::carve;
        refresh_buttons();
    });
    auto* three = new QHBoxLayout;
    three->setSpacing(kGap);
    const char* names[] = {"hold", "resume", "stop"};
    ActionButton* buttons[] = {hold_, resume_, stop_};
    for (int i = 0; i < 3; ++i) {
        buttons[i]->setProperty("strong", true);
        buttons[i]->setObjectName(names[i]);
        three->addWidget(buttons[i], 1);
    }
    layer_ = new QSpinBox;
    ignore_wheel(layer_);
    layer_->setRange(1, std::max(1, context_.first_layer.chosen));
    layer_->setValue(context_.first_layer.chosen);
    connect(layer_, &QSpinBox::valueChanged, this,
            [this](int chosen) { context_.first_layer.chosen = chosen; });
    layer_->setObjectName("layer");
    layer_->setAccessibleName(tr("Layer to start from"));
    make_point_box();
    one_layer_ = new ActionButton{Action::one_layer, tr("One layer"), [this] { start_at_layer(1); }};
    one_layer_->setObjectName("one_layer");
    one_layer_->set_hint(tr("Carves this layer and stops in order; press again for the next one"));
    from_layer_ = new ActionButton{Action::from_layer, tr("From layer"), [this] { start_at_layer(0); }};
    from_layer_->setObjectName("from_layer");
    from_layer_->set_hint(tr("Leaves out the layers before it"));
    auto* from = new QHBoxLayout;
    from->setSpacing(kSmallGap);
    from->addWidget(one_layer_, 0);
    from->addWidget(from_layer_, 0);
    from->addWidget(layer_, 1);
    from->addWidget(point_, 1);
    for (ActionButton* button : {one_layer_, from_layer_}) button->setProperty("narrow", true);
    for (QSpinBox* box : {layer_, point_}) {
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        box->setMinimumWidth(kLeastBox_px);
    }
    reason_ = role_label("label");
    reason_->setWordWrap(true);
    reason_->setMinimumHeight(32);
    reason_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    reason_->setObjectName("reason");
    body().addWidget(dry_run_);
    body().addWidget(start_);
    body().addSpacing(kSmallGap);
    body().addLayout(three);
    body().addSpacing(kSmallGap);
    body().addLayout(from);
    body().addWidget(reason_);
    refused_ = new OrderCard{context_, session::OrderPlace::job, "job", OrderCard::Shape::high, this};
    // What was refused was another start.
    const auto forget = [this] { context_.machine.forget_refused_order(session::OrderPlace::job); };
    connect(layer_, &QSpinBox::valueChanged, this, forget);
    connect(point_, &QSpinBox::valueChanged, this, forget);
    connect(dry_run_, &QCheckBox::toggled, this, forget);
}

void JobPanel::make_point_box() {
    point_ = new QSpinBox;
    ignore_wheel(point_);
    point_->setRange(0, context_.first_layer.point);
    point_->setSpecialValueText(QStringLiteral("–"));  // the layer's begin
    point_->setValue(context_.first_layer.point);
    connect(point_, &QSpinBox::valueChanged, this, [this](int point) { context_.first_layer.point = point; });
    // A point was chosen of the layer that stood there.
    connect(layer_, &QSpinBox::valueChanged, this, [this] { point_->setValue(0); });
    point_->setObjectName("point");
    point_->setAccessibleName(tr("Point of that layer to start from"));
}

void JobPanel::make_override() {
    auto* head = new QHBoxLayout;
    head->addWidget(role_label("head", tr("Feed override")));
    head->addStretch();
    percent_ = role_label("title");
    head->addWidget(percent_);
    override_ = new QSlider{Qt::Horizontal};
    ignore_wheel(override_);
    override_->setRange(kLeastOverride_percent, kMostOverride_percent);
    override_->setPageStep(5);
    override_->setValue(kFullPercent);
    override_->setFocusPolicy(Qt::NoFocus);
    ignore_keys(override_);
    override_->setObjectName("override");
    override_->setAccessibleName(tr("Feed override"));
    connect(override_, &QSlider::valueChanged, this,
            [this](int value) { context_.machine.set_override(static_cast<std::uint32_t>(value)); });
    full_ =
        new ActionButton{Action::override_feed, tr("100 %"), [this] { override_->setValue(kFullPercent); }};
    full_->setProperty("small", true);
    full_->setObjectName("full");
    auto* row = new QHBoxLayout;
    row->addWidget(role_label("label", QString::number(kLeastOverride_percent)));
    row->addWidget(override_, 1);
    row->addWidget(role_label("label", QString::number(kMostOverride_percent)));
    row->addWidget(full_);
    body().addLayout(head);
    body().addWidget(rule());
    body().addLayout(row);
}

session::StartPlace JobPanel::chosen_place() const {
    session::StartPlace place{static_cast<std::uint32_t>(layer_->value()) - 1, {}};
    if (point_->value() != 0) place.point = static_cast<std::uint32_t>(point_->value()) - 1;
    return place;
}

void JobPanel::start_at_layer(std::uint32_t layers) {
    const session::StartPlace from = chosen_place();
    const session::MachineView& machine_view = context_.machine.view();
    // Layer after layer there is nothing to ask: it is where the carving stopped.
    const bool is_next = layers > 0 && from.layer == context_.first_layer.offered &&
                         (!from.point || session::place_to_go_on(machine_view) == from);
    const session::RunKind kind = context_.wanted_run;  // whatever is chosen while it is asked
    // What only a disk knows is asked for by its own question, however the layer is started.
    if (kind == session::RunKind::carve && session::is_from_disk_alone(machine_view, from.layer)) {
        if (asked_to_go_on_from_disk(context_, from.layer, window()))
            context_.machine.start(from, layers, kind);
        return;
    }
    if (is_next || may_start_from(from, kind)) context_.machine.start(from, layers, kind);
}

bool JobPanel::may_start_from(const session::StartPlace& from, session::RunKind kind) {
    if (from == session::StartPlace{})
        return kind == session::RunKind::dry || asked_to_begin_anew(context_, kind, window());
    return asked_to_start_from(context_, from, kind, window());
}

void JobPanel::show_report() {
    auto* report = new ReportDialog{context_.runs, context_.job_of_run(),
                                    context_.pins.verdict_on(*context_.runs.run()), context_.files, window()};
    report->show();
}

void JobPanel::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    checks_->set_theme(tokens);
    refused_->set_theme(tokens);
    start_->set_glyph(Glyph::play, tokens, true);
    hold_->set_glyph(Glyph::pause, tokens);
    stop_->set_glyph(Glyph::stop, tokens);
    refresh();
}

void JobPanel::refresh() {
    if (tokens_ == nullptr) return;
    refresh_jobs();
    refresh_checks();
    lock_with(*dry_run_, context_.replay.is_open() ? words(*replay::lock()) : QString{},
              tr("Start, One layer and From layer carve nothing: table and Y go as they would, heads outside "
                 "the blank, spindle off"));
    refresh_buttons();
    refresh_override();
    // Another line has come, or one has gone.
    if (least_height() != fitted_height_) fit();
}

void JobPanel::change_override(int percent) {
    if (!override_->isEnabled()) return;
    override_->setValue(percent == 0 ? 100 : override_->value() + percent);  // %
}

void JobPanel::refresh_jobs() {
    jobs_->refresh();
    const auto job = jobs_->job();
    if (!job) return;
    // The layer's number may be the same in another job.
    if (context_.first_layer.job.lock() != job) point_->setValue(0);
    context_.first_layer.job = job;
    layer_->setMaximum(static_cast<int>(job->view.layer_count()));
    point_->setMaximum(static_cast<int>(job->view.point_count()));
}

void JobPanel::resizeEvent(QResizeEvent* event) {
    Dock::resizeEvent(event);
    fit();
}

void JobPanel::set_room(Room room) {
    room_ = room;
    jobs_->set_room(room);
}

/// As loose as there is room for: buttons as high as they should be, or lines close together, or as few of
/// them as will do.
void JobPanel::fit() {
    for (const Density density : {Density::loose, Density::close, Density::brief}) {
        arrange(density);
        // A page of one column scrolls.
        if (room_ == Room::small && density == Density::close) break;
        if (least_height() <= height()) break;
    }
    fitted_height_ = least_height();
}

int JobPanel::least_height() const {
    const QLayout& all = *layout();
    return all.hasHeightForWidth() ? all.totalMinimumHeightForWidth(width())
                                   : all.totalMinimumSize().height();
}

void JobPanel::arrange(Density density) {
    const bool is_loose = density == Density::loose;
    body().setSpacing(is_loose ? kSmallGap : kCloseGap);
    checks_->set_low(!is_loose);
    jobs_->set_density(!is_loose, density == Density::brief);
    for (ActionButton* button : {start_, hold_, resume_, stop_})
        set_styled(button, "low", is_loose ? "no" : "yes");
    // What they need is asked for before their own layouts have told it.
    for (QWidget* part : {static_cast<QWidget*>(jobs_), static_cast<QWidget*>(checks_),
                          static_cast<QWidget*>(start_), static_cast<QWidget*>(stop_)})
        part->updateGeometry();
    layout()->activate();
}

void JobPanel::refresh_checks() {
    if (context_.replay.is_open()) return checks_->show_contents(context_.replay.facts().contents);
    checks_->show_checks(session::preflight_checks(context_.machine.view(), context_.open_job.view()));
}

void JobPanel::refresh_buttons() {
    show_what_starts(*start_, context_);
    for (ActionButton* button : {start_, hold_, resume_, stop_, one_layer_, from_layer_, report_})
        button->refresh(context_);
    lock_with(*layer_, from_layer_->reason());
    lock_with(*point_, from_layer_->reason(), tr("The layer's begin, or the point at which the heads go in"));
    const auto resumable = context_.machine.view().resumable_layer;
    from_layer_->set_hint(
        resumable ? tr("Leaves out the layers before it; %1 was the last that was finished").arg(*resumable)
                  : tr("Leaves out the layers before it"));
    reason_->setText(said_beside({start_, hold_, resume_, stop_}, checks_->to_look_at()));
    // In a small window Start stands below the panels, and has one of its own.
    if (room_ == Room::small)
        refused_->hide();
    else
        refused_->refresh_beside(*this, *start_);
    refresh_layer();
}

/// Where the operator would go on: of a core that is gone the checkpoint knows it, as the banner says.
void JobPanel::refresh_layer() {
    const session::MachineView& machine_view = context_.machine.view();
    const auto job = context_.open_job.core_job();
    std::uint32_t next = 0;
    if (!machine_view.is_heard()) {
        if (!machine_view.resumable_layer) return;
        next = *machine_view.resumable_layer;
    } else {
        if (!machine_view.status || !job) return;
        const bool is_other = context_.open_job.job() && context_.open_job.job() != job;
        if (!is_other)
            next = session::layer_to_go_on_with(*machine_view.status, machine_view.resumable_layer,
                                                job->view.layer_count());
    }
    // Before the job is known the box has no room for it.
    std::uint32_t& offered = context_.first_layer.offered;
    if (next == offered || static_cast<int>(next) >= layer_->maximum()) return;
    offered = next;
    layer_->setValue(static_cast<int>(offered) + 1);
}

void JobPanel::refresh_override() {
    lock_with(*override_, full_->refresh(context_), tr("By mouse, or with Ctrl+−, Ctrl++ and Ctrl+0"));
    const auto& status = context_.shown().status;
    if (!status || status->override_percent == 0) return;
    const int percent = static_cast<int>(status->override_percent);
    percent_->setText(tr("%1 %").arg(percent));
    // The slider follows the machine unless a hand is on it, or its wish is still on the way.
    if (!override_->isSliderDown() && !context_.machine.is_override_under_way() &&
        override_->value() != percent) {
        const QSignalBlocker quiet{override_};
        override_->setValue(percent);
    }
}

}  // namespace psicarve::ui
