// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/carving_page.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/scene/colour_map.hpp"
#include "hmi/scene/radius_map.hpp"
#include "hmi/scene/stock_scene.hpp"
#include "hmi/session/alarm_text.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/axis_table.hpp"
#include "hmi/ui/checked_width.hpp"
#include "hmi/ui/colour_bar.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/view_buttons.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

/// Never more often than this, so that the machine's computer has time for the machine.
constexpr qint64 kLeastPause_ms = 66;
constexpr double kRodLength = 0.35;  // of the blank's diameter
constexpr double kRodRadius = 0.04;
constexpr double kAlarmRing = 0.25;

constexpr int kLeastForTable = 400;  // of the page's height
constexpr int kLeastForTitle = 480;  // of its width

session::CarvedScenePlan plan_for(Drawing drawing) {
    return drawing == Drawing::opengl ? session::CarvedScenePlan{480, 400, 2, kDoneColour, kBlankColour}
                                      : session::CarvedScenePlan{240, 200, 2, kDoneColour, kBlankColour};
}

bool is_moving(MachineState state) {
    return !is_at_rest(state);
}

}  // namespace

CarvingPage::CarvingPage(WindowContext& context, Drawing drawing, QWidget* parent)
    : QWidget(parent),
      context_(context),
      view_(new MeshView{drawing}),
      axes_(new AxisTable{context}),
      colourings_(new QButtonGroup{this}),
      done_(role_label("label")),
      blank_(role_label("label")),
      doubt_(role_label("label")),
      behind_(role_label("label")),
      feed_(role_label("label")),
      point_(role_label("title")) {
    view_->setObjectName("carving_view");
    view_->setAccessibleName(tr("The blank as carved so far"));
    view_->set_empty_text(tr("No job is published."));
    view_->look_from(MeshView::Side::front);
    point_->setObjectName("carving_point");
    done_->setObjectName("carving_done");
    blank_->setObjectName("carving_blank");
    doubt_->setObjectName("carving_doubt");
    doubt_->setToolTip(
        tr("The table had lost steps there. Measure the piece, or go on from the first of these layers"));
    for (QLabel* label : {done_, blank_, doubt_})
        label->setTextFormat(Qt::RichText);  // squares of colour; no names
    behind_->setObjectName("carving_behind");
    feed_->setObjectName("carving_feed");
    feed_->setToolTip(tr("Of the faster head's tool over the surface, in the last second"));
    setObjectName("carving_page");
    auto* foot = new FlowLayout;
    foot->setSpacing(kGap);
    for (QLabel* label : {done_, blank_, doubt_, behind_}) foot->addWidget(label);
    foot->add_end();
    foot->addWidget(feed_);
    foot->addWidget(point_);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    auto* above = view_buttons(*view_);
    add_colourings(*above);
    all->addLayout(above);
    all->addWidget(view_, 1);
    all->addLayout(foot);
    all->addWidget(axes_);
}

void CarvingPage::add_colourings(QLayout& row) {
    const QString names[] = {tr("Done"), tr("Radius"), tr("Deviation")};
    const char* const ids[] = {"colour_done", "colour_radius", "colour_deviation"};
    for (int i = 0; i < 3; ++i) {
        auto* button = new QPushButton{names[i]};
        button->setProperty("small", true);
        button->setObjectName(ids[i]);
        button->setCheckable(true);
        button->setChecked(i == 0);
        leave_room_for_bold(*button);
        button->setFocusPolicy(Qt::TabFocus);
        colourings_->addButton(button, i);
        row.addWidget(button);
    }
    colourings_->setObjectName("colouring");
    connect(colourings_, &QButtonGroup::idToggled, this, [this](int id, bool is_on) {
        if (is_on) colour_by(static_cast<session::Colouring>(id));
    });
}

void CarvingPage::colour_by(session::Colouring colouring) {
    colouring_ = colouring;
    scene_.reset();
    drawn_.invalidate();
}

void CarvingPage::resizeEvent(QResizeEvent* event) {
    // Where room is short the piece is worth more than figures.
    axes_->setVisible(event->size().height() >= kLeastForTable);
    set_styled(point_, "role", event->size().width() < kLeastForTitle ? "head" : "title");
    QWidget::resizeEvent(event);
}

session::CarvedScenePlan CarvingPage::plan() const {
    session::CarvedScenePlan plan = plan_for(view_->drawing());
    plan.doubt_rgb = kDoubtColour;
    plan.colouring = colouring_;
    plan.least_mm = least_mm_;
    plan.most_mm = most_mm_;
    return plan;
}

void CarvingPage::show_scale() {
    const auto job = context_.job_at_work();
    if (colouring_ == session::Colouring::done || !job || tokens_ == nullptr) return view_->set_legend({});
    const auto mm = [](double value, int decimals) {
        return QString::fromStdString(session::number_text(value, decimals));
    };
    if (colouring_ == session::Colouring::radius) {
        return view_->set_legend(
            QStringLiteral("%1 %2 %3")
                .arg(mm(least_mm_, 0), colour_bar(session::viridis), tr("%1 mm").arg(mm(most_mm_, 0))));
    }
    const session::CarvedScenePlan now = plan();
    const double reach_mm = now.reach_pulses / axis_motion(job->profile, Axis::r1).pulses_per_unit;
    const auto colour = [&now](double ratio) {
        const bool is_neutral = std::abs(2.0 * ratio - 1.0) * now.reach_pulses <= now.neutral_pulses;
        return is_neutral ? kDoneColour : session::vik(ratio);
    };
    view_->set_legend(tr("too deep %1 material left<br>±%2 mm, ±%3 pulses")
                          .arg(colour_bar(colour), mm(reach_mm, 3), QString::number(now.reach_pulses)));
}

void CarvingPage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    view_->set_theme(tokens);
    axes_->set_theme(tokens);
    drawn_positions_ = {};
}

void CarvingPage::refresh() {
    context_.carving.refresh();
    if (blank_edition_ != context_.carving.edition()) scene_.reset();
    blank_edition_ = context_.carving.edition();
    axes_->refresh();
    // A recording's pulses are judged by `psicarve verify`; here it is the piece alone.
    QAbstractButton* const deviation = colourings_->button(static_cast<int>(session::Colouring::deviation));
    lock_with(
        *deviation,
        context_.replay.is_open() ? tr("Deviation: not of a recording; psicarve verify tells it") : QString{},
        tr("Carved against wanted: blue too deep, brown material left"));
    if (context_.replay.is_open() && colouring_ == session::Colouring::deviation)
        colourings_->button(static_cast<int>(session::Colouring::done))->click();
    if (!isVisible() || tokens_ == nullptr) return;
    draw();
    say();
}

session::CarvingRecord* CarvingPage::shown_record() const noexcept {
    return context_.replay.is_open() ? context_.replay.carving() : context_.carving.record();
}

piece::PieceFront* CarvingPage::shown_piece() const noexcept {
    if (context_.replay.is_open()) return context_.replay.tool_piece();
    return context_.carving.piece() != nullptr ? &context_.carving.piece()->front() : nullptr;
}

/// Grows with whatever of the piece has changed.
std::uint64_t CarvingPage::shown_edition() const noexcept {
    const piece::PieceFront* const front = shown_piece();
    return shown_record()->edition() + (front != nullptr ? front->edition() : 0);
}

void CarvingPage::draw() {
    session::CarvingRecord* const record = shown_record();
    // A fresh blank is on its way: what stands there stays until then.
    if (record == nullptr && context_.carving.has_job() && !context_.replay.is_open()) return;
    if (shown_replay_ != context_.replay.edition() || drawn_record_ != record) scene_.reset();
    shown_replay_ = context_.replay.edition();
    drawn_record_ = record;
    if (record == nullptr) {
        if (view_->picture().bodies.empty()) return;
        view_->set_heads({});
        return view_->show_scene(nullptr);
    }
    const auto& status = context_.shown().status;
    verify::Positions positions{};
    if (status)
        std::copy(std::begin(status->position_pulses), std::end(status->position_pulses), positions.begin());
    note_known_heads();
    auto alarm = session::alarm_heads(context_.shown());
    const bool is_same =
        scene_ && drawn_edition_ == shown_edition() && drawn_positions_ == positions && drawn_alarm_ == alarm;
    view_->set_moving(context_.replay.is_open() ? context_.replay.clock().is_playing()
                                                : is_moving(context_.machine.view().state()));
    if (is_same || (drawn_.isValid() && drawn_.elapsed() < kLeastPause_ms)) return;
    drawn_.start();
    drawn_edition_ = shown_edition();
    drawn_positions_ = positions;
    drawn_alarm_ = std::move(alarm);
    if (!scene_ || scene_drawing_ != view_->drawing()) {
        scene_drawing_ = view_->drawing();
        take_range();
        make_scene(*record);
        const bool is_recoloured = is_seen_ == record;
        is_seen_ = record;
        if (is_recoloured) view_->replace_scene(scene_->scene());
        if (!is_recoloured) view_->show_scene(scene_->scene());
        show_scale();
    }
    view_->vertices_changed(scene_->update(*record));
    draw_heads(*record);
}

void CarvingPage::make_scene(const session::CarvingRecord& record) {
    if (piece::PieceFront* const front = shown_piece(); front != nullptr) {
        scene_ = std::make_unique<session::StockScene>(record, *front, plan());
    } else {
        scene_ = std::make_unique<session::CarvedScene>(record, plan());
    }
    rods_ = {};
}

/// Whole mm around the job's radii.
void CarvingPage::take_range() {
    const auto job = context_.job_at_work();
    if (!job || job == ranged_job_) return;
    constexpr std::size_t kColumns = 360;
    constexpr std::size_t kRows = 240;
    const session::RadiusMap map = session::radius_map(*job, kColumns, kRows);
    ranged_job_ = job;
    least_mm_ = map.least_mm;
    most_mm_ = map.most_mm;
}

/// Where a head stands is known once its axis is homed, and from a recording. An alarm makes it uncertain; it
/// is shown where it was last counted.
void CarvingPage::note_known_heads() {
    const session::MachineView& machine_view = context_.machine.view();
    const MachineState state = machine_view.state();
    const bool is_alarm = state == MachineState::alarm || state == MachineState::backing_off;
    for (std::size_t h = 0; h < verify::kHeadCount; ++h) {
        const bool is_homed = machine_view.is_homed(verify::kHeads[h]) && machine_view.is_homed(Axis::y);
        is_head_known_[h] = context_.replay.is_open() || is_homed || (is_alarm && is_head_known_[h]);
    }
}

void CarvingPage::draw_heads(const session::CarvingRecord& record) {
    const auto pose = record.pose(drawn_positions_, scene_->middle_mm());
    const double across_mm = scene_->scene()->size[0];
    const QColor colours[] = {tokens_->r1, tokens_->r2};
    std::vector<MeshView::Head> heads;
    for (std::size_t h = 0; h < verify::kHeadCount; ++h) {
        if (!is_head_known_[h]) continue;
        const auto& at = pose.heads[h];
        if (!rods_[h])
            rods_[h] = std::make_shared<const session::MeshScene>(session::head_scene(
                across_mm * kRodLength, across_mm * kRodRadius, tool::tool_of(record.profile().tool, 1.0)));
        const double name_mm = at.radius_mm + across_mm * kRodLength * 0.85;
        heads.push_back(
            {{rods_[h], {{at.radius_mm, 0.0, at.height_mm}, at.direction_rad}, colours[h].rgb() & 0xFFFFFFU},
             h == 0 ? QStringLiteral("R1") : QStringLiteral("R2"),
             colours[h],
             {name_mm * std::cos(at.direction_rad), name_mm * std::sin(at.direction_rad),
              at.height_mm + 2.0 * across_mm * kRodRadius},
             alarm_at(h, pose)});
    }
    view_->turn_part(pose.part_turn_rad);
    view_->set_heads(std::move(heads));
}

/// A ring round the head's middle, with the state's own words.
std::optional<MeshView::Head::Alarm> CarvingPage::alarm_at(std::size_t head,
                                                           const session::MachinePose& pose) const {
    if (std::find(drawn_alarm_.begin(), drawn_alarm_.end(), verify::kHeads[head]) == drawn_alarm_.end())
        return std::nullopt;
    const double across_mm = scene_->scene()->size[0];
    const auto& at = pose.heads[head];
    const double middle_mm = at.radius_mm + across_mm * kRodLength / 2.0;
    const bool is_last = drawn_alarm_.back() == verify::kHeads[head];
    return MeshView::Head::Alarm{
        {middle_mm * std::cos(at.direction_rad), middle_mm * std::sin(at.direction_rad), at.height_mm},
        across_mm * kAlarmRing,
        is_last ? words(session::state_text(context_.shown(), 0).second) : QString{}};
}

QString CarvingPage::behind_text(const session::LivePiece& piece) {
    constexpr std::uint32_t kFewLayers = 2;
    constexpr std::size_t kFewIncrements = 2'000;  // two seconds of a machine's work
    const std::uint32_t layers = piece.layers_to_come();
    if (layers > kFewLayers) return tr("catching up: %1 layers").arg(layers);
    return piece.waiting() > kFewIncrements ? tr("catching up") : QString{};
}

void CarvingPage::say_doubt() {
    const auto job = context_.job_at_work();
    const session::Phrase text =
        context_.replay.is_open() || !job
            ? session::Phrase{}
            : session::doubt_text(context_.carving.doubt(), report::TableSize::of(job->profile));
    doubt_->setVisible(!text.is_empty());
    doubt_->setText(text.is_empty() ? QString{} : colour_square(kDoubtColour) + words(text));
}

void CarvingPage::say() {
    feed_->setText(runs_job(context_.shown().state()) ? axes_->feed_text() : QString{});
    const auto& status = context_.shown().status;
    const session::CarvingRecord* const record = shown_record();
    const auto job = context_.job_at_work();
    if (context_.replay.carving_ratio() < 1.0) {
        for (QLabel* label : {blank_, doubt_, behind_, point_}) label->clear();
        return done_->setText(
            tr("Working the piece out: %1 %").arg(qRound(100.0 * context_.replay.carving_ratio())));
    }
    if (record == nullptr || !job || !status || status->points_total == 0) {
        for (QLabel* label : {done_, blank_, doubt_, behind_, point_}) label->clear();
        return;
    }
    const std::uint32_t layers = job->view.layer_count();
    const session::LivePiece* const live = context_.replay.is_open() ? nullptr : context_.carving.piece();
    const std::uint32_t planned =
        std::max(record->planned_layers(), live != nullptr ? live->skipped_layers() : 0U);
    const bool is_planned = context_.replay.is_open() && !context_.replay.facts().knows_every_pulse;
    const QString carved = is_planned     ? tr("carved, as planned")
                           : planned == 0 ? tr("carved")
                                          : tr("carved (%1 layers not seen: as planned)").arg(planned);
    done_->setText(colour_square(kDoneColour) + carved);
    blank_->setText(colour_square(kBlankColour) + tr("blank"));
    say_doubt();
    behind_->setText(live != nullptr ? behind_text(*live) : QString{});
    point_->setText(tr("Layer %1 / %2, point %3 / %4")
                        .arg(std::min(status->layer + 1, layers))
                        .arg(layers)
                        .arg(status->point + 1)
                        .arg(job->view.point_count()));
}

}  // namespace psicarve::ui
