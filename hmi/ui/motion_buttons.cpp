// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/motion_buttons.hpp"

#include <QCoreApplication>

namespace psicarve::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MotionButtons)
};

}  // namespace

MotionButtons make_motion_buttons(Bench& bench) {
    using session::Action;
    session::MachineSession& machine = bench.machine;
    const auto asks = [&machine](CommandKind kind, const char* name) {
        return [&machine, kind, name] { machine.order(kind, session::Phrase{name}); };
    };
    return {new ActionButton{Action::start, Words::tr("Start"), [&machine] { machine.start(0); }},
            new ActionButton{Action::hold, Words::tr("Hold"), asks(CommandKind::hold, "Hold")},
            new ActionButton{Action::resume, Words::tr("Resume"), asks(CommandKind::resume, "Resume")},
            new ActionButton{Action::stop, Words::tr("Stop"), [&machine] { machine.stop(); }}};
}

}  // namespace psicarve::ui
