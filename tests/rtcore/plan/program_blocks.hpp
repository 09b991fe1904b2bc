// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "rtcore/plan/record_program.hpp"
#include "tests/rtcore/plan/scripted_source.hpp"

namespace psicarve::plan::test {

inline constexpr Pulses4 kStartPulses{6000, 6200, 100, 3000};

inline std::vector<cycle::MotionBlock> program_blocks(const std::vector<ProgramStep>& steps,
                                                      bool is_single = false, const Profile& profile = {},
                                                      Supply at_the_end = Supply::ended) {
    RecordProgram program(machine_limits(profile), std::make_shared<ScriptedSource>(steps, at_the_end),
                          kStartPulses, is_single);
    std::vector<cycle::MotionBlock> blocks;
    cycle::MotionBlock block;
    while (program.next(block)) blocks.push_back(block);
    EXPECT_FALSE(program.is_waiting());
    return blocks;
}

inline double block_seconds(const cycle::MotionBlock& block, std::size_t timing) {
    return 2.0 * block.path.length /
           (std::sqrt(block.path.start_speed2[timing]) + std::sqrt(block.path.end_speed2[timing]));
}

}  // namespace psicarve::plan::test
