// SPDX-License-Identifier: GPL-3.0-or-later
// A trace that begins while screws have crossed their gaps tells so, and is judged by it.
#include <array>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/profile/profile.hpp"
#include "shared/trace/trace_format.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

using Json = nlohmann::json;
using Crossed = std::array<std::int64_t, kAxisCount>;

constexpr std::int64_t kGapPulses = 20;
constexpr int kJudgedNo = 6;

/// Each gap is kGapPulses wide; the table's screw has none.
class CrossedGaps : public Machine {
protected:
    CrossedGaps() {
        Profile profile;
        profile.r1.backlash_mm = profile.r2.backlash_mm = profile.y.backlash_mm = 0.05;
        profile.job.feed_mm_s = 1.0;
        write("worn.toml", profile_to_toml(profile));
    }
    void start_homed() {
        start_core({"--profile", file("worn.toml")});
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    std::string worn_job(const std::string& layers = "2") const {
        const Outcome sliced =
            psicarve({"slice", box_stl("box.stl"), "-o", file("worn.job"), "--layers", layers, "--points",
                      "17", "--joining", "zigzag", "--profile", file("worn.toml")});
        EXPECT_EQ(sliced.exit_code, 0) << sliced.error;
        return file("worn.job");
    }
    /// While it is carved and from its trace it is judged alike: exact.
    void expect_carved(const std::string& job, const std::string& trace) const {
        const Outcome carved = run({"carve", job, "--trace", trace, "--json"});
        ASSERT_EQ(carved.exit_code, 0) << carved.error << carved.out;
        EXPECT_EQ(carved.json()["verified"], true);
        EXPECT_EQ(carved.json()["max_deviation_pulses"], 0);
        const Outcome again = psicarve({"verify", job, trace, "--json"});
        EXPECT_EQ(again.exit_code, 0) << again.error << again.out;
        EXPECT_EQ(again.json()["max_deviation_pulses"], 0);
        if (trace.ends_with(".vcd")) return;
        EXPECT_EQ(psicarve({"verify", trace}).exit_code, 0) << "by the job that it carries";
    }
    void expect_program_runs(const std::string& trace) const {
        write("run.ngc", "G21 G90 F120\nG0 X45 C0\nM3\nG1 X40 Y4\nG1 X44 Y1 C30\nG1 X42 Y3\nM2\n");
        const Outcome done = run(
            {"gcode", "run", file("run.ngc"), "--trace", trace, "--profile", file("worn.toml"), "--json"});
        ASSERT_EQ(done.exit_code, 0) << done.error << done.out;
        const Outcome judged = psicarve(
            {"verify", trace, "--program", file("run.ngc"), "--profile", file("worn.toml"), "--json"});
        EXPECT_EQ(judged.exit_code, 0) << judged.error << judged.out;
    }
    bool has_ended_job() const {
        const auto segment = Segment::attach(segment_);
        const auto status = segment ? read_record(segment->header().status) : std::nullopt;
        return status && status->job_end_tick != 0;
    }
    static Crossed told_by(const std::string& trace) {
        const auto opened = verify::open_trace(trace);
        EXPECT_TRUE(opened) << trace;
        return opened ? (*opened)->start().crossed_pulses : Crossed{};
    }
    /// The same binary trace, as if R1's gap had been crossed by so many pulses.
    std::string with_r1_crossed_by(const std::string& trace, std::int64_t pulses) const {
        std::string bytes = text_of(trace);
        EXPECT_EQ(bytes.at(offsetof(TraceHeader, version)), static_cast<char>(kCrossedTraceVersion));
        std::memcpy(bytes.data() + sizeof(TraceHeader), &pulses, sizeof pulses);
        write("changed.trace", bytes);
        return file("changed.trace");
    }
};

TEST_F(CrossedGaps, OfAHomedMachineAreToldAndItsCarvingsAreExact) {
    start_homed();
    const std::string job = worn_job();
    expect_carved(job, file("first.trace"));
    EXPECT_NE(told_by(file("first.trace")), Crossed{}) << "homing leaves some axis on the lower flank";
    expect_carved(job, file("second.vcd"));
    expect_carved(job, file("third.trace"));
    EXPECT_EQ(told_by(file("third.trace")), told_by(file("second.vcd"))) << "after the same carving";
}

TEST_F(CrossedGaps, AreToldAfterMovesAndJogsEitherWay) {
    struct Case {
        std::vector<const char*> ways;
        Axis axis;  ///< the last way's
        std::int64_t crossed_pulses;
    };
    start_homed();
    const std::string job = worn_job();
    expect_carved(job, file("first.trace"));
    for (const Case& each :
         {Case{{"move y=3", "jog y -1"}, Axis::y, kGapPulses},
          Case{{"move y=3", "move r1=40 r2=40", "jog r1 2"}, Axis::r1, 0},
          Case{{"move r1=45 r2=45 y=5 psi=30", "jog y 0.02", "jog r2 -3"}, Axis::r2, kGapPulses}}) {
        for (const char* way : each.ways) ASSERT_EQ(run(words_of(way)).exit_code, 0) << way;
        expect_carved(job, file("moved.trace"));
        EXPECT_EQ(told_by(file("moved.trace"))[index_of(each.axis)], each.crossed_pulses) << each.ways.back();
        for (const char* way : each.ways) ASSERT_EQ(run(words_of(way)).exit_code, 0) << way;
        expect_carved(job, file("moved.vcd"));
        EXPECT_EQ(told_by(file("moved.vcd")), told_by(file("moved.trace"))) << each.ways.back();
    }
}

// Replayed: a core's own trace begins before homing.
TEST_F(CrossedGaps, OfAPartOfTheLayersAreTold) {
    const std::string job = worn_job("4");
    for (const std::vector<std::string>& part :
         {std::vector<std::string>{"--from-layer", "2"}, {"--from-layer", "1", "--layers", "2"}}) {
        start_homed();
        for (const char* way : {"move y=3", "jog y -1"}) ASSERT_EQ(run(words_of(way)).exit_code, 0) << way;
        ASSERT_EQ(run({"publish", job}).exit_code, 0);
        std::vector<std::string> words{"start", "--carve"};
        words.insert(words.end(), part.begin(), part.end());
        ASSERT_EQ(run(words).exit_code, 0);
        ASSERT_TRUE(eventually([&] { return has_ended_job(); }));
        ASSERT_EQ(run({"snapshot", "save", file("part.snap")}).exit_code, 0);
        core_->send(SIGTERM);
        ASSERT_EQ(core_->wait(), 0);
        core_.reset();
        ASSERT_TRUE(Segment::remove(segment_));
        const Outcome replayed = psicarve({"replay", file("part.snap"), "--trace", file("part.trace")});
        EXPECT_EQ(replayed.exit_code, 0) << replayed.error << replayed.out;
        EXPECT_NE(told_by(file("part.trace")), Crossed{});
        words = {"verify", job, file("part.trace")};
        words.insert(words.end(), part.begin(), part.end());
        const Outcome judged = psicarve(words);
        EXPECT_EQ(judged.exit_code, 0) << judged.error << judged.out;
    }
}

TEST_F(CrossedGaps, OfProgramsAreToldHoweverOftenTheyRun) {
    start_homed();
    expect_program_runs(file("first.trace"));
    expect_program_runs(file("second.vcd"));
    expect_program_runs(file("third.trace"));
    ASSERT_EQ(run({"jog", "y", "-1"}).exit_code, 0);
    expect_program_runs(file("down.trace"));
    EXPECT_EQ(told_by(file("down.trace"))[index_of(Axis::y)], kGapPulses);
}

// The replayed core's own state; it takes it from the direction pins as they were recorded.
TEST_F(CrossedGaps, OfAReplayedSnapshotAreTold) {
    start_homed();
    const std::string job = worn_job();
    ASSERT_EQ(run({"move", "y=3"}).exit_code, 0);
    ASSERT_EQ(run({"jog", "y", "-1"}).exit_code, 0);
    expect_carved(job, file("carved.trace"));
    ASSERT_EQ(run({"snapshot", "save", file("run.snap")}).exit_code, 0);
    for (const char* name : {"again.trace", "again.vcd"}) {
        const Outcome replayed = psicarve({"replay", file("run.snap"), "--trace", file(name), "--json"});
        EXPECT_EQ(replayed.exit_code, 0) << replayed.error << replayed.out;
        EXPECT_EQ(replayed.json()["verified"], true) << replayed.out;
        EXPECT_NE(told_by(file(name)), Crossed{}) << name;
        EXPECT_EQ(psicarve({"verify", job, file(name)}).exit_code, 0) << name;
    }
}

TEST_F(CrossedGaps, ThatAreToldWrongAreJudgedWrong) {
    start_homed();
    const std::string job = worn_job();
    ASSERT_EQ(run({"move", "r1=45", "r2=45"}).exit_code, 0);
    ASSERT_EQ(run({"move", "r1=40", "r2=40"}).exit_code, 0);
    expect_carved(job, file("true.trace"));
    ASSERT_EQ(told_by(file("true.trace"))[0], kGapPulses);
    for (const std::int64_t wrong : {std::int64_t{0}, kGapPulses - 1}) {
        const Outcome judged = psicarve({"verify", job, with_r1_crossed_by(file("true.trace"), wrong)});
        EXPECT_EQ(judged.exit_code, kJudgedNo) << wrong << judged.out;
    }
    const Outcome beyond = psicarve({"verify", job, with_r1_crossed_by(file("true.trace"), kGapPulses + 1)});
    EXPECT_EQ(beyond.exit_code, 3) << beyond.out;
    EXPECT_EQ(beyond.error, "psicarve: " + file("changed.trace") +
                                ": r1 begins 21 pulses into its backlash, which is 20 by this profile: it is "
                                "not of the machine that was traced\n");
    const Outcome negative = psicarve({"verify", job, with_r1_crossed_by(file("true.trace"), -1)});
    EXPECT_EQ(negative.exit_code, 3) << negative.out;
    EXPECT_NE(negative.error.find(": byte 64: "), std::string::npos) << negative.error;
}

}  // namespace
}  // namespace psicarve::test
