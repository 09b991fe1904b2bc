// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/action_lock.hpp"

#include <string>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/preflight.hpp"

namespace psicarve::session {
namespace {

using S = MachineState;
using Lock = std::optional<Phrase>;

/// A program that is held for good.
bool is_broken_off(const MachineView& machine) noexcept {
    return machine.runs_program() && is_for_good(machine.program.hold);
}

/// Where a program runs, the words that differ from those of a job.
Lock motion_lock_of_program(const MachineView& machine) {
    if (is_broken_off(machine)) return phrase("Locked on hold: stop");
    if (machine.state() == S::carving || machine.state() == S::holding)
        return phrase("Locked while a program runs");
    return std::nullopt;
}

Lock start_lock_of_program(const MachineView& machine) {
    if (is_broken_off(machine)) return phrase("Start: on hold; only Stop is left");
    if (machine.state() == S::carving) return phrase("Start: a program runs");
    return std::nullopt;
}

/// The conditions of any motion from rest.
Lock motion_lock(const MachineView& machine) {
    if (machine.runs_program()) {
        if (Lock lock = motion_lock_of_program(machine)) return lock;
    }
    switch (machine.state()) {
        case S::alarm:
        case S::backing_off:
            return phrase("Locked until the alarm is reset");
        case S::homing:
            return phrase("Locked while the machine homes");
        case S::moving:
            return phrase("Locked while an axis moves");
        case S::stopping:
            return phrase("Locked while the machine stops");
        case S::held:
            return phrase("Locked on hold: resume or stop");
        case S::waiting:
            return phrase("Locked: the heads wait at the first point; start or stop");
        case S::positioning:
        case S::carving:
        case S::holding:
        case S::finishing:
            return phrase("Locked while carving");
        case S::testing:
            return phrase("Locked by the wiring test");
        case S::off:
        case S::ready:
            break;
    }
    return std::nullopt;
}

Lock jog_lock(const MachineView& machine) {
    if (const Lock lock = motion_lock(machine); lock && machine.state() != S::moving) return lock;
    if (machine.state() == S::off) return phrase("Jog: the machine is not homed");
    return std::nullopt;
}

Lock unhomed_lock(const MachineView& machine) {
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) return phrase("Start: axis %1 is not homed", axis_letter(axis));
    }
    if (machine.state() == S::off) return phrase("Start: the drives are off; home all axes");
    return std::nullopt;
}

Lock job_lock(const MachineView& machine, const OpenJobView& job) {
    if (job.state == OpenJobState::opening || job.state == OpenJobState::slicing)
        return phrase("Start: a job is being made");
    if (job.state == OpenJobState::publishing) return phrase("Start: the job is being published");
    if (job.state == OpenJobState::model) return phrase("Start: slice the model, then publish the job");
    if (job.state == OpenJobState::job) return phrase("Start: the job is not published");
    if (machine.status->job_generation == 0) return phrase("Start: no job is published");
    return std::nullopt;
}

/// The pre-flight checks that have no words of their own here.
Lock preflight_lock(const MachineView& machine, const OpenJobView& job) {
    for (const Check& check : preflight_checks(machine, job)) {
        if (check.verdict != Check::Verdict::fail) continue;
        Phrase lock = phrase("Start: pre-flight, %1: %2");
        lock.inner = {check.name, check.detail};
        return lock;
    }
    return std::nullopt;
}

Lock start_lock(const MachineView& machine, const OpenJobView& job) {
    if (machine.runs_program()) {
        if (Lock lock = start_lock_of_program(machine)) return lock;
    }
    switch (machine.state()) {
        case S::alarm:
        case S::backing_off:
            return phrase("Start: reset the alarm first");
        case S::held:
        case S::holding:
            return phrase("Start: on hold; resume or stop");
        case S::stopping:
            return phrase("Start: stopping");
        case S::positioning:
            return phrase("Start: the heads are on their way");
        case S::finishing:
            return phrase("Start: the heads are on their way out");
        case S::carving:
            return phrase("Start: already carving");
        case S::homing:
        case S::moving:
            return phrase("Start: the machine moves");
        case S::testing:
            return phrase("Start: an output is tested");
        case S::off:
        case S::ready:
            if (const Lock lock = unhomed_lock(machine)) return lock;
            if (const Lock lock = job_lock(machine, job)) return lock;
            break;
        case S::waiting:
            break;
    }
    return preflight_lock(machine, job);
}

Lock stop_lock(const MachineView& machine) {
    switch (machine.state()) {
        case S::off:
        case S::ready:
            return phrase("Stop: nothing is moving");
        case S::stopping:
            return phrase("Stop: already stopping");
        case S::alarm:
            return phrase("Stop: all axes are at rest");
        default:
            return std::nullopt;
    }
}

Lock override_lock(const MachineView& machine) {
    if (machine.state() == S::off || machine.state() == S::testing)
        return phrase("Feed override: the machine is not homed");
    if (machine.state() == S::alarm || machine.state() == S::backing_off)
        return phrase("Feed override: reset the alarm first");
    return std::nullopt;
}

Lock reset_lock(const MachineView& machine) {
    if (machine.state() == S::backing_off) return phrase("Reset alarm: an axis backs off its switch");
    if (machine.state() != S::alarm) return phrase("Reset alarm: there is no alarm");
    for (const Signal signal : kLimitSignals) {
        if (!machine.is_active(signal)) continue;
        const auto axis = static_cast<Axis>(index_of(signal) - index_of(sensor_of(Axis::r1)));
        return phrase("Switch %1 is still closed", axis_letter(axis));
    }
    if (machine.is_active(Signal::estop)) return phrase("The emergency stop switch is still pressed");
    return std::nullopt;
}

Lock back_off_lock(const MachineView& machine) {
    if (machine.state() != S::alarm) return phrase("Back off: there is no alarm");
    for (const Signal signal : kLimitSignals) {
        if (machine.is_active(signal)) return std::nullopt;
    }
    return phrase("Back off: no switch is closed");
}

Lock publish_lock(const MachineView& machine, const OpenJobView& job) {
    if (job.is_busy()) return phrase("Publish: a job is being made");
    if (!job.has_job()) return phrase("Publish: there is no job; slice the model first");
    if (job.state == OpenJobState::published) return phrase("Publish: this job is published");
    const S state = machine.state();
    if (state == S::off || state == S::ready) return std::nullopt;
    return phrase("Publish: the machine is busy");
}

Lock slice_lock(const OpenJobView& job) {
    if (job.is_busy()) return phrase("Slice: a job is being made");
    if (!job.can_be_sliced && job.has_job()) return phrase("Slice: this is a job, and already sliced");
    if (!job.can_be_sliced) return phrase("Slice: open a model first");
    return std::nullopt;
}

Lock hold_lock(const MachineView& machine) {
    const bool starves = machine.runs_program() && machine.program.hold == ProgramHold::starved;
    if (machine.state() == S::carving || starves) return std::nullopt;
    if (machine.state() == S::held || machine.state() == S::holding) return phrase("Hold: on hold already");
    return phrase("Hold: nothing is carved");
}

Lock resume_lock(const MachineView& machine) {
    if (is_broken_off(machine)) return phrase("Resume: nothing is left of the program; stop");
    if (machine.runs_program() && machine.program.hold == ProgramHold::starved)
        return phrase("Resume: the program goes on by itself when more of it comes");
    if (machine.state() == S::held || machine.state() == S::holding) return std::nullopt;
    return phrase("Resume: not on hold");
}

}  // namespace

std::optional<Phrase> lock_of(Action action, const MachineView& machine, const OpenJobView& job) {
    if (action == Action::slice) return slice_lock(job);
    if (machine.life == CoreLife::none) return phrase("No core serves the segment");
    if (!machine.is_heard() || !machine.status) return phrase("The core is silent");
    switch (action) {
        case Action::home:
            return motion_lock(machine);
        case Action::jog:
            return jog_lock(machine);
        case Action::start:
            return start_lock(machine, job);
        case Action::one_layer:
        case Action::from_layer:
            if (machine.state() == S::waiting)
                return phrase("The heads wait at the first point; start or stop");
            return start_lock(machine, job);
        case Action::hold:
            return hold_lock(machine);
        case Action::resume:
            return resume_lock(machine);
        case Action::stop:
            return stop_lock(machine);
        case Action::override_feed:
            return override_lock(machine);
        case Action::reset_alarm:
            return reset_lock(machine);
        case Action::back_off:
            return back_off_lock(machine);
        case Action::publish:
            return publish_lock(machine, job);
        case Action::slice:
            break;
    }
    return std::nullopt;
}

}  // namespace psicarve::session
