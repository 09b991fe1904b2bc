// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/approach_card.hpp"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/program_ground.hpp"

namespace psicarve::ui {
namespace {

constexpr int kPlaceDecimals = 3;

QString number_of_place(const program::Approach& approach, Axis axis) {
    return QString::fromStdString(session::number_text(approach.place[index_of(axis)], kPlaceDecimals));
}

bool is_brought(const program::Approach& approach, Axis axis) {
    return (approach.placed >> index_of(axis) & 1U) != 0;
}

}  // namespace

ApproachCard::ApproachCard(WindowContext& context, QWidget* parent)
    : QFrame(parent),
      context_(context),
      title_(role_label("title")),
      told_(plain_label()),
      confirm_(new ActionButton{program_start_lock, tr("Confirm and start"),
                                [this] { context_.program.start(context_.machine.view()); }}) {
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

QString ApproachCard::told(const program::Decoded& program) const {
    const program::Approach& approach = program.approach;
    const bool is_dry = context_.program.switches.is_dry;
    QStringList steps;
    if (!approach.is_needed()) steps += tr("Nothing before this line moves anything.");
    if (approach.is_spindle_on && !is_dry) steps += tr("The spindle goes on.");
    if (approach.placed != 0) {
        steps += tr("Both heads go out to the end of their travel.");
        if (is_brought(approach, Axis::psi))
            steps += tr("Ψ turns to %1°, all turns.").arg(number_of_place(approach, Axis::psi));
        if (is_brought(approach, Axis::y))
            steps += tr("Y goes to %1 mm.").arg(number_of_place(approach, Axis::y));
        QStringList heads;
        for (const Axis axis : {Axis::r1, Axis::r2}) {
            if (!is_brought(approach, axis)) continue;
            heads +=
                (axis == Axis::r1 ? tr("R1 %1 mm") : tr("R2 %1 mm")).arg(number_of_place(approach, axis));
        }
        if (!heads.isEmpty() && !is_dry) steps += tr("The heads come in: %1.").arg(heads.join(", "));
        if (is_dry) steps += tr("The heads stay out (dry run).");
    }
    if (!approach.is_spindle_on || is_dry)
        steps += tr("The spindle stays off until the program turns it on.");
    return steps.join('\n');
}

void ApproachCard::refresh() {
    program::ProgramDesk& desk = context_.program;
    const auto& read = desk.program();
    const bool is_of_line = read && read->request.from_line == desk.switches.from_line && !desk.is_reading();
    const bool is_shown = desk.asks_for_start && is_of_line && read->is_right();
    if (is_shown) {
        title_->setText(tr("Run from line %1: first the machine does this").arg(desk.switches.from_line));
        const QString text = told(*read);
        if (told_->text() != text) told_->setText(text);
        confirm_->refresh(context_);
    }
    setVisible(is_shown);
}

}  // namespace psicarve::ui
