// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include "shared/segment/robust_mutex.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreFault : public CoreRig {
protected:
    std::uint64_t steps_of_the_machine() {
        const CoreStatus now = status();
        std::uint64_t sum = 0;
        for (const Axis axis : kAllAxes) sum += now.emitted_pulses[index_of(axis)];
        return sum;
    }
    /// It slowed down on the path: no step was lost, and the machine stands where the core says.
    void expect_alarm_on_a_new_segment() {
        ASSERT_TRUE(eventually([&] {
            auto fresh = Segment::attach(segment_name_);
            if (!fresh || fresh->core_pid() != std::uint32_t(core_->pid())) return false;
            segment_ = std::make_unique<Segment>(std::move(*fresh));
            return true;
        }));
        ASSERT_TRUE(reaches(MachineState::alarm));
        const CoreStatus end = status();
        EXPECT_EQ(end.alarm_cause, AlarmCause::segment_lost);
        EXPECT_EQ(end.homed_mask, 0) << "its drives are off";
        const std::int64_t turn = Profile{}.psi.pulses_per_rev;
        for (const Axis axis : kAllAxes) {
            const std::size_t k = index_of(axis);
            EXPECT_EQ(end.sim_stalls[k], 0U) << name_of(axis);
            EXPECT_EQ(end.sim_ignored_pulses[k], 0U) << name_of(axis);
            const std::int64_t off = end.sim_true_position_pulses[k] - end.position_pulses[k];
            EXPECT_EQ(axis == Axis::psi ? off % turn : off, 0) << name_of(axis);
        }
    }
    std::string publish_bytes(const std::vector<std::byte>& blob) {
        const auto generation = publish_job(*segment_, blob);
        if (!generation) return generation.error().message;
        const auto accepted = wait_for_acceptance(*segment_, *generation, kLimit);
        return accepted ? std::string{} : accepted.error().message;
    }
};

TEST_F(CoreFault, ASecondCoreIsRefusedWithThePidOfTheFirst) {
    start_core();
    CoreProcess second{{"--segment", segment_name_, "--clock", "virtual"}, file("second.err")};
    EXPECT_NE(second.wait_for_exit(), 0);
    EXPECT_NE(text_of(file("second.err")).find(std::to_string(core_->pid())), std::string::npos)
        << text_of(file("second.err"));
}

TEST_F(CoreFault, AKilledCoreLeavesTheSegmentToTheNextWhichIsNotHomed) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    EXPECT_TRUE(eventually([&] { return !segment_->core_pid().has_value(); }));
    start_core();
    EXPECT_EQ(status().state, MachineState::off);
    EXPECT_EQ(status().homed_mask, 0);
    EXPECT_NE(refusal_of(CommandKind::start), "");
    home();
    ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }))
        << "the published job is still there";
    start_carving();
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
}

TEST_F(CoreFault, APublisherKilledWithTheMutexHeldDoesNotDisturbTheCarving) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    const pid_t holder = fork();
    if (holder == 0) {
        auto own = Segment::attach(segment_name_);
        if (!own) _exit(1);
        RobustMutex mutex{own->header().mutex};
        if (!mutex.lock_within(milliseconds{1000})) _exit(2);
        kill(getpid(), SIGKILL);
    }
    int wait_status = 0;
    waitpid(holder, &wait_status, 0);
    ASSERT_TRUE(WIFSIGNALED(wait_status));
    const auto before = status().points_done;
    ASSERT_TRUE(eventually([&] { return status().points_done > before || status().job_end_tick != 0; }));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(publish(lobed_job(2, 9)), "") << "the next publisher recovers the mutex";
}

TEST_F(CoreFault, GarbageIsRefusedByNameAndMovesNothing) {
    start_core();
    home();
    const auto steps_before = steps_of_the_machine();
    std::vector<std::byte> garbage(4096, std::byte{0x5a});
    EXPECT_NE(publish_bytes(garbage), "");
    auto blob = job_blob_from_table(lobed_job(3, 9));
    auto truncated = blob;
    truncated.resize(blob.size() / 2);
    EXPECT_NE(publish_bytes(truncated), "");
    JobTable too_deep = lobed_job(3, 9);
    too_deep.r_left_pulses[13] = 1;
    const std::string reason = publish(too_deep);
    EXPECT_NE(reason.find("layer 1"), std::string::npos) << reason;
    EXPECT_NE(reason.find("point 4"), std::string::npos) << reason;
    EXPECT_NE(refusal_of(CommandKind::start), "") << "no job";
    EXPECT_EQ(status().state, MachineState::ready);
    EXPECT_EQ(steps_of_the_machine(), steps_before);
}

TEST_F(CoreFault, AJobForAnotherMachineIsRefusedWithTheKeysThatDiffer) {
    start_core();
    Profile other;
    other.r1.speed_mm_s = 9.0;
    const std::string reason = publish(lobed_job(3, 9, other));
    EXPECT_NE(reason.find("axis.r1.speed_mm_s"), std::string::npos) << reason;
}

TEST_F(CoreFault, AJobPublishedWhileAnotherRunsIsRefused) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    const std::string reason = publish(lobed_job(2, 9));
    EXPECT_NE(reason.find("runs"), std::string::npos) << reason;
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
}

TEST_F(CoreFault, AnUnlinkedSegmentIsAnAlarmOnANewOne) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    ASSERT_TRUE(Segment::remove(segment_name_));
    expect_alarm_on_a_new_segment();
}

TEST_F(CoreFault, ASegmentTruncatedWhileItCarvesIsAControlledStop) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    const std::string path = "/dev/shm" + segment_name_;
    ASSERT_EQ(truncate(path.c_str(), 4096), 0);
    expect_alarm_on_a_new_segment();
}

TEST_F(CoreFault, ATruncatedSegmentKillsNobody) {
    start_core();
    home();
    const std::string path = "/dev/shm" + segment_name_;
    ASSERT_EQ(truncate(path.c_str(), 4096), 0);
    expect_alarm_on_a_new_segment();
}

TEST_F(CoreFault, WhatALivingProcessPutInTheSegmentsPlaceIsNotTakenAway) {
    start_core();
    home();
    const std::string other_name = segment_name_ + "-other";
    SegmentOptions options;
    options.name = other_name;
    options.capacity_layers = 10;
    options.capacity_points = 10;
    auto other = Segment::create_or_attach(options);
    ASSERT_TRUE(other);
    other->header().layout_version = kLayoutVersion + 1;
    const std::string path = "/dev/shm" + segment_name_;
    ASSERT_EQ(rename(("/dev/shm" + other_name).c_str(), path.c_str()), 0);
    struct stat before {};
    ASSERT_EQ(stat(path.c_str(), &before), 0);
    std::this_thread::sleep_for(milliseconds{300});
    struct stat after {};
    ASSERT_EQ(stat(path.c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino);
    // As soon as it is gone the core makes its own.
    ASSERT_TRUE(Segment::remove(segment_name_));
    attach();
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }));
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::segment_lost);
}

}  // namespace
}  // namespace psicarve::two_process
