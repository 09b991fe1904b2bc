// SPDX-License-Identifier: GPL-3.0-or-later
// How page Program wants its program to be run.
#include "hmi/ui/program_page.hpp"

#include <QHBoxLayout>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/rapid_override.hpp"
#include "hmi/ui/tick_box.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kFromLineWidth_px = 110;

}  // namespace

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
                           [this](bool is_on) { switch_optional_stop(is_on); });
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

void ProgramPage::order_switch(CommandKind kind, bool is_on, const session::Phrase& name) {
    Command command{};
    command.kind = kind;
    command.value = is_on ? 1.0 : 0.0;
    context_.machine.order(command, name);
}

// While a program runs that one is meant, whoever has started it.
void ProgramPage::switch_single(bool is_on) {
    if (context_.program_report.status.is_running == 0) {
        context_.program.switches.is_single = is_on;
        return;
    }
    order_switch(CommandKind::single, is_on, session::phrase("Single block"));
}

void ProgramPage::switch_optional_stop(bool is_on) {
    if (context_.program_report.status.is_running == 0) {
        context_.program.switches.stops_at_optional = is_on;
        return;
    }
    order_switch(CommandKind::optional_stop, is_on, session::phrase("Optional stop"));
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
        show(*optional_, shown.stops_at_optional);
    } else if (!context_.machine.has_orders()) {
        show(*single_, running.is_single != 0);
        show(*optional_, running.stops_at_optional != 0);
    }
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
        const bool acts_at_once = (part == single_ || part == optional_) && running.is_running != 0;
        const bool is_kept = desk.is_under_way() && !acts_at_once;
        lock_with(*part, is_kept ? tr("A program that runs keeps what it was started with") : QString{},
                  part->property("hint").toString());
    }
    from_line_->setEnabled(!desk.is_under_way() && desk.program() != nullptr);
}

}  // namespace psicarve::ui
