// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/pulse_stage.hpp"

namespace psicarve::cycle {

/// The DDA iterations of a line or a path segment. Each is made when it is due, and held until every axis in
/// it may step: so all its pulses begin in one tick. RT: yes.
class Iterations {
public:
    /// The block's own line.
    void start(const MotionBlock& block) noexcept {
        held_axes_ = 0;
        dda_.start(block.delta_pulses);
    }
    /// A path segment: a part of the longer line that the block names, or a line of its own.
    void start_segment(const MotionBlock& block) noexcept {
        held_axes_ = 0;
        std::array<std::int64_t, kAxisCount> line{};
        std::int64_t longest = 0;
        std::int64_t count = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            line[k] = block.line_pulses[k];
            longest = std::max(longest, std::abs(line[k]));
            count = std::max(count, std::abs(block.delta_pulses[k]));
        }
        if (block.line_done >= 0 && longest > 0 && block.line_done + count <= longest) {
            dda_.start_within(line, block.line_done, count);
        } else {
            dda_.start(block.delta_pulses);
        }
    }

    /// Not made yet.
    std::int64_t left() const noexcept { return dda_.iterations_left(); }
    bool is_held() const noexcept { return held_axes_ != 0; }
    /// All of them are made and out.
    bool are_done() const noexcept { return left() == 0 && !is_held(); }

    /// The next one is due. Requires left() > 0, and that none is held.
    void make() noexcept { held_axes_ = dda_.iterate(); }
    /// Requires is_held(). True: its pulses begin now, but for those of `still_axes`, which are not sent.
    /// False: the pins are not ready, and it stays held.
    bool emit(PulseStage& pulses, std::uint64_t tick, std::uint32_t still_axes) noexcept {
        if (!pulses.may_step(held_axes_, tick)) return false;
        pulses.step(held_axes_ & ~still_axes, tick);
        held_axes_ = 0;
        return true;
    }

private:
    DualHeadDda dda_;
    std::uint32_t held_axes_ = 0;
};

}  // namespace psicarve::cycle
