// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/machine_state.hpp"

#include <array>

namespace psicarve {
namespace {

using S = MachineState;
using E = MachineEvent;

struct Transition {
    MachineState from;
    MachineEvent event;
    MachineState to;
};

// Every legal pair but for `fail` and `stop`, which have a meaning in every state.
constexpr std::array kTransitions{
    Transition{S::off, E::home, S::homing},
    Transition{S::off, E::reset_height, S::homing},
    Transition{S::off, E::begin_test, S::testing},
    Transition{S::testing, E::begin_test, S::testing},
    Transition{S::testing, E::end_test, S::off},

    Transition{S::homing, E::home_done, S::ready},
    Transition{S::homing, E::home_done_unhomed, S::off},

    Transition{S::ready, E::home, S::homing},
    Transition{S::ready, E::reset_height, S::homing},
    Transition{S::ready, E::move, S::moving},
    Transition{S::ready, E::start, S::positioning},
    Transition{S::ready, E::drives_off, S::off},
    Transition{S::ready, E::run_program, S::carving},

    Transition{S::moving, E::move_done, S::ready},

    Transition{S::positioning, E::positioned, S::waiting},
    Transition{S::waiting, E::start_interpolation, S::carving},

    Transition{S::carving, E::hold, S::holding},
    Transition{S::carving, E::last_point_done, S::finishing},
    Transition{S::carving, E::program_done, S::ready},
    Transition{S::holding, E::at_rest, S::held},
    Transition{S::holding, E::resume, S::carving},
    Transition{S::held, E::resume, S::carving},

    Transition{S::finishing, E::finished, S::ready},

    Transition{S::stopping, E::at_rest, S::stopping},
    Transition{S::stopping, E::stopped, S::ready},
    Transition{S::stopping, E::stopped_unhomed, S::off},

    Transition{S::alarm, E::reset_alarm_unhomed, S::off},
    Transition{S::alarm, E::reset_alarm_homed, S::ready},
    Transition{S::alarm, E::back_off, S::backing_off},
    Transition{S::backing_off, E::back_off_done, S::alarm},
};

constexpr MachineState state_after_stop(MachineState from) noexcept {
    switch (from) {
        case S::homing:
        case S::moving:
        case S::positioning:
        case S::waiting:
        case S::carving:
        case S::holding:
        case S::held:
        case S::finishing:
            return S::stopping;
        case S::backing_off:
            return S::alarm;  // one axis at home speed: it simply stops
        case S::testing:
            return S::off;
        case S::off:
        case S::ready:
        case S::stopping:
        case S::alarm:
            break;
    }
    return from;
}

}  // namespace

std::optional<MachineState> next_state(MachineState from, MachineEvent event) noexcept {
    if (event == E::fail) return S::alarm;
    if (event == E::stop) return state_after_stop(from);
    for (const Transition& transition : kTransitions) {
        if (transition.from == from && transition.event == event) return transition.to;
    }
    return std::nullopt;
}

bool is_at_rest(MachineState state) noexcept {
    return state == S::off || state == S::ready || state == S::waiting || state == S::held ||
           state == S::alarm;
}

bool runs_job(MachineState state) noexcept {
    return state == S::positioning || state == S::waiting || state == S::carving || state == S::holding ||
           state == S::held || state == S::finishing || state == S::stopping;
}

}  // namespace psicarve
