// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "rtcore/plan/program_step.hpp"
#include "rtcore/program/record_rules.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::program {

/// The core's trust boundary: takes the records of one program out of the ring, and gives a step only for one
/// that is whole, of this program, the next in order, and within what the machine can do. The first that is
/// not ends the program; what was given before stands. Planner's thread.
///
///     step ... step, `end` ──▶ ended ──a record comes all the same──▶ refused
///                 │
///                 ├─ the ring is empty ──writer there──▶ later
///                 │                    └─writer gone, or closed──▶ lost
///                 └─ a record is wrong ──▶ refused
class RecordIntake final : public plan::StepSource {
public:
    /// `start`: where all axes are before the program's first way.
    RecordIntake(ProgramFeed feed, const Profile& profile, const plan::Pulses4& start) noexcept
        : feed_(feed), rules_(profile), at_(start) {}

    void begin(const plan::Pulses4& start) noexcept override {
        at_ = start;
        rounded_off_pulses_ = {};
    }
    plan::Supply next(plan::ProgramStep& step) override;

    /// Waits until there may be something other than `later`, at most so long.
    void wait_for(std::chrono::nanoseconds limit) noexcept { (void)feed_.wait_for(limit); }
    std::uint64_t queued() noexcept { return feed_.queued(); }
    std::uint64_t program() const noexcept { return feed_.program(); }
    /// Sequence and line of the last record that was good; 0 before the first.
    std::uint64_t taken() const noexcept { return taken_; }
    std::uint64_t line() const noexcept { return line_; }
    /// Where all axes are after the last step given.
    const plan::Pulses4& position_pulses() const noexcept { return at_; }

    struct Refusal {
        std::uint64_t line;  ///< of the record; of the one before where it cannot be believed
        Message said;
    };
    /// Why `refused`, and where it was `lost`.
    const std::optional<Refusal>& refusal() const noexcept { return refusal_; }

private:
    plan::Supply take(RingAnswer answer, const MotionRecord& record, plan::ProgramStep& step);
    Message fault_of(RingAnswer answer, const MotionRecord& record, plan::ProgramStep& step) const noexcept;
    plan::Supply finish(plan::Supply how, std::uint64_t line, const Message& why);

    ProgramFeed feed_;
    RecordRules rules_;
    plan::Pulses4 at_;
    std::array<double, kAxisCount> rounded_off_pulses_{};  ///< as ProgramStep has it, of the last step
    std::uint64_t taken_ = 0;
    std::uint64_t line_ = 0;
    std::uint64_t record_sum_ = 0;            ///< with_record() over those taken
    plan::Supply over_ = plan::Supply::step;  ///< once it is ended, lost or refused
    std::optional<Refusal> refusal_;
};

}  // namespace psicarve::program
