// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/approach_card.hpp"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "hmi/profile/pin_rows.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/program_ground.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kPlaceDecimals = 3;

QString names_of_outputs(SwitchedOutputs outputs) {
    QStringList names;
    for (std::size_t k = kFirstSwitchedOutput; k < kSignalCount; ++k) {
        const auto signal = static_cast<Signal>(k);
        if ((levels_of(outputs) & bit_of(signal)) != 0) names += words(session::name_of_signal(signal));
    }
    return names.join(", ");
}

QString number_of_place(const gcode::Approach& approach, Axis axis) {
    return QString::fromStdString(session::number_text(approach.place[index_of(axis)], kPlaceDecimals));
}

}  // namespace

ApproachCard::ApproachCard(WindowContext& context, QWidget* parent)
    : QFrame(parent),
      context_(context),
      title_(role_label("title")),
      told_(plain_label()),
      confirm_(new ActionButton{program_start_lock, tr("Confirm and start"), [this] { start(); }}) {
    setObjectName("approach_card");
    setProperty("notice", true);
    title_->setObjectName("approach_title");
    title_->setWordWrap(true);
    told_->setObjectName("approach_told");
    told_->setWordWrap(true);
    confirm_->setObjectName("approach_confirm");
    auto* back = new QPushButton{tr("Not now")};
    back->setObjectName("approach_back");
    back->setFocusPolicy(Qt::TabFocus);
    connect(back, &QPushButton::clicked, this, [this] {
        context_.program.asks_for_start = false;
        refresh();
    });
    auto* buttons = new FlowLayout;
    buttons->setSpacing(kGap);
    buttons->addWidget(confirm_);
    buttons->addWidget(back);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kSmallGap);
    all->addWidget(title_);
    all->addWidget(told_);
    all->addLayout(buttons);
    hide();
}

/// What was told must still hold.
void ApproachCard::start() {
    program::ProgramDesk& desk = context_.program;
    const bool is_true = desk.program() && !desk.is_reading() &&
                         is_read_as_it_is(*desk.program(), context_.machine.view(), desk.switches);
    if (is_true && !program_start_lock(context_)) desk.start(context_.machine.view());
    refresh();
}

QString ApproachCard::told(const program::Decoded& program) const {
    const gcode::Approach& approach = program.approach;
    const bool is_dry = context_.program.switches.is_dry;
    QStringList steps;
    const bool is_spindle_on = context_.machine.view().is_active(Signal::spindle);
    if (!approach.is_needed() && !is_dry) steps += tr("Nothing before this line moves anything.");
    if (is_spindle_on) {
        steps += tr("The spindle is on and stays on.");
    } else if (approach.is_spindle_on && !is_dry) {
        steps += tr("The spindle goes on.");
    }
    if (approach.outputs_on != 0 && !is_dry)
        steps += tr("These outputs go on: %1.").arg(names_of_outputs(approach.outputs_on));
    if (approach.placed != 0 || is_dry) {
        steps += tr("Both heads go out to the end of their travel.");
        // How far depends on where it comes from.
        if (approach.brings(Axis::psi) && program.request.profile.gcode.turns_shortest)
            steps += tr("Ψ turns.");
        else if (approach.brings(Axis::psi))
            steps += tr("Ψ turns to %1°, all turns.").arg(number_of_place(approach, Axis::psi));
        if (approach.brings(Axis::y)) steps += tr("Y goes to %1 mm.").arg(number_of_place(approach, Axis::y));
        QStringList heads;
        for (const Axis axis : {Axis::r1, Axis::r2}) {
            if (!approach.brings(axis)) continue;
            heads +=
                (axis == Axis::r1 ? tr("R1 %1 mm") : tr("R2 %1 mm")).arg(number_of_place(approach, axis));
        }
        if (!heads.isEmpty() && !is_dry) steps += tr("The heads come in: %1.").arg(heads.join(", "));
        if (is_dry) steps += tr("The heads stay out (dry run).");
    }
    if (!is_spindle_on && (!approach.is_spindle_on || is_dry))
        steps += tr("The spindle stays off until the program turns it on.");
    return steps.join('\n');
}

void ApproachCard::refresh() {
    program::ProgramDesk& desk = context_.program;
    const auto& read = desk.program();
    const bool is_there = desk.asks_for_start && read && !desk.is_reading();
    const bool is_true = is_there && is_read_as_it_is(*read, context_.machine.view(), desk.switches);
    if (is_there && !is_true && !program::machine_lock(program_ground(context_))) {
        desk.decode_again(context_.machine.view(), context_.machine_profile());
    } else if (is_true && !read->is_right()) {
        desk.asks_for_start = false;
    }
    const bool is_shown = desk.asks_for_start && is_true && !desk.is_reading();
    if (is_shown) {
        title_->setText(tr("Run from line %1: first the machine does this").arg(desk.switches.from_line));
        const QString text = told(*read);
        if (told_->text() != text) told_->setText(text);
        confirm_->refresh(context_);
    }
    setVisible(is_shown);
}

}  // namespace psicarve::ui
