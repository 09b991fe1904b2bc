// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "shared/machine/signal.hpp"
#include "tests/rtcore/trace/trace_files.hpp"

namespace psicarve::trace {
namespace {

using SigrokTest = TraceFolder;

std::string output_of(const std::string& command) {
    std::string output;
    FILE* const pipe = popen(command.c_str(), "r");  // NOLINT(bugprone-command-processor): fixed command
    if (pipe == nullptr) return output;
    std::array<char, 4096> text{};
    while (const std::size_t count = std::fread(text.data(), 1, text.size(), pipe)) {
        output.append(text.data(), count);
    }
    pclose(pipe);
    return output;
}

TEST_F(SigrokTest, ReadsTheVcdAndCountsThePulses) {
    ASSERT_NE(output_of("sigrok-cli --version 2>/dev/null"), "")
        << "sigrok-cli is not installed: scripts/deps.sh test";
    const std::string file = path("steps.vcd");
    constexpr int kPulses = 25;
    {
        auto sut = open_trace(file, {.period_ns = 50'000}).value();
        const SignalWord on = bit_of(Signal::r1_enable) | bit_of(Signal::r1_dir);
        sut->add(pins(1, on));
        for (std::uint64_t i = 0; i < kPulses; ++i) {
            sut->add(pins(10 + 20 * i, on | bit_of(Signal::r1_step)));
            sut->add(pins(11 + 20 * i, on));
            if (i == 10) sut->add(position(12 + 20 * i, {11, 0, 0, 0}));
        }
        sut->finish(1'000);
    }
    const std::string decoded =
        output_of("sigrok-cli -I vcd:downsample=10000 -i '" + file +
                  "' -P stepper_motor:step=r1_step:dir=r1_dir -A stepper_motor=position 2>&1");
    EXPECT_NE(decoded.find("stepper_motor-1: 1 steps\n"), std::string::npos) << decoded;
    // The decoder says a position when the next pulse comes: it has the last but one.
    EXPECT_NE(decoded.find("stepper_motor-1: " + std::to_string(kPulses - 1) + " steps"), std::string::npos)
        << decoded;
}

}  // namespace
}  // namespace psicarve::trace
