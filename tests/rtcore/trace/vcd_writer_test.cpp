// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/vcd_writer.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/places.hpp"
#include "tests/rtcore/trace/trace_files.hpp"

namespace psicarve::trace {
namespace {

using VcdWriterTest = TraceFolder;

TEST_F(VcdWriterTest, StoryIsTheGoldenFileByteForByte) {
    const std::string file = path("story.vcd");
    {
        auto sut = open_trace(file, kStoryStart).value();
        tell_short_story([&](const TraceEntry& entry) { sut->add(entry); });
        sut->finish(kStoryEndTick);
        EXPECT_FALSE(sut->take_error());
    }
    const std::string golden = content(in_source("tests/data/golden/short_story.vcd"));
    ASSERT_FALSE(golden.empty());
    EXPECT_EQ(content(file), golden);
}

TEST_F(VcdWriterTest, NamesEverySignalOfTheMachine) {
    const std::string file = path("names.vcd");
    { open_trace(file, {.period_ns = 50'000}).value()->finish(0); }
    const std::string text = content(file);
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto name = std::string(name_of(static_cast<Signal>(i)));
        EXPECT_NE(text.find(" " + name + " $end\n"), std::string::npos) << name;
    }
    EXPECT_EQ(text.find("$date"), std::string::npos);
}

TEST_F(VcdWriterTest, SaysPositionsAgainOnlyWhenTheyDifferFromThePulses) {
    const std::string file = path("same.vcd");
    {
        auto sut =
            open_trace(file, {.period_ns = 10'000, .levels = 0, .position_pulses = {5, 6, 7, 8}}).value();
        const SignalWord on = bit_of(Signal::r1_enable) | bit_of(Signal::r2_enable) | bit_of(Signal::r2_dir);
        sut->add(pins(1, on));
        sut->add(pins(2, on | kStepMask));
        sut->add(pins(3, on));
        sut->add(position(4, {4, 7, 7, 8}));
        sut->finish(9);
    }
    const std::string text = content(file);
    EXPECT_EQ(text.find("position_pulses"), text.rfind("position_pulses")) << text;
    EXPECT_LT(text.find("position_pulses"), text.find("$enddefinitions"));
    EXPECT_EQ(text.find("#40000"), std::string::npos);
}

TEST_F(VcdWriterTest, TellsCrossedGapsBesideThePositionsOnlyWhereThereAreSome) {
    { open_trace(path("none.vcd"), {.period_ns = 10'000}).value()->finish(1); }
    EXPECT_EQ(content(path("none.vcd")).find("crossed"), std::string::npos);
    {
        open_trace(path("some.vcd"), {.period_ns = 10'000, .crossed_pulses = {0, 40, 0, 1}})
            .value()
            ->finish(1);
    }
    EXPECT_NE(content(path("some.vcd"))
                  .find("$comment position_pulses r1=0 r2=0 psi=0 y=0 $end\n"
                        "$comment crossed_pulses r1=0 r2=40 psi=0 y=1 $end\n$enddefinitions $end\n"),
              std::string::npos);
}

TEST_F(VcdWriterTest, TimesNeverRepeat) {
    const std::string file = path("times.vcd");
    {
        auto sut = open_trace(file, {.period_ns = 10'000}).value();
        sut->add(pins(0, 1));
        sut->add(pins(4, 3));
        sut->add(position(4, {1, 2, 3, 4}));
        sut->add(pins(4, 2));
        sut->finish(4);
    }
    const std::string text = content(file);
    EXPECT_NE(text.find("$end\n1!\n#40000\n1\"\n$comment position_pulses r1=1 r2=2 psi=3 y=4 $end\n0!\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("#40000"), text.rfind('#'));
}

}  // namespace
}  // namespace psicarve::trace
