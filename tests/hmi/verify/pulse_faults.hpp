// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "tests/hmi/verify/perfect_machine.hpp"

namespace psicarve::verify {

/// Takes the n-th step pulse of an axis out of the trace, as a driver that misses it would.
inline void drop_pulse(PerfectMachine& machine, Axis axis, std::size_t n) {
    const SignalWord step = bit_of(step_of(axis));
    SignalWord before = 0;
    bool dropping = false;
    for (TraceEvent& event : machine.events) {
        const bool rises = (event.levels & step) != 0 && (before & step) == 0;
        before = event.levels;
        if (rises) dropping = n-- == 0;
        if (dropping) event.levels &= ~step;
    }
}

inline std::size_t pulses_before(const PerfectMachine& machine, Axis axis) {
    const SignalWord step = bit_of(step_of(axis));
    std::size_t count = 0;
    SignalWord before = 0;
    for (const TraceEvent& event : machine.events) {
        if ((event.levels & step) != 0 && (before & step) == 0) ++count;
        before = event.levels;
    }
    return count;
}

}  // namespace psicarve::verify
