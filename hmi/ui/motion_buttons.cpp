// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/motion_buttons.hpp"

#include <QApplication>
#include <QCoreApplication>

#include <cstdint>

#include "hmi/session/going_on.hpp"
#include "hmi/ui/disk_piece_dialog.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MotionButtons)
};

void start_what_is_said(WindowContext& context) {
    const session::RunKind kind = context.wanted_run;  // whatever is chosen while it is asked
    const session::StartPlace from = place_to_begin_with(context).value_or(session::StartPlace{});
    const bool waits = context.machine.view().state() == MachineState::waiting;
    const bool carves = kind == session::RunKind::carve && from.layer != 0 && !waits;
    if (!carves || asked_to_go_on_from_disk(context, from.layer, QApplication::activeWindow()))
        context.machine.start(from, 0, kind);
}

/// In two lines where the button is too narrow for one.
void say_fitting(ActionButton& button, const QString& text) {
    constexpr const char* kSaid = "said";
    constexpr const char* kSaidIn_px = "said_in_px";
    const int width_px = button.isVisible() ? button.width() : 0;
    if (button.property(kSaid).toString() == text && button.property(kSaidIn_px).toInt() == width_px) return;
    button.setProperty(kSaid, text);
    button.setProperty(kSaidIn_px, width_px);
    const QKeySequence keys = button.shortcut();  // a new text would take it away
    button.setText(text);
    const bool is_too_long = width_px > 0 && button.sizeHint().width() > width_px;
    if (is_too_long) button.setText(QString{text}.replace(QStringLiteral(", "), QStringLiteral(",\n")));
    button.setShortcut(keys);
    set_styled(&button, "lines", is_too_long ? "two" : "one");
}

QString hint_of(const session::StartPlace& from) {
    if (!from.point) {
        return Words::tr("Heads out, to the first point of layer %1, then carve what is left (Ctrl+Enter)")
            .arg(from.layer + 1);
    }
    return Words::tr("Heads out, to point %2 of layer %1, then carve what is left (Ctrl+Enter)")
        .arg(from.layer + 1)
        .arg(*from.point + 1);
}

}  // namespace

std::optional<session::StartPlace> place_to_begin_with(const WindowContext& context) {
    return session::place_to_begin_with(context.machine.view(), context.open_job.view(),
                                        context.wanted_run == session::RunKind::dry);
}

MotionButtons make_motion_buttons(WindowContext& context) {
    using session::Action;
    session::MachineSession& machine = context.machine;
    const auto asks = [&machine](CommandKind kind, const char* name) {
        return [&machine, kind, name] { machine.order(kind, session::Phrase{name}); };
    };
    const MotionButtons made{
        new ActionButton{Action::start, Words::tr("Start"), [&context] { start_what_is_said(context); }},
        new ActionButton{Action::hold, Words::tr("Hold"), asks(CommandKind::hold, "Hold")},
        new ActionButton{Action::resume, Words::tr("Resume"), asks(CommandKind::resume, "Resume")},
        new ActionButton{Action::stop, Words::tr("Stop"), [&machine] { machine.stop(); }}};
    // What it says may be longer than there is room for in one line.
    made.start->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    made.hold->set_hint(Words::tr("Slows down along the path and stands on it (Pause, Esc)"));
    made.resume->set_hint(Words::tr("Goes on where it stands (Pause)"));
    made.stop->set_hint(Words::tr("Ends the job or program: heads out, spindle off (Shift+Esc)"));
    return made;
}

QString why_locked(const MotionButtons& buttons) {
    const QString start = buttons.start->reason();
    if (!start.isEmpty() || buttons.stop->isEnabled()) return start;
    return Words::tr("Hold, Resume, Stop: nothing is moving.");
}

QString said_beside(const MotionButtons& buttons, const QString& to_look_at) {
    return buttons.start->isEnabled() && !to_look_at.isEmpty()
               ? Words::tr("To be looked at before Start: %1").arg(to_look_at)
               : why_locked(buttons);
}

void show_what_starts(ActionButton& start, const WindowContext& context) {
    const session::MachineView& view = context.machine.view();
    const bool waits = view.is_heard() && view.state() == MachineState::waiting;
    const bool is_dry = waits ? view.status->is_dry != 0 : context.wanted_run == session::RunKind::dry;
    const auto from = place_to_begin_with(context);
    const QString text = words(session::start_text(view, context.open_job.view(), is_dry));
    say_fitting(start, text);
    start.set_hint(is_dry  ? Words::tr("Table and Y go as they would, heads outside the blank, spindle off "
                                        "(Ctrl+Enter)")
                   : waits ? Words::tr("Carves from the point where the heads wait (Ctrl+Enter)")
                   : from  ? hint_of(*from)
                           : Words::tr("Heads to the first point, then carve (Ctrl+Enter)"));
}

}  // namespace psicarve::ui
