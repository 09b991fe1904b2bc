// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/program_page.hpp"

#include <QButtonGroup>
#include <QDir>
#include <QHBoxLayout>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/approach_card.hpp"
#include "hmi/ui/checked_width.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/elided_label.hpp"
#include "hmi/ui/file_filters.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/mdi_line.hpp"
#include "hmi/ui/program_ground.hpp"
#include "hmi/ui/program_path_view.hpp"
#include "hmi/ui/program_text_view.hpp"
#include "hmi/ui/rapid_override.hpp"
#include "hmi/ui/settings.hpp"
#include "hmi/ui/tick_box.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kLeastBesideEachOther_px = 560;
constexpr int kMostProblemsHeight_px = 84;
constexpr int kFromLineWidth_px = 110;
constexpr int kProgressWidth_px = 120;
constexpr int kLeastText_px = 110;

QPushButton* page_button(const char* name, const QString& text) {
    auto* button = new QPushButton{text};
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

}  // namespace

ProgramPage::ProgramPage(WindowContext& context, std::function<void(const QString& path)> open,
                         QWidget* parent)
    : QWidget(parent),
      context_(context),
      open_(std::move(open)),
      name_(new ElidedLabel),
      progress_(new QProgressBar),
      state_(plain_label()),
      facts_(role_label("label")),
      modes_(plain_label()),
      card_(new ApproachCard{context}),
      text_(new ProgramTextView{context.program.text()}),
      path_(new ProgramPathView),
      problems_(new QListWidget),
      mdi_(new MdiLine{context}) {
    setObjectName("program_page");
    name_->setObjectName("program_name");
    name_->setTextFormat(Qt::PlainText);
    state_->setObjectName("program_state");
    state_->setWordWrap(true);
    facts_->setObjectName("program_facts");
    facts_->setWordWrap(true);
    modes_->setObjectName("program_modes");
    modes_->setWordWrap(true);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kSmallGap);
    all->addLayout(make_head());
    all->addWidget(name_);
    all->addLayout(make_switches());
    all->addWidget(state_);
    all->addWidget(modes_);
    all->addWidget(facts_);
    all->addWidget(card_);
    all->addLayout(make_views(), 1);
    make_problems();
    all->addWidget(problems_);
    all->addWidget(mdi_);
}

QLayout* ProgramPage::make_head() {
    auto* choose = page_button("program_open", tr("Open a program…"));
    connect(choose, &QPushButton::clicked, this, [this] { choose_file(); });
    again_ = page_button("program_again", tr("Decode"));
    connect(again_, &QPushButton::clicked, this, [this] { decode_again(); });
    cancel_ = page_button("program_cancel", tr("Cancel"));
    connect(cancel_, &QPushButton::clicked, this, [this] { context_.program.cancel(); });
    progress_->setObjectName("program_progress");
    progress_->setAccessibleName(tr("Progress"));
    progress_->setTextVisible(false);
    progress_->setFixedWidth(kProgressWidth_px);
    start_ = new ActionButton{program_start_lock, tr("Start program"), [this] { start(); }};
    start_->setObjectName("program_start");
    start_->set_hint(tr("Runs it as a process of its own: closing this window ends nothing"));
    stop_ = new ActionButton{program_stop_lock, tr("Stop"), [this] { stop_program(context_); }};
    stop_->let_keys_press();
    stop_->setObjectName("program_stop");
    stop_->set_hint(tr("Ends the program in order: heads out, spindle off (Shift+Esc)"));
    auto* row = new FlowLayout;
    row->setSpacing(kGap);
    for (QWidget* part : {choose, again_, cancel_}) row->addWidget(part);
    row->addWidget(progress_);
    row->add_end();
    row->addWidget(start_);
    row->addWidget(stop_);
    return row;
}

TickBox* ProgramPage::switch_box(const char* name, const QString& text, const QString& hint,
                                 std::function<void(bool)> take) {
    auto* box = new TickBox{text};
    box->setObjectName(name);
    box->setFocusPolicy(Qt::TabFocus);
    box->setToolTip(hint);
    connect(box, &QCheckBox::toggled, this, [take = std::move(take)](bool is_on) { take(is_on); });
    return box;
}

QLayout* ProgramPage::make_switches() {
    program::RunSwitches& switches = context_.program.switches;
    single_ = switch_box("program_single", tr("Single block"), tr("Holds behind each block; Resume goes on"),
                         [this](bool is_on) { switch_single(is_on); });
    optional_ = switch_box("program_optional", tr("Optional stop"), tr("Holds at M1"),
                           [&switches](bool is_on) { switches.stops_at_optional = is_on; });
    delete_ = switch_box("program_delete", tr("Block delete"), tr("Leaves out blocks that begin with /"),
                         [this, &switches](bool is_on) {
                             if (std::exchange(switches.skips_deleted, is_on) != is_on) decode_again();
                         });
    dry_ = switch_box("program_dry", tr("Dry run"),
                      tr("Spindle off, heads outside the blank; table and Y go as they would"),
                      [&switches](bool is_on) { switches.is_dry = is_on; });
    from_line_ = new QSpinBox;
    ignore_wheel(from_line_);
    from_line_->setObjectName("program_from_line");
    from_line_->setAccessibleName(tr("Line to begin with"));
    from_line_->setRange(1, std::numeric_limits<int>::max());
    from_line_->setFixedWidth(kFromLineWidth_px);
    connect(from_line_, &QSpinBox::valueChanged, this, [this, &switches](int line) {
        if (switches.from_line != static_cast<std::uint32_t>(line)) context_.program.asks_for_start = false;
        switches.from_line = static_cast<std::uint32_t>(line);
    });
    auto* row = new FlowLayout;
    row->setSpacing(kGap);
    for (QWidget* part : {single_, optional_, delete_, dry_}) row->addWidget(part);
    auto* from = new QWidget;
    auto* beside = new QHBoxLayout{from};
    beside->setContentsMargins(0, 0, 0, 0);
    beside->addWidget(role_label("label", tr("From line")));
    beside->addWidget(from_line_);
    row->addWidget(from);
    rapids_ = new RapidOverride{context_};
    row->addWidget(rapids_);
    return row;
}

// While a program runs that one is meant, another process' one, too.
void ProgramPage::switch_single(bool is_on) {
    if (context_.program_report.status.is_running == 0) {
        context_.program.switches.is_single = is_on;
        return;
    }
    Command command{};
    command.kind = CommandKind::single;
    command.value = is_on ? 1.0 : 0.0;
    context_.machine.order(command, session::phrase("Single block"));
}

QLayout* ProgramPage::make_views() {
    auto* row = new FlowLayout;
    row->setSpacing(kSmallGap);
    auto* planes = new QButtonGroup{this};
    planes->setObjectName("program_plane");
    const QString names[] = {tr("R1 plane"), tr("R2 plane"), tr("Unrolled")};
    const char* const ids[] = {"program_plane_r1", "program_plane_r2", "program_plane_unrolled"};
    for (int i = 0; i < 3; ++i) {
        auto* button = page_button(ids[i], names[i]);
        button->setProperty("small", true);
        button->setCheckable(true);
        leave_room_for_bold(*button);
        planes->addButton(button, i);
        row->addWidget(button);
    }
    connect(planes, &QButtonGroup::idToggled, this, [this](int id, bool is_on) {
        if (!is_on) return;
        context_.program.plane = static_cast<std::uint8_t>(id);
        path_->show_plane(static_cast<ProgramPathView::Plane>(id));
    });
    planes->button(context_.program.plane)->setChecked(true);
    follow_ = new TickBox{tr("Follow the line")};
    follow_->setObjectName("program_follow");
    follow_->setFocusPolicy(Qt::TabFocus);
    follow_->setChecked(true);
    follow_->setToolTip(tr("Keeps the line that runs in sight"));
    connect(follow_, &QCheckBox::toggled, this, [this](bool is_on) { text_->set_following(is_on); });
    row->addWidget(follow_);
    text_->setMinimumHeight(kLeastText_px);
    text_->set_on_chosen([this](std::uint64_t line) {
        if (text_->running_line() == 0) path_->mark_line(line);
    });
    auto* drawn = new QVBoxLayout;
    drawn->setSpacing(kSmallGap);
    drawn->addLayout(row);
    drawn->addWidget(path_, 1);
    views_ = new QBoxLayout{QBoxLayout::LeftToRight};
    views_->setSpacing(kGap);
    views_->addWidget(text_, 3);
    views_->addLayout(drawn, 2);
    return views_;
}

void ProgramPage::make_problems() {
    problems_->setObjectName("program_problems");
    problems_->setAccessibleName(tr("What is wrong with the program; a click goes to the line"));
    problems_->setWordWrap(true);
    problems_->setFocusPolicy(Qt::TabFocus);
    problems_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    problems_->setMaximumHeight(kMostProblemsHeight_px);
    problems_->hide();
    connect(problems_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0) text_->go_to(problems_->item(row)->data(Qt::UserRole).toULongLong());
    });
}

void ProgramPage::choose_file() {
    const std::string wanted = WindowSettings{*context_.settings}.last_folder().toStdString();
    context_.presence.look_above(wanted);  // for the next time
    const std::string there = context_.presence.nearest_folder(wanted);
    const QString folder = there.empty() ? QDir::homePath() : QString::fromStdString(there);
    const QString path = ask_for_file(this, tr("Open a program"), folder, filters_of_programs());
    if (!path.isEmpty()) open_(path);
}

void ProgramPage::decode_again() {
    if (context_.program.path().empty()) return;
    context_.program.decode_again(context_.machine.view(), context_.machine_profile());
}

/// From a line on only once it was told what comes before it.
void ProgramPage::start() {
    program::ProgramDesk& desk = context_.program;
    if (program_start_lock(context_)) return refresh();
    if (desk.switches.from_line <= 1) {
        desk.start(context_.machine.view());
    } else {
        decode_again();
        desk.asks_for_start = true;
    }
    refresh();
}

void ProgramPage::set_theme(const Tokens& tokens) {
    text_->set_theme(tokens);
    path_->set_theme(tokens);
}

std::size_t ProgramPage::error_count() const {
    const auto& program = context_.program.program();
    return program ? static_cast<std::size_t>(program->problems.error_count()) : 0;
}

void ProgramPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    views_->setDirection(event->size().width() >= kLeastBesideEachOther_px ? QBoxLayout::LeftToRight
                                                                           : QBoxLayout::TopToBottom);
}

void ProgramPage::show_program() {
    program::ProgramDesk& desk = context_.program;
    name_->show_text(desk.path().empty() ? tr("No program is open.") : QString::fromStdString(desk.path()));
    text_->show_program(desk.program());
    path_->show_program(desk.program());
    problems_->clear();
    if (desk.program()) {
        const auto& all = desk.program()->problems;
        for (const auto* list : {&all.errors(), &all.warnings()}) {
            for (const gcode::Problem& problem : *list) {
                const session::Phrase place = session::phrase(
                    "Line %1, column %2", std::to_string(problem.line), std::to_string(problem.column));
                auto* item =
                    new QListWidgetItem{words(session::joined(place, problem_phrase(problem))), problems_};
                item->setData(Qt::UserRole, static_cast<qulonglong>(problem.line));
            }
        }
    }
    problems_->setVisible(problems_->count() > 0);
    // Never less than what was asked for: start_lock() says where the program ends.
    if (!desk.program()) return;
    const std::uint64_t most =
        std::max<std::uint64_t>(desk.program()->facts.line_count, desk.switches.from_line);
    from_line_->setMaximum(
        static_cast<int>(std::clamp<std::uint64_t>(most, 1, std::numeric_limits<int>::max())));
}

void ProgramPage::show_switches() {
    const program::ProgramDesk& desk = context_.program;
    // What is only shown is no wish of the operator's.
    const program::RunSwitches& shown = desk.shown_switches();
    const auto show = [](QAbstractButton& box, bool is_on) {
        const QSignalBlocker no_wish{box};
        box.setChecked(is_on);
    };
    const ProgramStatus& running = context_.program_report.status;
    // What was asked for is shown until it is answered.
    if (running.is_running == 0) {
        show(*single_, shown.is_single);
    } else if (!context_.machine.has_orders()) {
        show(*single_, running.is_single != 0);
    }
    show(*optional_, shown.stops_at_optional);
    show(*delete_, shown.skips_deleted);
    show(*dry_, shown.is_dry);
    // The text of a line that is being typed is left alone.
    if (const int line = static_cast<int>(shown.from_line); from_line_->value() != line) {
        const QSignalBlocker no_wish{from_line_};
        from_line_->setMaximum(std::max(from_line_->maximum(), line));
        from_line_->setValue(line);
    }
    for (QWidget* part : {static_cast<QWidget*>(single_), static_cast<QWidget*>(optional_),
                          static_cast<QWidget*>(delete_), static_cast<QWidget*>(dry_)}) {
        const QVariant hint = part->property("hint");
        if (!hint.isValid()) part->setProperty("hint", part->toolTip());
        const bool is_kept = desk.is_under_way() && (part != single_ || running.is_running == 0);
        lock_with(*part, is_kept ? tr("A program that runs keeps what it was started with") : QString{},
                  part->property("hint").toString());
    }
    from_line_->setEnabled(!desk.is_under_way() && desk.program() != nullptr);
}

void ProgramPage::show_buttons() {
    const program::ProgramDesk& desk = context_.program;
    start_->refresh(context_);
    stop_->refresh(context_);
    lock_with(*again_, desk.path().empty() ? tr("Decode: no program is open") : QString{},
              tr("Reads and judges the file once more, by the machine as it is now"));
    lock_with(*cancel_, desk.is_reading() ? QString{} : tr("Cancel: nothing is being read"));
    progress_->setVisible(desk.is_reading());
    if (desk.is_reading()) progress_->setValue(qRound(100.0 * desk.progress_ratio()));
}

void ProgramPage::show_running() {
    const ProgramStatus& status = context_.program_report.status;
    const bool is_marked = status.is_running != 0 && context_.program.is_shown(status);
    text_->mark_running(is_marked ? status.line : 0);
    path_->mark_line(is_marked ? status.line : text_->chosen_line());
}

void ProgramPage::refresh() {
    const program::ProgramDesk& desk = context_.program;
    if (shown_edition_ != desk.edition()) {
        shown_edition_ = desk.edition();
        show_program();
    }
    if (shown_text_edition_ != desk.text_edition()) text_->lines_changed();
    shown_text_edition_ = desk.text_edition();
    if (!isVisible()) return;
    show_buttons();
    show_switches();
    rapids_->refresh();
    const QString state = state_text();
    if (state_->text() != state) state_->setText(state);
    state_->setVisible(!state.isEmpty());
    const bool has_failed = desk.ended() && !desk.ended()->is_done && !desk.is_block();
    set_plain_tip(*state_, has_failed ? QString::fromStdString(desk.ended()->text) : QString{});
    set_styled(state_, "role", has_failed ? "problem" : "label");
    const QString modes = modes_text();
    if (modes_->text() != modes) modes_->setText(modes);
    modes_->setVisible(!modes.isEmpty());
    const QString facts = facts_text();
    if (facts_->text() != facts) facts_->setText(facts);
    set_plain_tip(*facts_, desk.program() && !facts.isEmpty()
                               ? QString::fromStdString(desk.program()->offsets_path)
                               : QString{});
    facts_->setVisible(!facts.isEmpty());
    set_styled(facts_, "role", desk.problem().is_empty() ? "label" : "problem");
    show_running();
    card_->refresh();
    mdi_->refresh();
}

}  // namespace psicarve::ui
