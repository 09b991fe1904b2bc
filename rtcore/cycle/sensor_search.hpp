// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {

/// The sensor that a move looks for, in homing and backing off, and whether it has answered: it trips, it
/// does not trip any more, or an index begins to trip. The inputs outlive it. RT: yes.
class SensorSearch {
public:
    explicit SensorSearch(const Inputs& inputs) noexcept : inputs_(&inputs) {}

    /// A motion begins with this block, whether or not it looks for a sensor.
    void begin(const MotionBlock& block) noexcept {
        axis_ = block.axis;
        until_ = block.until;
        homing_axis_ = block.is_homing != 0 ? block.axis : kNoAxis;
        has_answered_ = false;
        was_tripped_ = inputs_->is_tripped(axis_);
    }
    /// No axis is being homed any more.
    void end_homing() noexcept { homing_axis_ = kNoAxis; }

    /// The motion at hand looks for a sensor.
    bool is_on() const noexcept { return until_ != Until::none; }
    /// Requires is_on(); every tick of the motion. True once: in the tick in which the sensor answers.
    bool watch() noexcept;
    bool has_answered() const noexcept { return has_answered_; }
    /// It is tripped, and its filter does not believe it yet: the answer may still come without any way.
    bool may_answer() const noexcept {
        return until_ == Until::sensor_tripped && inputs_->is_raw_tripped(axis_);
    }
    /// Where the axis stood when its sensor's level changed.
    std::int64_t edge_position() const noexcept { return inputs_->edge_position(axis_); }

    /// The axis whose sensor may trip without an alarm, or kNoAxis: from its first homing block until another
    /// axis' block or end_homing(), so that no tick between two blocks sees it as a limit.
    std::uint8_t homing_axis() const noexcept { return homing_axis_; }

private:
    const Inputs* inputs_;
    std::uint8_t axis_ = 0;
    Until until_ = Until::none;
    std::uint8_t homing_axis_ = kNoAxis;
    bool has_answered_ = false;
    bool was_tripped_ = false;
};

}  // namespace psicarve::cycle
