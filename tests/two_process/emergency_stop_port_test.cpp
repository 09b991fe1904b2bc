// SPDX-License-Identifier: GPL-3.0-or-later
// The emergency stop on a real port, whatever the machine does besides carving: after it the registers say
// what must be true.
#include <random>

#include "tests/thoroughness.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr std::uint32_t kYLimitStatusBit = 0x40;

class PortEmergencyStops : public PortRig {
protected:
    /// Homed where it stands, but for Y.
    PortEmergencyStops() {
        const HomeSensor of_y = profile_.y.home;
        home_where_it_stands();
        profile_.y.home = of_y;
        write_profile();
        port_.stand(profile_);
    }
    /// From one of the next writes on the status register shows this, whichever process writes. Returns which
    /// write.
    std::uint64_t flip_soon(std::uint32_t status_bits) {
        constexpr std::uint64_t kSoonest = 20;
        const std::uint64_t at = port_.state().write_count.load() + kSoonest + random_() % 40;
        port_.state().flip_to.store(status_bits);
        port_.state().flip_at_write.store(at);
        return at;
    }
    void expect_stopped_at(std::uint64_t write) {
        ASSERT_TRUE(reaches(MachineState::alarm));
        EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop) << name_of(status().alarm_cause);
        const std::uint64_t tick = status().tick;
        ASSERT_TRUE(eventually([&] { return status().tick > tick + 50; }));
        ASSERT_GE(port_.state().write_count.load(), write) << "it moved";
        expect_safe_after(write + 1);
        EXPECT_NE(refusal_of(CommandKind::reset_alarm).find("estop"), std::string::npos);
    }
    void release_switches() {
        port_.state().status_flip.store(0);
        ASSERT_TRUE(eventually([&] { return refusal_of(CommandKind::reset_alarm).empty(); }));
    }
    Command leased(CommandKind kind, std::uint32_t what) const {
        Command command{};
        command.kind = kind;
        command.axis = what;
        command.value = 1.0;
        command.lease_token = 5;
        command.lease_ms = 2000;
        return command;
    }
    /// Replays it on the port, and presses the switch in the middle.
    void expect_stop_of_replay(const std::string& path) {
        const std::uint64_t at = port_.state().write_count.load() + 400;
        port_.state().flip_to.store(kEstopStatusBit);
        port_.state().flip_at_write.store(at);
        const fake_port::FakePortFile::Preload preload{port_};
        std::vector<std::string> arguments = port_arguments(segment_name_);
        arguments.insert(arguments.end(), {"--replay", path, "--assume-homed"});
        CoreProcess replay{arguments, file("replay.err")};
        EXPECT_EQ(replay.wait_for_exit(), 4) << text_of(file("replay.err"));
        attach();
        EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop) << name_of(status().alarm_cause);
        expect_safe_after(at + 1);
        segment_.reset();
        [[maybe_unused]] const auto removed = Segment::remove(segment_name_);
    }

    std::mt19937 random_{20261123};
};

TEST_F(PortEmergencyStops, EndAJogWithTheirTick) {
    home_where_it_stands();
    start_port_core();
    for (int stop = 0; stop < (test::is_thorough() ? 5 : 2); ++stop) {
        home();
        const std::uint64_t at = flip_soon(kEstopStatusBit);
        ASSERT_EQ(refusal_of(leased(CommandKind::jog_on, static_cast<std::uint32_t>(Axis::psi))), "");
        ASSERT_NO_FATAL_FAILURE(expect_stopped_at(at)) << "stop " << stop;
        EXPECT_EQ(status().homed_mask & 1U << index_of(Axis::psi), 0U) << "it moved";
        release_switches();
    }
}

TEST_F(PortEmergencyStops, EndABackOffWithTheirTick) {
    start_port_core();
    for (int stop = 0; stop < (test::is_thorough() ? 4 : 2); ++stop) {
        home();
        port_.state().status_flip.store(kYLimitStatusBit);
        ASSERT_TRUE(reaches(MachineState::alarm));
        ASSERT_EQ(status().alarm_cause, AlarmCause::limit);
        const std::uint64_t at = flip_soon(kYLimitStatusBit | kEstopStatusBit);
        ASSERT_EQ(refusal_of(CommandKind::back_off, Axis::y), "");
        ASSERT_NO_FATAL_FAILURE(expect_stopped_at(at)) << "stop " << stop;
        EXPECT_NE(refusal_of(CommandKind::back_off, Axis::y), "") << "the switch is still pressed";
        release_switches();
    }
}

TEST_F(PortEmergencyStops, EndATestOfAPinWithTheirTick) {
    start_port_core();
    for (const Signal output : {Signal::r1_step, Signal::psi_step}) {
        const std::uint64_t at = flip_soon(kEstopStatusBit);
        Command test = leased(CommandKind::test_pin, static_cast<std::uint32_t>(index_of(output)));
        test.value2 = 10'000;
        test.speed = 100.0;
        ASSERT_EQ(refusal_of(test), "");
        ASSERT_NO_FATAL_FAILURE(expect_stopped_at(at)) << name_of(output);
        release_switches();
    }
    // The word in the segment, while the spindle turns.
    ASSERT_EQ(
        refusal_of(leased(CommandKind::test_pin, static_cast<std::uint32_t>(index_of(Signal::spindle)))), "");
    ASSERT_TRUE(eventually([&] { return !is_safe(); }));
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    expect_safe_registers();
}

TEST_F(PortEmergencyStops, EndTheReplayOfAJobWithTheirTick) {
    Snapshot job;
    job.job_blob = job_blob_from_table(coarse_job(10));
    ASSERT_TRUE(save_snapshot(job, file("job")));
    expect_stop_of_replay(file("job"));
}

// Its inputs come from the recording; but the hand on the switch is not in it.
TEST_F(PortEmergencyStops, EndTheReplayOfARecordedRunWithTheirTick) {
    start_core({"--profile", file("machine.toml")});
    ASSERT_EQ(publish(coarse_job(10)), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    Snapshot run;
    run.status = status();
    RingReader reader{segment_->header().recorder};
    while (const auto record = reader.next()) run.records.push_back(*record);
    run.job_blob = job_blob_from_table(coarse_job(10));
    ASSERT_TRUE(save_snapshot(run, file("run")));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    segment_.reset();
    ASSERT_TRUE(Segment::remove(segment_name_));
    expect_stop_of_replay(file("run"));
}

}  // namespace
}  // namespace psicarve::two_process
