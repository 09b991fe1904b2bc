// SPDX-License-Identifier: GPL-3.0-or-later
// Rule 3 on whole traces: what is named, and what is not judged.
#include "hmi/verify/motor_rule.hpp"

#include <gtest/gtest.h>

#include <string>

#include "shared/base/units.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::int64_t kGap_ns = 250'000;  // 4000 pulses a second, the default's top speed

/// R1 at top speed for a while, then at once still.
class StoppedAtOnce : public testing::Test {
protected:
    StoppedAtOnce() {
        sut_.begin(50'000);
        for (int i = 0; i < 400; ++i) pulse();
    }
    void pulse() { sut_.pulse(Axis::r1, true, now_ns_ += kGap_ns, {}); }
    std::uint64_t offences() {
        sut_.finish(now_ns_ + kNsPerS);
        return log_.result(3).offences;
    }

    SignalWord levels_ = kEnableMask | bit_of(Signal::spindle);
    std::int64_t now_ns_ = 0;
    OffenceLog log_;
    MotorRule sut_{Profile{}, log_};
};

TEST_F(StoppedAtOnce, IsAnOffence) {
    EXPECT_EQ(offences(), 1U);
    ASSERT_TRUE(log_.result(3).first);
    EXPECT_EQ(log_.result(3).first->axis, Axis::r1);
    EXPECT_EQ(log_.result(3).first->fault, "acceleration");
}

TEST_F(StoppedAtOnce, IsNoneAtAnEmergencyStop) {
    sut_.levels_changed(levels_, levels_ | bit_of(Signal::estop), now_ns_ + 1);
    EXPECT_EQ(offences(), 0U);
}

TEST_F(StoppedAtOnce, IsNoneOnceALimitCounts) {
    sut_.levels_changed(levels_, levels_ | bit_of(Signal::r1_limit), now_ns_ + kGap_ns / 2);
    EXPECT_EQ(offences(), 0U);
}

TEST_F(StoppedAtOnce, IsAnOffenceWhenTheLimitCameLongBefore) {
    sut_.levels_changed(levels_, levels_ | bit_of(Signal::r1_limit), now_ns_ + 1);
    for (int i = 0; i < 100; ++i) pulse();
    EXPECT_EQ(offences(), 1U);
}

// Behind a limit a motor is judged again as soon as the core had to heed it: filter and one tick, 0.15 ms.
TEST_F(StoppedAtOnce, IsAnOffenceAgainSoonAfterALimit) {
    sut_.levels_changed(levels_, levels_ | bit_of(Signal::r1_limit), now_ns_ + 1);
    now_ns_ += kNsPerMs;
    for (int i = 0; i < 30; ++i) pulse();  // for 7.5 ms at top speed, from rest and to rest at once
    EXPECT_GE(offences(), 1U);
}

TEST_F(StoppedAtOnce, IsNoneWhenItsDriveIsSwitchedOff) {
    sut_.levels_changed(levels_, levels_ & ~bit_of(Signal::r1_enable), now_ns_ + 1);
    EXPECT_EQ(offences(), 0U);
}

TEST_F(StoppedAtOnce, IsAnOffenceWhenAnotherDriveIsSwitchedOff) {
    sut_.levels_changed(levels_, levels_ & ~bit_of(Signal::r2_enable), now_ns_ + 1);
    EXPECT_EQ(offences(), 1U);
}

TEST_F(StoppedAtOnce, IsAnOffenceWhenTheIndexPasses) {
    sut_.levels_changed(levels_, levels_ | bit_of(Signal::psi_index), now_ns_ + 1);
    EXPECT_EQ(offences(), 1U);
}

/// The pins of a perfect machine in less time.
PerfectMachine hurried(const SampleJob& job, std::int64_t factor) {
    PerfectMachine machine(job);
    machine.carve_job();
    for (TraceEvent& event : machine.events) event.time_ns /= factor;
    return machine;
}

TEST(MotorOffence, IsNamedWithAxisTimePointMeasuredAndAllowed) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach();
    const std::size_t begin = machine.events.size();
    machine.wait(kNsPerS).layer(0);
    const std::int64_t begin_ns = machine.events[begin].time_ns;
    for (std::size_t i = begin; i < machine.events.size(); ++i)  // 2000 pulses a second from rest
        machine.events[i].time_ns = begin_ns + (machine.events[i].time_ns - begin_ns) / 5;
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 3);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(offence.fault, "acceleration");
    EXPECT_EQ(offence.axis, Axis::psi);
    EXPECT_GT(offence.time_ns, begin_ns);
    EXPECT_LT(offence.time_ns, begin_ns + 50 * kNsPerMs);
    EXPECT_EQ(offence.layer, 0U);
    EXPECT_EQ(offence.point, 1U);
    EXPECT_EQ(offence.unit, "deg/s2");
    EXPECT_DOUBLE_EQ(offence.allowed, 2250.0);
    EXPECT_GT(offence.measured, 1.05 * offence.allowed);
    EXPECT_EQ(offence.sentence.substr(0, 58), "rule 3: psi asks its motor for more acceleration than it h");
    EXPECT_NE(offence.sentence.find("in layer 0 at point 1, "), std::string::npos) << offence.sentence;
    EXPECT_NE(offence.sentence.find(" deg/s2 measured, 2250 deg/s2 allowed"), std::string::npos);
}

TEST(MotorOffence, IsNoneInAPerfectTrace) {
    const SampleJob job = wavy_job();
    const VerifyReport report = verified(job, hurried(job, 1));
    EXPECT_TRUE(report.rules[2].judged);
    EXPECT_EQ(report.rules[2].offences, 0U);
}

TEST(MotorOffence, OfTooMuchSpeedSaysSo) {
    SampleJob job = wavy_job();
    job.profile.psi.speed_deg_s = 22.5;  // 400 pulses a second
    const VerifyReport report = verified(job, hurried(job, 2));
    const Offence& offence = first_of(report, 3);
    EXPECT_EQ(offence.fault, "speed");
    EXPECT_EQ(offence.axis, Axis::psi);
    EXPECT_EQ(offence.unit, "deg/s");
    EXPECT_DOUBLE_EQ(offence.allowed, 22.5);
    EXPECT_NEAR(offence.measured, 45.0, 1.5);
}

}  // namespace
}  // namespace psicarve::verify
