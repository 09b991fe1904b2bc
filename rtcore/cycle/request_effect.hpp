// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/pin_trial.hpp"

namespace psicarve::cycle {

/// It moves an axis, powers an output or leaves an alarm: after a stop that its sender did not know of, it
/// must not be done. RT: yes.
constexpr bool sets_going(const Request& request) noexcept {
    switch (request.kind) {
        case RequestKind::home:
        case RequestKind::start:
        case RequestKind::start_interpolation:
        case RequestKind::resume:
        case RequestKind::reset_alarm:
        case RequestKind::back_off:
        case RequestKind::reset_height:
        case RequestKind::jog:
        case RequestKind::jog_on:
        case RequestKind::move:
        case RequestKind::run_program:
            return true;
        case RequestKind::spindle:
            return request.value != 0;
        case RequestKind::test_pin:
            return pin_order(request.value).is_on;
        case RequestKind::hold:
        case RequestKind::job_loaded:
        case RequestKind::override:
        case RequestKind::rapid_override:
        case RequestKind::single:
        case RequestKind::optional_stop:
        case RequestKind::fail:
        case RequestKind::end_jog:
        case RequestKind::record:
        case RequestKind::drives_off:
            break;
    }
    return false;
}

}  // namespace psicarve::cycle
