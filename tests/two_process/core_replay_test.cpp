// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <string>

#include "shared/machine/recorded_gaps.hpp"
#include "shared/segment/robust_mutex.hpp"
#include "tests/two_process/child_process.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreReplay : public CoreRig {
protected:
    void save_job(const JobTable& table, const std::string& path) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, path));
    }
    int replay(const std::string& job, const std::string& trace) {
        CoreProcess core{
            {"--segment", segment_name_, "--clock", "virtual", "--replay", job, "--trace", trace},
            file("replay.err")};
        return core.wait_for_exit();
    }
    /// From a core's begin to its end in order, with `trace` of all of it. The segment stays.
    void carve_by_commands(const JobTable& table, const std::string& trace) {
        start_core({"--trace", trace});
        ASSERT_EQ(publish(table), "");
        home();
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(core_->wait_for_exit(), 0);
        segment_.reset();
    }
};

// A core that waits for a lock of the segment can be held up by any process that may write there.
TEST_F(CoreReplay, IsRefusedWhereAnotherProcessKeepsTheSegmentsMutex) {
    start_core();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    save_job(lobed_job(5, 65), file("job"));
    {
        const test::ChildProcess holder{[&](test::ChildProcess::Signal holds) {
            RobustMutex mutex{segment_->header().mutex};
            if (mutex.try_lock()) holds.raise();
            pause();
        }};
        ASSERT_TRUE(holder.wait_for_signal());
        EXPECT_EQ(replay(file("job"), file("a.vcd")), 5);
        const std::string said = text_of(file("replay.err"));
        EXPECT_NE(said.find("process " + std::to_string(holder.pid())), std::string::npos) << said;
        EXPECT_FALSE(std::filesystem::exists(file("a.vcd"))) << "nothing has begun";
    }
    EXPECT_EQ(replay(file("job"), file("a.vcd")), 0) << "the mutex of a dead holder is free";
}

TEST_F(CoreReplay, TwoReplaysOfAJobGiveTheSameBytes) {
    save_job(lobed_job(5, 65), file("job"));
    ASSERT_EQ(replay(file("job"), file("a.vcd")), 0) << text_of(file("replay.err"));
    ASSERT_EQ(replay(file("job"), file("b.vcd")), 0);
    ASSERT_EQ(replay(file("job"), file("a.trace")), 0);
    ASSERT_EQ(replay(file("job"), file("b.trace")), 0);
    EXPECT_GT(text_of(file("a.vcd")).size(), 10'000U);
    EXPECT_TRUE(text_of(file("a.vcd")) == text_of(file("b.vcd")));
    EXPECT_TRUE(text_of(file("a.trace")) == text_of(file("b.trace")));
}

/// Whole numbers only, so that every machine makes the same job.
JobTable toothed_job() {
    JobTable table = lobed_job(6, 81);
    for (std::size_t i = 0; i < table.r_left_pulses.size(); ++i) {
        const auto tooth = static_cast<std::int32_t>(i * 37 % 160);
        table.r_left_pulses[i] = 4000 + (tooth < 80 ? tooth : 160 - tooth);
        table.r_right_pulses[i] = 3600 + static_cast<std::int32_t>(i * 53 % 97);
    }
    return table;
}

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    return hash;
}

// Runs in dev, release and under the sanitizers, on every machine: so all of them put out the same pins. A
// change of motion or of the trace's form changes the number; it is then read off this test's message.
TEST_F(CoreReplay, GivesTheSameBytesInEveryBuild) {
    save_job(toothed_job(), file("job"));
    ASSERT_EQ(replay(file("job"), file("a.vcd")), 0) << text_of(file("replay.err"));
    EXPECT_EQ(hash_of(text_of(file("a.vcd"))), 13796908186300965543ULL);
}

TEST_F(CoreReplay, CarvingByCommandsTwiceGivesTheSameBytes) {
    for (const std::string name : {"a.trace", "b.trace"}) {
        carve_by_commands(lobed_job(3, 33), file(name));
        ASSERT_TRUE(Segment::remove(segment_name_));
    }
    EXPECT_GT(text_of(file("a.trace")).size(), 10'000U);
    EXPECT_TRUE(text_of(file("a.trace")) == text_of(file("b.trace")));
}

// A core loads what it finds in the segment: a job more than one in a segment of its own, or none more where
// the next one comes before it has looked.
TEST_F(CoreReplay, WhatAnEarlierCoreHasLeftDoesNotShowInTheTrace) {
    carve_by_commands(lobed_job(3, 33), file("own.trace"));
    carve_by_commands(lobed_job(3, 33), file("left.trace"));
    EXPECT_TRUE(text_of(file("own.trace")) == text_of(file("left.trace")));
}

// A stop came in the midst of Y's gap on its way down: 5 of 80 pulses are left of it.
TEST_F(CoreReplay, BeginsInTheGapsOfTheRecordedRest) {
    Profile profile;
    profile.y.backlash_mm = 80.0 / profile.y.pulses_per_mm;
    FlightRecord rest{};
    rest.tick = 1000;
    rest.kind = RecordKind::state_change;
    rest.code = static_cast<std::uint16_t>(MachineState::ready);
    rest.signals = kEnableMask | bit_of(Signal::r1_dir);
    rest.value = recorded_gaps({0, 0, 0, 5});
    rest.position_pulses[index_of(Axis::y)] = 2000;
    FlightRecord override{};
    override.tick = 2000;
    override.kind = RecordKind::command;
    override.code = static_cast<std::uint16_t>(CommandKind::override);
    override.answer = static_cast<std::uint32_t>(AnswerKind::done);
    override.value = 50;
    Snapshot snapshot;
    snapshot.status = CoreStatus{};
    snapshot.records = {rest, override};
    snapshot.job_blob = job_blob_from_table(lobed_job(3, 33, profile));
    ASSERT_TRUE(save_snapshot(snapshot, file("snapshot")));
    ASSERT_EQ(replay(file("snapshot"), file("a.vcd")), 0) << text_of(file("replay.err"));
    const std::string trace = text_of(file("a.vcd"));
    EXPECT_NE(trace.find("crossed_pulses r1=0 r2=0 psi=0 y=75 $end"), std::string::npos)
        << trace.substr(0, 2000);
}

TEST_F(CoreReplay, ARecordedRunIsAppliedAgainTickByTick) {
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 500; }));
    ASSERT_EQ(refusal_of(CommandKind::override, 40.0), "");
    ASSERT_TRUE(eventually([&] { return status().points_done > 1000; }));
    ASSERT_EQ(refusal_of(CommandKind::hold), "");
    ASSERT_TRUE(reaches(MachineState::held));
    ASSERT_EQ(refusal_of(CommandKind::override, 90.0), "");
    ASSERT_EQ(refusal_of(CommandKind::resume), "");
    ASSERT_TRUE(eventually([&] { return status().points_done > 1500; }));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    const CoreStatus end = status();

    Snapshot snapshot;
    snapshot.status = end;
    RingReader reader{segment_->header().recorder};
    while (const auto record = reader.next()) snapshot.records.push_back(*record);
    snapshot.job_blob = job_blob_from_table(long_job());
    ASSERT_TRUE(save_snapshot(snapshot, file("snapshot")));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);

    ASSERT_EQ(replay(file("snapshot"), file("replay.trace")), 0) << text_of(file("replay.err"));
    attach();
    const CoreStatus again = status();
    EXPECT_EQ(again.override_percent, 90U);
    EXPECT_EQ(again.points_done, end.points_done) << "the stop fell on the same tick";
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(again.position_pulses[index_of(axis)], end.position_pulses[index_of(axis)])
            << name_of(axis);
        EXPECT_EQ(again.emitted_pulses[index_of(axis)], end.emitted_pulses[index_of(axis)]) << name_of(axis);
    }
}

TEST_F(CoreReplay, ASnapshotTakenInFullMotionEndsThereAndLosesNothing) {
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 500; }));
    Snapshot snapshot;
    snapshot.status = status();
    RingReader reader{segment_->header().recorder};
    while (const auto record = reader.next()) snapshot.records.push_back(*record);
    snapshot.job_blob = job_blob_from_table(long_job());
    ASSERT_TRUE(save_snapshot(snapshot, file("snapshot")));
    core_.reset();
    ASSERT_EQ(replay(file("snapshot"), file("replay.trace")), 0) << text_of(file("replay.err"));
    attach();
    const CoreStatus again = status();
    EXPECT_EQ(again.state, MachineState::carving);
    for (const Axis axis : kAllAxes) EXPECT_EQ(again.sim_stalls[index_of(axis)], 0U) << name_of(axis);
}

// What it would carve is not what the machine did.
TEST_F(CoreReplay, ASnapshotWithoutARunIsRefusedAndNoTraceIsMade) {
    start_core();
    ASSERT_EQ(publish(lobed_job(5, 65)), "");
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(lobed_job(5, 65));
    const auto save = [&](const std::string& name) {
        snapshot.status = status();
        snapshot.records.clear();
        RingReader reader{segment_->header().recorder};
        while (const auto record = reader.next()) snapshot.records.push_back(*record);
        ASSERT_TRUE(save_snapshot(snapshot, file(name)));
    };
    save("never homed");
    ASSERT_EQ(refusal_of(CommandKind::home), "");
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    save("stopped while homing");
    snapshot.records.clear();
    ASSERT_TRUE(save_snapshot(snapshot, file("no records")));
    core_.reset();
    for (const char* const name : {"never homed", "stopped while homing", "no records"}) {
        EXPECT_EQ(replay(file(name), file("a.vcd")), 3) << name;
        const std::string said = text_of(file("replay.err"));
        EXPECT_NE(said.find("psicarve carve"), std::string::npos) << said;
        EXPECT_FALSE(std::filesystem::exists(file("a.vcd"))) << name;
    }
}

TEST_F(CoreReplay, AFileThatIsNoJobIsRefusedAndNoTraceIsMade) {
    {
        std::ofstream garbage{file("garbage")};
        garbage << "PSCSNAP1 and then nothing that makes sense";
    }
    EXPECT_EQ(replay(file("garbage"), file("never.vcd")), 3);
    EXPECT_NE(text_of(file("replay.err")).find("garbage"), std::string::npos);
    EXPECT_NE(access(file("never.vcd").c_str(), F_OK), 0);
    EXPECT_EQ(replay(file("no-such-file"), file("never.vcd")), 3);
}

}  // namespace
}  // namespace psicarve::two_process
