// SPDX-License-Identifier: GPL-3.0-or-later
// Rules 2 and 4 broken in one way at a time: each is found and named.
#include <gtest/gtest.h>

#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr SignalWord kLevelsCarving = kEnableMask | bit_of(Signal::spindle);

/// Pins from scratch, for timing that no machine of ours would make.
class Pins {
public:
    explicit Pins(const SampleJob& job) : machine_(job), job_(job) {
        machine_.start.initial_levels = levels_ = kEnableMask;
    }
    Pins& at(std::int64_t time_ns, Signal signal, bool level) {
        levels_ = level ? levels_ | bit_of(signal) : levels_ & ~bit_of(signal);
        machine_.events.push_back(
            {.time_ns = time_ns, .levels = levels_, .kind = TraceEvent::Kind::pins, .position_pulses = {}});
        return *this;
    }
    Pins& pulse(std::int64_t time_ns, Signal step) {
        return at(time_ns, step, true).at(time_ns + 20'000, step, false);
    }
    Pins& redefine(std::int64_t time_ns) {
        machine_.events.push_back({.time_ns = time_ns,
                                   .levels = levels_,
                                   .kind = TraceEvent::Kind::position,
                                   .position_pulses = {24000, 24000, 0, 0}});
        return *this;
    }
    Pins& initially(SignalWord levels) {
        machine_.start.initial_levels = levels_ = levels;
        return *this;
    }
    Pins& without(SignalWord wires) {
        machine_.start.present &= ~wires;
        return *this;
    }
    VerifyReport report() const { return verified(job_, machine_); }

private:
    PerfectMachine machine_;
    const SampleJob& job_;
    SignalWord levels_ = 0;
};

void expect_timing(const VerifyReport& report, const char* fault, double measured, double allowed) {
    const Offence& offence = first_of(report, 2);
    EXPECT_EQ(report.rules[1].offences, 1U);
    EXPECT_EQ(offence.fault, fault);
    EXPECT_EQ(offence.axis, Axis::r2);
    EXPECT_EQ(offence.measured, measured);
    EXPECT_EQ(offence.allowed, allowed);
    EXPECT_EQ(offence.unit, "ns");
    EXPECT_NE(offence.sentence.find("R2"), std::string::npos);
}

class PinOffence : public testing::Test {
protected:
    SampleJob job_ = wavy_job(Joining::continuous, 1, 5);
    Pins pins_{job_};
};

TEST_F(PinOffence, AShortStepPulseIsNamed) {
    pins_.at(100'000, Signal::r2_step, true).at(109'999, Signal::r2_step, false);
    expect_timing(pins_.report(), "step-high", 9'999, 10'000);
}

TEST_F(PinOffence, AShortGapBetweenStepsIsNamed) {
    pins_.pulse(100'000, Signal::r2_step).pulse(129'999, Signal::r2_step);
    expect_timing(pins_.report(), "step-low", 9'999, 10'000);
}

TEST_F(PinOffence, AShortDirectionSetupIsNamed) {
    pins_.at(100'000, Signal::r2_dir, true).pulse(104'000, Signal::r2_step);
    expect_timing(pins_.report(), "direction-setup", 4'000, 5'000);
}

TEST_F(PinOffence, AShortDirectionHoldIsNamed) {
    pins_.at(100'000, Signal::r2_step, true)
        .at(103'000, Signal::r2_dir, true)
        .at(120'000, Signal::r2_step, false);
    expect_timing(pins_.report(), "direction-hold", 3'000, 5'000);
}

TEST_F(PinOffence, ADirectionThatChangesWithTheStepHasNoSetup) {
    pins_.at(100'000, Signal::r2_dir, true)
        .at(100'000, Signal::r2_step, true)
        .at(120'000, Signal::r2_step, false);
    expect_timing(pins_.report(), "direction-setup", 0, 5'000);
}

TEST_F(PinOffence, TimingOfExactlyTheLimitsIsNone) {
    pins_.at(100'000, Signal::r2_dir, true)
        .at(105'000, Signal::r2_step, true)
        .at(115'000, Signal::r2_step, false);
    pins_.at(125'000, Signal::r2_step, true)
        .at(130'000, Signal::r2_dir, false)
        .at(135'000, Signal::r2_step, false);
    EXPECT_EQ(pins_.report().rules[1].offences, 0U);
}

TEST_F(PinOffence, APulseWhileDisabledIsNamed) {
    pins_.at(100'000, Signal::psi_enable, false).pulse(200'000, Signal::psi_step);
    const Offence offence = first_of(pins_.report(), 4);
    EXPECT_EQ(offence.fault, "disabled");
    EXPECT_EQ(offence.axis, Axis::psi);
    EXPECT_EQ(offence.time_ns, 200'000);
}

TEST_F(PinOffence, WithoutAnEnableWireDisabledIsNotJudged) {
    pins_.initially(0).without(kEnableMask).pulse(200'000, Signal::psi_step);
    EXPECT_EQ(pins_.report().rules[3].offences, 0U);
}

TEST_F(PinOffence, APulseAfterTheEmergencyStopIsNamed) {
    pins_.at(1'000'000, Signal::estop, true).pulse(1'050'000, Signal::r1_step);
    const Offence offence = first_of(pins_.report(), 4);
    EXPECT_EQ(offence.fault, "emergency-stop");
    EXPECT_EQ(offence.axis, Axis::r1);
    EXPECT_EQ(offence.measured, 50'000);
    EXPECT_EQ(offence.allowed, 50'000);
}

TEST_F(PinOffence, APulseWithinTheTickOfTheEmergencyStopIsNone) {
    pins_.at(1'000'000, Signal::estop, true).pulse(1'049'999, Signal::r1_step);
    EXPECT_EQ(pins_.report().rules[3].offences, 0U);
}

TEST_F(PinOffence, AnEmergencyStopThatBouncesBackStaysOneUntilTheDriveWasOff) {
    pins_.at(1'000'000, Signal::estop, true).at(1'200'000, Signal::estop, false);
    pins_.pulse(1'300'000, Signal::r1_step);
    pins_.at(1'400'000, Signal::r1_enable, false).at(1'500'000, Signal::r1_enable, true);
    pins_.pulse(1'600'000, Signal::r1_step);
    EXPECT_EQ(pins_.report().rules[3].offences, 1U);
}

TEST_F(PinOffence, APulsePastALimitWhileCarvingIsNamed) {
    pins_.initially(kLevelsCarving | bit_of(Signal::r1_dir)).at(1'000'000, Signal::r1_limit, true);
    pins_.pulse(1'100'000, Signal::r1_step).pulse(1'150'000, Signal::r1_step);
    const VerifyReport report = pins_.report();
    EXPECT_EQ(first_of(report, 4).fault, "limit");
    EXPECT_EQ(first_of(report, 4).axis, Axis::r1);
    EXPECT_EQ(first_of(report, 4).time_ns, 1'150'000);  // 100 us of filter and a tick are the core's
    EXPECT_EQ(report.rules[3].offences, 1U);
}

TEST_F(PinOffence, AnotherAxisAfterALimitIsNamed) {
    pins_.initially(kLevelsCarving).at(1'000'000, Signal::r1_limit, true).pulse(1'200'000, Signal::y_step);
    EXPECT_EQ(first_of(pins_.report(), 4).fault, "limit-alarm");
    EXPECT_EQ(first_of(pins_.report(), 4).axis, Axis::y);
}

TEST_F(PinOffence, ALimitThatChattersShorterThanTheFilterIsNone) {
    pins_.initially(kLevelsCarving)
        .at(1'000'000, Signal::r1_limit, true)
        .at(1'099'000, Signal::r1_limit, false);
    pins_.pulse(1'200'000, Signal::r1_step).pulse(1'300'000, Signal::y_step);
    EXPECT_EQ(pins_.report().rules[3].offences, 0U);
}

TEST_F(PinOffence, HomingMayBrakePastItsSensor) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    for (int n = 0; n < 51; ++n) pins_.pulse(2'000'000 + n * 500'000, Signal::r1_step);  // v^2/2a + 1
    pins_.redefine(40'000'000);
    EXPECT_EQ(pins_.report().rules[3].offences, 0U);
}

TEST_F(PinOffence, HomingThatRunsPastItsBoundIsNamed) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    for (int n = 0; n < 52; ++n) pins_.pulse(2'000'000 + n * 500'000, Signal::r1_step);
    pins_.redefine(40'000'000);
    const VerifyReport report = pins_.report();
    EXPECT_EQ(report.rules[3].offences, 1U);
    EXPECT_EQ(first_of(report, 4).measured, 52.0);
    EXPECT_EQ(first_of(report, 4).allowed, 51.0);
}

TEST_F(PinOffence, PulsesPastALimitThatNoHomingFollowsAreNamed) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    pins_.pulse(2'000'000, Signal::r1_step).pulse(2'500'000, Signal::r1_step);
    pins_.at(3'000'000, Signal::r1_enable, false).redefine(4'000'000);
    const VerifyReport report = pins_.report();
    EXPECT_EQ(report.rules[3].offences, 2U);
    EXPECT_EQ(first_of(report, 4).time_ns, 2'000'000);
}

TEST_F(PinOffence, HomingThatBacksOffUntilItsSensorClearsNeedsNoNewPositions) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    pins_.pulse(2'000'000, Signal::r1_step).pulse(2'500'000, Signal::r1_step);
    pins_.at(3'000'000, Signal::r1_dir, false).pulse(3'500'000, Signal::r1_step);
    pins_.pulse(4'000'000, Signal::r1_step).at(4'100'000, Signal::r1_limit, false);
    EXPECT_EQ(pins_.report().rules[3].offences, 0U);
}

TEST_F(PinOffence, ALimitThatClearsWithoutTheAxisBackingOffIsNoHoming) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    pins_.pulse(2'000'000, Signal::r1_step).at(2'500'000, Signal::r1_limit, false);
    EXPECT_EQ(pins_.report().rules[3].offences, 1U);
}

TEST_F(PinOffence, BackingOffWithTheSpindleOnIsNoHoming) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    pins_.pulse(2'000'000, Signal::r1_step).at(2'500'000, Signal::spindle, true);
    pins_.at(3'000'000, Signal::r1_dir, false).pulse(3'500'000, Signal::r1_step);
    pins_.at(4'100'000, Signal::r1_limit, false);
    EXPECT_EQ(pins_.report().rules[3].offences, 1U);
}

TEST_F(PinOffence, BackingOffAfterTheDriveWasOffIsNoHoming) {
    pins_.at(900'000, Signal::r1_dir, true).at(1'000'000, Signal::r1_limit, true);
    pins_.pulse(2'000'000, Signal::r1_step).at(2'500'000, Signal::r1_enable, false);
    pins_.at(2'600'000, Signal::r1_enable, true).at(3'000'000, Signal::r1_dir, false);
    pins_.pulse(3'500'000, Signal::r1_step).at(4'100'000, Signal::r1_limit, false);
    EXPECT_EQ(pins_.report().rules[3].offences, 1U);
}

TEST_F(PinOffence, BackingOffIsNone) {
    pins_.initially(kEnableMask | bit_of(Signal::r1_limit)).pulse(1'000'000, Signal::r1_step);
    EXPECT_EQ(pins_.report().rules[3].offences, 0U);
}

TEST_F(PinOffence, AllOfItIsInTheJsonReport) {
    pins_.at(100'000, Signal::psi_enable, false).pulse(200'000, Signal::psi_step);
    const std::string json = report_json(pins_.report());
    for (const char* wanted : {"\"verified\": false", "\"fault\": \"disabled\"", "\"axis\": \"psi\"",
                               "\"time_ns\": 200000", "\"points_total\": 5"})
        EXPECT_NE(json.find(wanted), std::string::npos) << wanted << " is not in " << json;
}

}  // namespace
}  // namespace psicarve::verify
