// SPDX-License-Identifier: GPL-3.0-or-later
// Trace files: both forms, what other tools write, and what is no trace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

#include "hmi/trace/trace_reader.hpp"
#include "tests/hmi/verify/trace_file_fixture.hpp"

namespace psicarve::verify {
namespace {

using testing::HasSubstr;

const std::string kDeclarations =
    "$timescale 1 us $end\n$scope module top $end\n"
    "$var wire 1 ! r1_step $end\n$var wire 1 \" r2_step $end\n$var wire 1 # psi_step $end\n"
    "$var wire 1 $ y_step $end\n$var wire 1 % r1_dir $end\n$var wire 1 & r2_dir $end\n"
    "$var wire 1 ' psi_dir $end\n$var wire 1 ( y_dir $end\n";
const std::string kBody = "$upscope $end\n$enddefinitions $end\n";

TEST_F(WholeTrace, ReadsBackFromAValueChangeDump) {
    expect_equal(read(as_vcd(machine_.start, machine_.events)), machine_);
}

TEST_F(WholeTrace, ReadsBackFromTheBinaryForm) {
    const ReadTrace trace = read(as_binary(machine_.start, machine_.events));
    expect_equal(trace, machine_);
    EXPECT_EQ(trace.start.period_ns, 50'000);
    EXPECT_EQ(trace.events.size(), machine_.events.size() + 1);  // the end, one tick later
}

TEST_F(WholeTrace, ReadsBackOneEventAtATime) {
    expect_equal(read(as_binary(machine_.start, machine_.events), 1), machine_);
    expect_equal(read(as_vcd(machine_.start, machine_.events), 1), machine_);
}

TEST_F(WholeTrace, IsVerifiedFromAFile) {
    std::ofstream(path_, std::ios::binary) << as_binary(machine_.start, machine_.events);
    auto trace = open_trace(path_);
    auto sut = Verifier::make(job_.view(), job_.profile);
    ASSERT_TRUE(trace && sut);
    const auto report = verify_trace(*sut, **trace);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->ok) << report_text(*report);
}

TEST_F(WholeTrace, CutOffAnywhereIsRefusedWithItsLength) {
    const std::string bytes = as_binary(machine_.start, machine_.events);
    for (const std::size_t length : {std::size_t{12}, std::size_t{64}, bytes.size() / 2, bytes.size() - 1}) {
        const ReadTrace trace = read(bytes.substr(0, length));
        EXPECT_THAT(trace.error, HasSubstr("cut off")) << length;
        EXPECT_THAT(trace.error, HasSubstr("byte " + std::to_string(length))) << length;
    }
}

TEST_F(WholeTrace, WithBytesBehindItsEndIsRefused) {
    EXPECT_THAT(read(as_binary(machine_.start, machine_.events) + "x").error,
                HasSubstr("after the trace's end"));
}

TEST_F(WholeTrace, StreamsThroughAPipeWhileItIsWritten) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const std::string bytes = as_binary(machine_.start, machine_.events);
    std::thread writer([&] {
        for (std::size_t at = 0; at < bytes.size(); at += 997) {
            const std::size_t length = std::min<std::size_t>(997, bytes.size() - at);
            ASSERT_EQ(::write(ends[1], bytes.data() + at, length), static_cast<ssize_t>(length));
        }
        ::close(ends[1]);
    });
    const ReadTrace trace = read_all(open_trace_fd(ends[0], "pipe"));
    writer.join();
    expect_equal(trace, machine_);
}

TEST_F(TraceFile, AHeaderOfAnotherVersionIsRefused) {
    const SampleJob job = wavy_job();
    std::string bytes = as_binary(PerfectMachine(job).start, {});
    bytes[8] = 9;
    EXPECT_THAT(read(bytes).error, HasSubstr("version 9"));
}

TEST_F(TraceFile, PositionsThatNoMachineCountsAreRefused) {
    constexpr std::int64_t kMost = kMostTracePosition_pulses;
    const SampleJob job = wavy_job();
    for (const std::int64_t pulses :
         {kMost, -kMost, kMost + 1, -kMost - 1, std::numeric_limits<std::int64_t>::max(),
          std::numeric_limits<std::int64_t>::min()}) {
        const bool is_one = pulses <= kMost && pulses >= -kMost;
        TraceStart start = PerfectMachine(job).start;
        TraceEvent event{.kind = TraceEvent::Kind::position};
        event.position_pulses[2] = pulses;
        EXPECT_EQ(read(as_binary(start, {event})).error.find("beyond all bounds") == std::string::npos,
                  is_one)
            << pulses;
        start.position_pulses[3] = pulses;
        EXPECT_EQ(read(as_binary(start, {})).error.find("beyond all bounds") == std::string::npos, is_one)
            << pulses;
    }
}

TEST_F(TraceFile, TellsHowMuchOfEachGapWasCrossedInBothForms) {
    const SampleJob job = wavy_job();
    TraceStart start = PerfectMachine(job).start;
    EXPECT_EQ(read(as_binary(start, {})).start.crossed_pulses, (std::array<std::int64_t, kAxisCount>{}));
    EXPECT_EQ(read(as_vcd(start, {})).start.crossed_pulses, (std::array<std::int64_t, kAxisCount>{}));
    start.crossed_pulses = {0, 40, 0, 1};
    const TraceEvent event{.time_ns = 150'000, .levels = 5};
    for (const std::string& bytes : {as_binary(start, {event}), as_vcd(start, {event})}) {
        const ReadTrace trace = read(bytes);
        EXPECT_EQ(trace.error, "");
        EXPECT_EQ(trace.start.crossed_pulses, start.crossed_pulses);
        EXPECT_EQ(trace.start.position_pulses, start.position_pulses);
        ASSERT_FALSE(trace.events.empty());
        EXPECT_EQ(trace.events[0].levels, 5U);
    }
}

TEST_F(TraceFile, GapsThatNoScrewCrossesAreRefusedByTheirByte) {
    const SampleJob job = wavy_job();
    for (const std::int64_t pulses :
         {std::int64_t{-1}, std::numeric_limits<std::int64_t>::min(), kMostTracePosition_pulses + 1,
          std::numeric_limits<std::int64_t>::max()}) {
        TraceStart start = PerfectMachine(job).start;
        start.crossed_pulses[3] = pulses;
        EXPECT_THAT(read(as_binary(start, {})).error,
                    HasSubstr("byte 64: a gap crossed by less than nothing or beyond all bounds"))
            << pulses;
        EXPECT_THAT(read(as_vcd(start, {})).error, HasSubstr("crossed_pulses are not four counts from 0 on"))
            << pulses;
    }
}

TEST_F(TraceFile, AHeadThatEndsWithinItsGapsIsRefused) {
    const SampleJob job = wavy_job();
    TraceStart start = PerfectMachine(job).start;
    start.crossed_pulses[0] = 3;
    const std::string bytes = as_binary(start, {});
    for (const std::size_t length : {64U, 71U, 95U}) {
        EXPECT_THAT(read(bytes.substr(0, length)).error,
                    HasSubstr("byte " + std::to_string(length) + ": the trace is cut off inside its header"));
    }
}

TEST_F(TraceFile, ADamagedCommentOfGapsIsRefusedAndALaterOneIsAComment) {
    const SampleJob job = wavy_job();
    TraceStart start = PerfectMachine(job).start;
    start.crossed_pulses = {1, 2, 3, 4};
    const std::string good = as_vcd(start, {});
    for (const std::string damaged : {"r1=1 r2=2 psi=3", "r1=1 r2=2 psi=3 y=", "r1=1 r2=2 psi=3 y=4 z=5",
                                      "r1 r2=2 psi=3 y=4", "r1=1.5 r2=2 psi=3 y=4", ""}) {
        std::string text = good;
        const std::string whole = "r1=1 r2=2 psi=3 y=4";
        text.replace(text.rfind(whole), whole.size(), damaged);
        EXPECT_THAT(read(text).error, HasSubstr("crossed_pulses are not four")) << damaged;
    }
    const ReadTrace later = read(good + "#9\n1!\n$comment crossed_pulses r1=-7 $end\n");
    EXPECT_EQ(later.error, "");
    EXPECT_EQ(later.start.crossed_pulses, start.crossed_pulses);
}

TEST_F(TraceFile, WhatTheLastEventSaysDoesNotHangOnTheRoomItIsGiven) {
    const SampleJob job = wavy_job();
    TraceEvent position{.kind = TraceEvent::Kind::position};
    position.position_pulses = {1, 2, 3, 4};
    const ReadTrace trace = read(as_binary(PerfectMachine(job).start, {position}), 1);
    ASSERT_EQ(trace.events.size(), 2U);
    EXPECT_EQ(trace.events[1].position_pulses, (std::array<std::int64_t, kAxisCount>{}));
}

TEST_F(TraceFile, ThatIsNoTraceIsRefused) {
    EXPECT_THAT(read("hello").error, HasSubstr("neither"));
    EXPECT_THAT(read("").error, HasSubstr("empty"));
    EXPECT_THAT(read_all(open_trace("/nowhere/at.all")).error, HasSubstr("cannot open"));
}

TEST_F(TraceFile, MicrosecondsBecomeNanoseconds) {
    const ReadTrace trace = read(kDeclarations + kBody + "#0 0! 0\" 0# 0$ 0% 0& 0' 0(\n#7 1!\n#9 0!\n");
    ASSERT_EQ(trace.events.size(), 2U) << trace.error;
    EXPECT_EQ(trace.events[0].time_ns, 7'000);
    EXPECT_EQ(trace.events[0].levels, bit_of(Signal::r1_step));
    EXPECT_EQ(trace.events[1].time_ns, 9'000);
}

TEST_F(TraceFile, PicosecondsBecomeNanoseconds) {
    std::string text = kDeclarations + kBody + "#0 0!\n#70000 1!\n";
    text.replace(text.find("1 us"), 4, "10ps");
    EXPECT_EQ(read(text).events.at(0).time_ns, 700);
}

TEST_F(TraceFile, UnknownLevelsCountAsLow) {
    const ReadTrace trace = read(kDeclarations + kBody + "#0 x! z\" X# Z$ 1%\n#5 1!\n#6 x!\n");
    EXPECT_EQ(trace.start.initial_levels, bit_of(Signal::r1_dir));
    ASSERT_EQ(trace.events.size(), 2U) << trace.error;
    EXPECT_EQ(trace.events[1].levels, bit_of(Signal::r1_dir));
}

TEST_F(TraceFile, AsGtkwaveAndItsSimulatorsWriteItIsRead) {
    const std::string text =
        "$date\n  Tue Jan  1 00:00:00 2030\n$end\n$version\n  some simulator\n$end\n$timescale\n  10 "
        "ns\n$end\n"
        "$scope module bench $end\n$scope module port $end\n"
        "$var reg 1 ab r1_step [0:0] $end\n$var wire 1 ac r2_step[0] $end\n$var wire 1 ad psi_step $end\n"
        "$var wire 1 ae y_step $end\n$var wire 1 af r1_dir $end\n$var wire 1 ag r2_dir $end\n"
        "$var wire 1 ah psi_dir $end\n$var wire 1 ai y_dir $end\n$upscope $end\n"
        "$var wire 8 long data $end\n$var real 64 volt level $end\n$var wire 1 zz r1_step $end\n$upscope "
        "$end\n"
        "$enddefinitions $end\n$dumpvars\nb0 ab\n0ac\n0ad\n0ae\n0af\n0ag\n0ah\n0ai\nbxxxxxxxx long\nr0.5 "
        "volt\n"
        "1zz\n$end\n#0\n#3\nb1 ab\nb00001111 long\nr1.25 volt\n0zz\n#4\nb0 ab\n";
    const ReadTrace trace = read(text);
    ASSERT_EQ(trace.events.size(), 2U) << trace.error;
    EXPECT_EQ(trace.events[0].time_ns, 30);
    EXPECT_EQ(trace.events[0].levels, bit_of(Signal::r1_step));
    EXPECT_FALSE(trace.start.has_positions);
}

TEST_F(TraceFile, AWireThatChangesTwiceAtOneInstantKeepsBothChanges) {
    const ReadTrace trace = read(kDeclarations + kBody + "#0 0!\n#5 1! 0! 1!\n");
    ASSERT_EQ(trace.events.size(), 3U) << trace.error;
    EXPECT_EQ(trace.events[1].levels, 0U);
    EXPECT_EQ(trace.events[1].time_ns, 5'000);
}

TEST_F(TraceFile, PositionsStandInComments) {
    const ReadTrace trace =
        read(kDeclarations + kBody +
             "$comment position_pulses r1=1 r2=-2 psi=3 y=4 $end\n#0 $dumpvars 0! $end\n#5 1!\n"
             "$comment position_pulses r1=5 r2=6 psi=7 y=8 $end\n$comment anything else $end\n");
    EXPECT_EQ(trace.start.position_pulses, (std::array<std::int64_t, 4>{1, -2, 3, 4}));
    ASSERT_EQ(trace.events.size(), 2U) << trace.error;
    EXPECT_EQ(trace.events[1].kind, TraceEvent::Kind::position);
    EXPECT_EQ(trace.events[1].position_pulses[3], 8);
}

TEST_F(TraceFile, MissingStepWiresAreNamed) {
    std::string text = kDeclarations + kBody + "#0\n";
    text.replace(text.find("psi_step"), 8, "psi_stop");
    text.replace(text.find("y_step"), 6, "z_step");
    EXPECT_THAT(read(text).error, HasSubstr("no wire named psi_step, y_step"));
}

TEST_F(TraceFile, MissingInputsAreNotTripped) {
    const ReadTrace trace = read(kDeclarations + kBody + "#0 0!\n");
    EXPECT_EQ(trace.error, "");
    EXPECT_EQ(trace.start.present, kStepMask | kDirMask);
}

TEST_F(TraceFile, GarbageInsideADumpIsNamedWithItsPlace) {
    const std::string good = kDeclarations + kBody + "#0 0!\n#5 1!\n";
    for (const char* bad : {"#abc\n", "#2\n", "1~\n", "hello\n", "#99999999999999999999\n", "1\n"}) {
        const ReadTrace trace = read(good + bad);
        EXPECT_THAT(trace.error, HasSubstr("byte " + std::to_string(good.size()))) << bad;
        EXPECT_LE(trace.events.size(), 1U);
    }
}

TEST_F(TraceFile, ADumpCutOffInsideAValueIsRefused) {
    EXPECT_THAT(read(kDeclarations + kBody + "#0 0!\n#5 b1\n").error, HasSubstr("cut off"));
    EXPECT_THAT(read(kDeclarations + kBody + "#0 0!\n#51 1!\n#5").error, HasSubstr("cut off"));
}

TEST_F(TraceFile, ADumpCutOffInItsDeclarationsIsRefused) {
    EXPECT_THAT(read(kDeclarations).error, HasSubstr("$enddefinitions"));
}

}  // namespace
}  // namespace psicarve::verify
