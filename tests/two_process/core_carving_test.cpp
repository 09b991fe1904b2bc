// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreCarving : public CoreRig {};

TEST_F(CoreCarving, CarvesAPublishedJobToTheLastPoint) {
    start_core();
    EXPECT_EQ(status().state, MachineState::off);
    home();
    EXPECT_EQ(status().homed_mask, 0xF);
    ASSERT_EQ(publish(lobed_job(4, 33)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    const CoreStatus end = status();
    EXPECT_EQ(end.state, MachineState::ready);
    EXPECT_EQ(end.points_done, 4U * 33U);
    EXPECT_LT(end.carve_first_tick, end.carve_last_tick);
    EXPECT_LT(end.carve_last_tick, end.job_end_tick);
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(end.sim_true_position_pulses[index_of(axis)], end.position_pulses[index_of(axis)])
            << name_of(axis);
        EXPECT_EQ(end.sim_ignored_pulses[index_of(axis)] + end.sim_timing_lost[index_of(axis)], 0U)
            << name_of(axis);
        EXPECT_EQ(end.sim_stalls[index_of(axis)], 0U) << name_of(axis);
    }
    EXPECT_EQ(end.alarm_count, 0U);
}

TEST_F(CoreCarving, TheTimeIsKnownBeforeTheStart) {
    start_core();
    home();
    ASSERT_EQ(publish(lobed_job(6, 33)), "");
    ASSERT_TRUE(eventually([&] { return status().seconds_left >= 0.0; }));
    const CoreStatus before = status();
    EXPECT_GT(before.seconds_left, 0.0);
    EXPECT_EQ(before.reference_seconds, before.seconds_left);
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    const CoreStatus end = status();
    const double carved_s = static_cast<double>(end.carve_last_tick - end.carve_first_tick) *
                            static_cast<double>(end.period_ns) * 1e-9;
    EXPECT_NEAR(carved_s, before.seconds_left, 0.01 * carved_s);
    EXPECT_EQ(end.reference_seconds, before.reference_seconds);
    ASSERT_EQ(publish(lobed_job(12, 33)), "");
    ASSERT_TRUE(eventually([&] { return status().seconds_left > 1.5 * before.seconds_left; }));
    EXPECT_GT(status().reference_seconds, 1.5 * before.reference_seconds);
}

TEST_F(CoreCarving, OfARunThatAnAlarmEndedNoForecastIsToldAtRest) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().is_left_forecast != 0U; }));
    request_emergency_stop(*segment_);
    ASSERT_TRUE(eventually([&] {
        const CoreStatus now = status();
        EXPECT_TRUE(runs_job(now.state) || now.reference_seconds >= 0.0 || now.seconds_left < 0.0);
        return now.reference_seconds >= 0.0;
    }));
    ASSERT_TRUE(eventually([&] { return !runs_job(status().state); }));
    EXPECT_EQ(status().is_left_forecast, 0U);
    EXPECT_EQ(status().seconds_left, status().reference_seconds) << "of the whole job";
}

TEST_F(CoreCarving, WhoSeesAJobAcceptedReadsNoTimesOfTheJobBefore) {
    start_core();
    ASSERT_EQ(publish(lobed_job(6, 33)), "");
    for (std::uint32_t layers = 7; layers < 17; ++layers) {
        ASSERT_TRUE(eventually([&] { return status().seconds_left >= 0.0; }));
        const CoreStatus before = status();
        const auto generation = publish_job(*segment_, job_blob_from_table(lobed_job(layers, 33)));
        ASSERT_TRUE(generation);
        const auto verdict = [&] { return read_record(segment_->header().verdict).value_or(JobVerdict{}); };
        // At once: what is tried is over a moment later.
        const auto end = std::chrono::steady_clock::now() + kLimit;
        while (verdict().generation != *generation) ASSERT_LT(std::chrono::steady_clock::now(), end);
        const CoreStatus accepted = status();
        ASSERT_EQ(accepted.job_generation, *generation);
        EXPECT_NE(accepted.seconds_left, before.seconds_left) << layers;
        EXPECT_NE(accepted.reference_seconds, before.reference_seconds) << layers;
    }
}

TEST_F(CoreCarving, AStoppedJobIsCarvedOnFromALayer) {
    start_core();
    home();
    ASSERT_EQ(publish(lobed_job(6, 33)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 2 * 33; }));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    for (const double layer : {6.0, 1e9, 2.5, -1.0}) {
        EXPECT_NE(refusal_of(CommandKind::start, layer).find("layer"), std::string::npos) << layer;
    }
    ASSERT_EQ(refusal_of(CommandKind::start, 2.0), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    EXPECT_EQ(status().layer, 2U);
    EXPECT_EQ(status().points_done, 2U * 33U + 1U);
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    const CoreStatus end = status();
    EXPECT_EQ(end.points_done, end.points_total);
    EXPECT_EQ(end.layer, 5U);
    EXPECT_LT(end.carve_first_tick, end.carve_last_tick);
    ASSERT_TRUE(eventually([&] { return status().reference_seconds >= 0.0; }));
    const double carved_s = static_cast<double>(end.carve_last_tick - end.carve_first_tick) *
                            static_cast<double>(end.period_ns) * 1e-9;
    EXPECT_GT(status().reference_seconds, 1.2 * carved_s) << "T_ref is of whole jobs";
    for (const Axis axis : kAllAxes) {
        // Whole turns were dropped from the count on the way.
        const std::int64_t off =
            end.sim_true_position_pulses[index_of(axis)] - end.position_pulses[index_of(axis)];
        EXPECT_EQ(axis == Axis::psi ? off % Profile{}.psi.pulses_per_rev : off, 0) << name_of(axis);
    }
}

TEST_F(CoreCarving, OneLayerIsCarvedAndThenTheRest) {
    start_core();
    home();
    ASSERT_EQ(publish(lobed_job(6, 33)), "");
    Command start{};
    start.kind = CommandKind::start;
    start.value = 5.0;
    start.value2 = 2;
    EXPECT_NE(refusal_of(start).find("not so many layers"), std::string::npos);
    start.value = 2.0;
    start.value2 = 1;
    ASSERT_EQ(refusal_of(start), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    const CoreStatus one = status();
    EXPECT_EQ(one.state, MachineState::ready);
    EXPECT_EQ(one.points_done, 3U * 33U);
    EXPECT_EQ(one.layer, 2U);
    EXPECT_LT(one.carve_first_tick, one.carve_last_tick);
    ASSERT_TRUE(eventually([&] { return status().reference_seconds >= 0.0; }));
    const double carved_s = static_cast<double>(one.carve_last_tick - one.carve_first_tick) *
                            static_cast<double>(one.period_ns) * 1e-9;
    EXPECT_GT(status().reference_seconds, 3.0 * carved_s) << "T_ref is of whole jobs";
    ASSERT_EQ(refusal_of(CommandKind::start, 3.0), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(eventually([&] { return status().points_done == 6U * 33U && status().job_end_tick != 0; }));
}

TEST_F(CoreCarving, HoldRestsOnThePathAndResumeGoesOn) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    ASSERT_EQ(refusal_of(CommandKind::hold), "");
    ASSERT_TRUE(reaches(MachineState::held));
    const CoreStatus held = status();
    EXPECT_NE(held.signals & bit_of(Signal::spindle), 0U) << "the spindle stays on";
    EXPECT_LT(held.points_done, held.points_total);
    ASSERT_EQ(refusal_of(CommandKind::resume), "");
    EXPECT_TRUE(eventually([&] { return status().points_done > held.points_done + 1000; }));
    EXPECT_EQ(status().state, MachineState::carving);
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(status().sim_true_position_pulses[index_of(axis)],
                  status().position_pulses[index_of(axis)]);
    }
}

TEST_F(CoreCarving, AnOverrideBeyondItsBoundsIsRefusedByName) {
    start_core();
    ASSERT_EQ(refusal_of(CommandKind::override, 60.0), "");
    for (const double percent : {9.0, 201.0, 99.5, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_NE(refusal_of(CommandKind::override, percent).find("override: 10 to 200"), std::string::npos)
            << percent;
    }
    EXPECT_EQ(status().override_percent, 60U);
}

TEST_F(CoreCarving, StopEndsTheJobWithTheSpindleOffAndTheMachineHomed) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    const CoreStatus stopped = status();
    EXPECT_LT(stopped.points_done, stopped.points_total);
    EXPECT_EQ(stopped.signals & bit_of(Signal::spindle), 0U);
    EXPECT_EQ(stopped.signals & kEnableMask, kEnableMask) << "drives stay enabled";
    EXPECT_EQ(stopped.homed_mask, 0xF);
    EXPECT_EQ(stopped.sim_true_position_pulses[0], stopped.position_pulses[0]);
}

TEST_F(CoreCarving, EmergencyStopIsAnAlarmThatHomingFollows) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    const CoreStatus alarm = status();
    EXPECT_EQ(alarm.alarm_cause, AlarmCause::emergency_stop);
    EXPECT_EQ(alarm.signals & (kEnableMask | bit_of(Signal::spindle)), 0U);
    EXPECT_EQ(alarm.alarm_count, 1U);
    EXPECT_EQ(alarm.alarms[0].cause, AlarmCause::emergency_stop);
    EXPECT_NE(refusal_of(CommandKind::start).find("alarm"), std::string::npos);
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    ASSERT_TRUE(reaches(MachineState::off));
    home();
}

TEST_F(CoreCarving, CommandsOutOfPlaceAreRefusedWithTheReason) {
    start_core();
    EXPECT_NE(refusal_of(CommandKind::start), "");
    EXPECT_NE(refusal_of(CommandKind::resume), "");
    home();
    EXPECT_NE(refusal_of(CommandKind::start).find("publish"), std::string::npos);
    EXPECT_NE(refusal_of(CommandKind::back_off, Axis::r1), "");
    EXPECT_EQ(status().state, MachineState::ready);
}

TEST_F(CoreCarving, ResetHeightDefinesYByItsSensor) {
    start_core();
    home();
    ASSERT_EQ(refusal_of(CommandKind::reset_height), "");
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(status().sim_true_position_pulses[index_of(Axis::y)],
              status().position_pulses[index_of(Axis::y)]);
}

TEST_F(CoreCarving, AJobPublishedWhileTheMachineHomesWaitsAndIsAccepted) {
    start_core();
    ASSERT_EQ(refusal_of(CommandKind::home), "");
    ASSERT_EQ(publish(lobed_job(2, 9)), "");
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(status().job_generation, 1U);
}

TEST_F(CoreCarving, AJobPublishedBeforeTheCoreStartsIsThereForIt) {
    SegmentOptions options;
    options.name = segment_name_;
    auto made = Segment::create_or_attach(options);
    ASSERT_TRUE(made);
    ASSERT_TRUE(publish_job(*made, job_blob_from_table(lobed_job(2, 9))));
    start_core();
    home();
    EXPECT_EQ(status().job_generation, 1U);
    start_carving();
    EXPECT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
}

TEST_F(CoreCarving, AProfileThatAsksTooMuchOfTheMotorsLosesStepsThatTheStatusShows) {
    Profile hasty;
    hasty.r1.speed_mm_s = 20.0;
    hasty.r2.speed_mm_s = 20.0;
    const std::string text = profile_to_toml(hasty);
    ASSERT_TRUE(write_file_atomically(file("hasty.toml"), std::as_bytes(std::span{text})));
    const std::string real = profile_to_toml(Profile{});
    ASSERT_TRUE(write_file_atomically(file("real.toml"), std::as_bytes(std::span{real})));
    start_core({"--profile", file("hasty.toml"), "--machine", file("real.toml")});
    home();
    ASSERT_EQ(publish(lobed_job(4, 33, hasty)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    const CoreStatus end = status();
    EXPECT_GT(end.sim_stalls[index_of(Axis::r1)], 0U);
    EXPECT_NE(end.sim_true_position_pulses[index_of(Axis::r1)], end.position_pulses[index_of(Axis::r1)]);
    EXPECT_EQ(end.sim_stalls[index_of(Axis::psi)], 0U);
}

TEST_F(CoreCarving, ShutdownEndsACoreAtRest) {
    start_core();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    EXPECT_FALSE(segment_->core_pid().has_value());
}

TEST_F(CoreCarving, TerminationStopsTheJobBeforeTheCoreEnds) {
    start_core();
    home();
    ASSERT_EQ(publish(long_job()), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 10; }));
    core_->send_signal(SIGTERM);
    EXPECT_EQ(core_->wait_for_exit(), 0);
    EXPECT_EQ(status().signals & (kEnableMask | bit_of(Signal::spindle)), 0U);
}

}  // namespace
}  // namespace psicarve::two_process
