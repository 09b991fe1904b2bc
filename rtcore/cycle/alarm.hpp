// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/machine/status.hpp"

namespace psicarve::cycle {

/// Why the machine is in an alarm, and for what it slows down before it goes into one. RT: yes.
class Alarm {
public:
    /// `axis` may be kNoAxis.
    void raise(AlarmCause cause, std::uint8_t axis) noexcept {
        cause_ = cause;
        axis_ = axis;
        awaited_ = AlarmCause::none;
    }
    void reset() noexcept {
        cause_ = AlarmCause::none;
        axis_ = kNoAxis;
    }
    /// none: there is no alarm.
    AlarmCause cause() const noexcept { return cause_; }
    std::uint8_t axis() const noexcept { return axis_; }

    /// The machine slows down; once it rests, this is to be raised.
    void await_rest(AlarmCause cause) noexcept { awaited_ = cause; }
    /// The plan that slowed down is dropped, and with it what was awaited.
    void forget_awaited() noexcept { awaited_ = AlarmCause::none; }
    /// none: nothing is awaited.
    AlarmCause awaited() const noexcept { return awaited_; }

private:
    AlarmCause cause_ = AlarmCause::none;
    std::uint8_t axis_ = kNoAxis;
    AlarmCause awaited_ = AlarmCause::none;
};

}  // namespace psicarve::cycle
