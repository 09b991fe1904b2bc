// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/program/record_intake.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/shared/record_fixture.hpp"

namespace psicarve::test {

inline constexpr std::uint64_t kProgram = 7;

/// A program whose writer is this process, in a ring of our own, as it stands once the core has opened it.
class ProgramInMemory {
public:
    explicit ProgramInMemory(std::uint32_t capacity = kLeastRingRecords) : records_(capacity) {
        control_.claim.store((std::uint64_t{own_pid()} << 32U) | 1U);
        control_.running.store(kProgram);
    }
    ProgramControl& control() { return control_; }
    RecordRing ring() {
        RecordRing ring = records_.get();
        ring.ends = &control_.ends;
        return ring;
    }
    RingInMemory& records() { return records_; }
    ProgramFeed feed() {
        return {control_, ring(), {.claim = control_.claim.load(), .program = kProgram, .first = 0}};
    }
    void writer_dies() { control_.claim_start_time.store(1); }

private:
    ProgramControl control_{};
    RingInMemory records_;
};

/// Of the machine that `profile` tells of: at the middle of what both heads and Y have.
inline plan::Pulses4 middle_of(const Profile& profile) {
    plan::Pulses4 at{};
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        const AxisMotion motion = axis_motion(profile, axis);
        at[index_of(axis)] = (motion.travel_min_pulses + motion.travel_max_pulses) / 2;
    }
    return at;
}

}  // namespace psicarve::test
