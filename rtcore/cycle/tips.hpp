// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// Where the tips are, counted from their motors' pulses: a pulse that only crosses a screw's gap moves none.
/// The tip rests against the flank that pushes it; at first that is the one that pushes it up. RT: yes.
class Tips {
public:
    explicit Tips(const CycleConfig& config) noexcept {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            backlash_[k] = config.axes[k].backlash_pulses;
            has_backlash_ = has_backlash_ || backlash_[k] > 0;
        }
    }

    /// A pulse of this motor, up or down.
    void count_pulse(std::size_t axis, bool up) noexcept {
        if (take_up_pulses(axis, up) > 0) {
            slack_[axis] += up ? -1 : 1;
        } else {
            position_[axis] += up ? 1 : -1;
        }
    }
    /// The tip stays where it is, and that is called so from now on; the gap stays as it is, too.
    void set_position(std::size_t axis, std::int64_t position_pulses) noexcept {
        position_[axis] = position_pulses;
    }

    /// So many pulses upwards (or down) go by before the flank is there that pushes it that way.
    void rest_before(std::size_t axis, bool up, std::int64_t left_pulses) noexcept {
        const std::int64_t left = std::clamp<std::int64_t>(left_pulses, 0, backlash_[axis]);
        slack_[axis] = up ? left : backlash_[axis] - left;
    }

    const std::array<std::int64_t, kAxisCount>& positions() const noexcept { return position_; }
    /// Of each gap, downwards: 0 with the tip against the flank that pushes it up, all of it against the
    /// other.
    const std::array<std::int64_t, kAxisCount>& crossed_pulses() const noexcept { return slack_; }
    /// Some screw has a gap.
    bool has_backlash() const noexcept { return has_backlash_; }
    /// Pulses upwards (or down) that go by before the tip follows.
    std::int64_t take_up_pulses(std::size_t axis, bool up) const noexcept {
        return up ? slack_[axis] : backlash_[axis] - slack_[axis];
    }

private:
    std::array<std::int64_t, kAxisCount> position_{};
    std::array<std::int64_t, kAxisCount> backlash_{};
    std::array<std::int64_t, kAxisCount> slack_{};  ///< of the gap, crossed downwards
    bool has_backlash_ = false;
};

}  // namespace psicarve::cycle
