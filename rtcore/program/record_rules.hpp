// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/program_step.hpp"
#include "shared/message/message.hpp"
#include "shared/profile/profile.hpp"
#include "shared/program/motion_record.hpp"

namespace psicarve::program {

inline constexpr double kMostSeconds = kMostRecordSeconds;
/// No machine is so large that a path could pass further from its points.
inline constexpr double kMostTolerance_mm = 1000.0;

/// What a machine, by its profile, makes of one motion record: a step in pulses, or the reason why not. The
/// limits are those of jobs and of moves by hand. Whether the record comes in its turn is not asked here.
class RecordRules {
public:
    explicit RecordRules(const Profile& profile);

    /// `at`: where all axes are before it. No message: the record is good, and `step` is what it asks for.
    /// Otherwise `step` is not to be used. Of axes that the record does not name nothing was rounded off.
    Message judge(const MotionRecord& record, const plan::Pulses4& at,
                  plan::ProgramStep& step) const noexcept;

private:
    Message judge_way(const MotionRecord& record, const plan::Pulses4& at,
                      plan::ProgramStep& step) const noexcept;
    Message judge_stepped(const MotionRecord& record, const plan::Pulses4& at,
                          plan::ProgramStep& step) const noexcept;
    Message judge_arc(const MotionRecord& record, const plan::Pulses4& at,
                      plan::ProgramStep& step) const noexcept;
    Message judge_outputs(const MotionRecord& record) const noexcept;
    Message judge_place(std::uint64_t line, Axis axis, std::int64_t position) const noexcept;
    Message judge_tips(std::uint64_t line, const plan::Pulses4& at, const plan::Pulses4& to) const noexcept;
    double pulses_of(Axis axis, double position) const noexcept;
    double tips_apart_mm(const plan::Pulses4& at) const noexcept;

    std::array<AxisMotion, kAxisCount> axes_;
    SwitchedOutputs wired_outputs_;
    std::array<std::int64_t, 2> core_pulses_;  ///< by head, counted
    double pulses_per_rev_;
    double tips_mm_;       ///< both tips stand this much further out than counted
    double clearance_mm_;  ///< of the tips
    double rounding_mm_;   ///< half a pulse of each head: a radius stands at its nearest one
};

}  // namespace psicarve::program
