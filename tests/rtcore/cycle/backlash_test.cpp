// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/trace/trace_entry.hpp"
#include "shared/machine/recorded_gaps.hpp"
#include "shared/machine/recording_form.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/cycle/move_requests.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::array<std::int64_t, kAxisCount> kGaps{12, 20, 7, 30};

Profile with_backlash() {
    Profile profile = quick_profile();
    profile.r1.backlash_mm = 12.0 / 400.0;
    profile.r2.backlash_mm = 20.0 / 400.0;
    profile.psi.backlash_deg = 7.0 * 360.0 / 6400.0;
    profile.y.backlash_mm = 30.0 / 400.0;
    return profile;
}

/// The machine has the gaps; whether the core knows of them is the profile's matter.
MachineRig rig_of(const Profile& profile) {
    return MachineRig(profile, [](sim::SimConfig& config) {
        for (const Axis axis : kAllAxes) config.axis(axis).backlash_pulses = kGaps[index_of(axis)];
    });
}

Positions true_positions(const MachineRig& rig) {
    Positions at{};
    for (const Axis axis : kAllAxes) at[index_of(axis)] = rig.machine->position_pulses(axis);
    return at;
}

/// How far the tips are from where the core says they are; psi modulo a turn.
Positions errors(const MachineRig& rig) {
    Positions off = true_positions(rig);
    for (std::size_t k = 0; k < kAxisCount; ++k) off[k] -= rig.positions()[k];
    off[2] %= 6400;
    return off;
}

/// By the motor of Y, on a way down and one up again.
std::array<std::uint64_t, 2> pulses_of_a_jog(MachineRig& rig) {
    std::array<std::uint64_t, 2> pulses{};
    std::uint64_t before = rig.cycle->pulses().emitted()[kY];
    for (const bool up : {false, true}) {
        EXPECT_EQ(rig.ask(jog_request(Axis::y, up ? 40 : -40)), Refusal::none);
        EXPECT_TRUE(rig.run_until(MachineState::ready));
        const std::uint64_t now = rig.cycle->pulses().emitted()[kY];
        pulses[up ? 1 : 0] = now - std::exchange(before, now);
    }
    return pulses;
}

TEST(Backlash, HomingFindsTheTruePositionWhateverTheGapStandsAt) {
    std::mt19937_64 random{23};
    for (int round = 0; round < 8; ++round) {
        MachineRig sut(with_backlash(), [&](sim::SimConfig& config) {
            for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
                config.axis(axis).start_pulses = 500 + static_cast<std::int64_t>(random() % 7000);
            }
            config.axis(Axis::psi).start_pulses = static_cast<std::int64_t>(random() % 6400);
        });
        ASSERT_TRUE(sut.home()) << round;
        EXPECT_EQ(errors(sut), Positions{}) << round;
        ASSERT_TRUE(sut.home()) << "again, from where it stands now";
        EXPECT_EQ(errors(sut), Positions{}) << round;
    }
}

TEST(Backlash, MovesAndJogsPutTheTipsWhereTheyAreSent) {
    std::mt19937_64 random{29};
    MachineRig sut(with_backlash());
    ASSERT_TRUE(sut.home());
    for (int round = 0; round < 25; ++round) {
        const auto pick = [&](std::int64_t least, std::uint64_t span) {
            return least + static_cast<std::int64_t>(random() % span);
        };
        if (round % 2 == 0) {
            const Positions to{pick(1000, 6000), pick(1000, 6000), pick(0, 6000), pick(100, 7000)};
            ASSERT_EQ(sut.ask(move_request(
                          {{Axis::r1, to[0]}, {Axis::r2, to[1]}, {Axis::psi, to[2]}, {Axis::y, to[3]}})),
                      Refusal::none);
            ASSERT_TRUE(sut.run_until(MachineState::ready));
            EXPECT_EQ(sut.positions(), to);
        } else {
            ASSERT_EQ(sut.ask(jog_request(Axis::r1, pick(-40, 81))), Refusal::none);
            ASSERT_TRUE(sut.run_until(MachineState::ready));
        }
        ASSERT_EQ(errors(sut), Positions{}) << round;
    }
}

TEST(Backlash, OnlyAReversalCostsPulsesAndExactlyTheGap) {
    MachineRig sut(with_backlash());
    ASSERT_TRUE(sut.home());
    const auto pulses_of = [&](std::int64_t way) {
        const std::uint64_t before = sut.cycle->pulses().emitted()[0];
        sut.ask(jog_request(Axis::r1, way));
        EXPECT_TRUE(sut.run_until(MachineState::ready));
        return static_cast<std::int64_t>(sut.cycle->pulses().emitted()[0] - before);
    };
    pulses_of(-100);
    EXPECT_EQ(pulses_of(-100), 100);
    EXPECT_EQ(pulses_of(50), 50 + kGaps[0]);
    EXPECT_EQ(pulses_of(1), 1);
    EXPECT_EQ(pulses_of(-1), 1 + kGaps[0]);
}

// The flight recorder says how much of the gap is left: a replay takes up that much, in the same ticks.
TEST(Backlash, AReplayBeginsInTheGapWhereAJogWasLetGo) {
    int within = 0;
    for (std::uint64_t ticks = 5; ticks < 600; ticks += 45) {
        MachineRig sut(with_backlash());
        ASSERT_TRUE(sut.home());
        sut.ask(jog_request(Axis::y, 1000));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        ASSERT_EQ(sut.ask(jog_on_request(Axis::y, false, 300.0, 100'000)), Refusal::none);
        sut.run(ticks);
        sut.io->urgent.jog_lease.store(jog_lease_word(kToken, 0));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        const std::int64_t crossed = sut.cycle->pulses().crossed_pulses()[kY];
        within += crossed > 0 && crossed < kGaps[kY] ? 1 : 0;
        const FlightRecord rest = sut.records_of(RecordKind::state_change).back();
        MachineRig replayed(with_backlash(), [&](sim::SimConfig& config) {
            for (const Axis axis : kAllAxes) config.axis(axis).start_pulses = sut.positions()[index_of(axis)];
        });
        replayed.cycle->assume_homed(sut.positions(), rest.signals, gaps_left(rest.value));
        EXPECT_EQ(replayed.cycle->pulses().crossed_pulses(), sut.cycle->pulses().crossed_pulses()) << ticks;
        EXPECT_EQ(pulses_of_a_jog(replayed), pulses_of_a_jog(sut)) << ticks;
    }
    EXPECT_GT(within, 2);
}

TEST(Backlash, AJogThatIsLetGoInTheGapLosesNothing) {
    for (std::uint64_t ticks = 5; ticks < 600; ticks += 45) {
        MachineRig sut(with_backlash());
        ASSERT_TRUE(sut.home());
        sut.ask(jog_request(Axis::y, 1000));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        ASSERT_EQ(sut.ask(jog_on_request(Axis::y, false, 300.0, 100'000)), Refusal::none);
        sut.run(ticks);
        sut.io->urgent.jog_lease.store(jog_lease_word(kToken, 0));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(errors(sut), Positions{}) << ticks;
        sut.ask(jog_request(Axis::y, ticks % 2 == 0 ? 33 : -33));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(errors(sut), Positions{}) << ticks;
    }
}

/// What a recording's begin tells of the gaps, and what is true of the machine.
void expect_true_gaps(MachineRig& rig, const std::string& when) {
    const auto ring = std::make_unique<trace::TraceRing>();
    rig.io->trace = ring.get();
    Request request{};
    request.kind = RequestKind::record;
    request.value = static_cast<std::uint64_t>(RecordingForm::binary);
    request.lease_token = kToken;
    ASSERT_EQ(rig.ask(request), Refusal::none) << when;
    trace::TraceEntry begin{};
    ASSERT_TRUE(ring->pop_into(begin)) << when;
    ASSERT_EQ(begin.kind, trace::TraceEntry::Kind::begin_binary) << when;
    const sim::SimReport report = rig.machine->report();
    for (const Axis axis : kAllAxes) {
        const sim::AxisReport& at = report.axis(axis);
        EXPECT_EQ(begin.crossed_pulses[index_of(axis)], at.position_pulses - at.motor_pulses)
            << when << ": " << name_of(axis);
    }
    request.value = static_cast<std::uint64_t>(RecordingForm::none);
    ASSERT_EQ(rig.ask(request), Refusal::none) << when;
    rig.io->trace = nullptr;
}

TEST(Backlash, ARecordingTellsAtItsBeginWhereTheMotorsStandInTheirGaps) {
    MachineRig sut(with_backlash());
    sut.io->traces_always = false;
    expect_true_gaps(sut, "before homing");
    ASSERT_TRUE(sut.home());
    expect_true_gaps(sut, "homed");
    for (const std::int64_t r1 : {3000, 5000, 4000}) {
        ASSERT_EQ(sut.ask(move_request(
                      {{Axis::r1, r1}, {Axis::r2, 9000 - r1}, {Axis::psi, r1 / 2}, {Axis::y, 8000 - r1}})),
                  Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        expect_true_gaps(sut, "moved to " + std::to_string(r1));
    }
    ASSERT_EQ(sut.ask(jog_request(Axis::y, 300)), Refusal::none);
    sut.run(100);
    sut.emergency_stop();
    ASSERT_TRUE(sut.run_until(MachineState::alarm));
    ASSERT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::off));
    expect_true_gaps(sut, "after an alarm");
}

TEST(Backlash, ARecordingTellsAGapThatAStopLeftHalfCrossed) {
    int partly = 0;
    for (std::uint64_t ticks = 5; ticks < 600; ticks += 45) {
        MachineRig sut(with_backlash());
        sut.io->traces_always = false;
        ASSERT_TRUE(sut.home());
        sut.ask(jog_request(Axis::y, 1000));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        ASSERT_EQ(sut.ask(jog_on_request(Axis::y, false, 300.0, 100'000)), Refusal::none);
        sut.run(ticks);
        sut.io->urgent.jog_lease.store(jog_lease_word(kToken, 0));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        const std::int64_t crossed = sut.cycle->pulses().crossed_pulses()[index_of(Axis::y)];
        partly += crossed > 0 && crossed < kGaps[index_of(Axis::y)] ? 1 : 0;
        expect_true_gaps(sut, "let go after " + std::to_string(ticks));
    }
    EXPECT_GE(partly, 3);
}

TEST(Backlash, ARecordingTellsTheGapsBehindACarvingAndAPartOfOne) {
    MachineRig sut(with_backlash());
    sut.io->traces_always = false;
    const JobTable job = random_job(3, 10, 5, Joining::zigzag);
    ASSERT_TRUE(sut.prepare(job));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_true_gaps(sut, "carved");
    ASSERT_EQ(sut.ask(RequestKind::start), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::waiting));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    sut.run(5000);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_true_gaps(sut, "stopped");
}

/// Carves from where the heads wait, point `next` of the job; the largest error of any tip at any point.
Positions worst_errors_from(MachineRig& rig, const JobTable& job, std::size_t next) {
    const auto points = points_of(job);
    Positions worst{};
    rig.ask(RequestKind::start_interpolation);
    rig.run_while([&] {
        const std::uint64_t reached = rig.cycle->sample().points_done;
        for (; next < reached && next < points.size(); ++next) {
            if (next + 1 < reached) continue;
            EXPECT_EQ(rig.positions(), points[next]) << next;
            const Positions off = errors(rig);
            for (std::size_t k = 0; k < kAxisCount; ++k) worst[k] = std::max(worst[k], std::abs(off[k]));
        }
        return rig.cycle->state() == MachineState::carving;
    });
    EXPECT_EQ(next, points.size());
    for (const Axis axis : kAllAxes) EXPECT_EQ(rig.machine->report().axis(axis).stalls, 0U) << name_of(axis);
    return worst;
}

/// Of the whole job.
Positions worst_errors_at_points(MachineRig& rig, const JobTable& job) {
    EXPECT_TRUE(rig.prepare(job));
    return worst_errors_from(rig, job, 0);
}

// What the gaps take up on the way to the first point lies in the approach, whichever point that is.
TEST(Backlash, ATableThatIsBegunWithinALayerIsExactFromItsFirstPointOn) {
    constexpr std::uint32_t kPoints = 40;
    std::mt19937_64 random{41};
    for (const Planner planner : {Planner::angle, Planner::lookahead}) {
        for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
            Profile profile = with_backlash();
            profile.job.planner = planner;
            MachineRig sut = rig_of(profile);
            const JobTable job = random_job(3, kPoints, 5, joining);
            ASSERT_TRUE(sut.home());
            sut.load(job);
            for (const std::uint32_t layer : {0U, 1U, 2U}) {
                const auto step = static_cast<std::uint32_t>(1 + random() % (kPoints - 2));
                const std::uint32_t number = carved_point(joining, kPoints, layer, step) + 1;
                ASSERT_EQ(sut.ask(RequestKind::start, 0,
                                  packed({.first = layer, .count = 0, .point_number = number})),
                          Refusal::none);
                ASSERT_TRUE(sut.run_until(MachineState::waiting));
                EXPECT_EQ(errors(sut), Positions{}) << "layer " << layer << ", step " << step;
                EXPECT_EQ(worst_errors_from(sut, job, std::size_t{layer} * kPoints + step), Positions{});
                ASSERT_TRUE(sut.run_until(MachineState::ready));
            }
        }
    }
}

TEST(Backlash, ACarvedTableIsExactWithItsCompensation) {
    for (const Planner planner : {Planner::angle, Planner::lookahead}) {
        for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
            Profile profile = with_backlash();
            profile.job.planner = planner;
            MachineRig sut = rig_of(profile);
            EXPECT_EQ(worst_errors_at_points(sut, random_job(3, 40, 5, joining)), Positions{});
        }
    }
}

TEST(Backlash, ACarvedTableIsOffByTheGapWithoutCompensation) {
    MachineRig sut = rig_of(quick_profile());
    const Positions worst = worst_errors_at_points(sut, random_job(3, 40, 5, Joining::zigzag));
    EXPECT_EQ(worst[0], kGaps[0]);
    EXPECT_EQ(worst[1], kGaps[1]);
    EXPECT_EQ(worst[2], kGaps[2]);
}

TEST(Backlash, HoldAndResumeInTheMidstOfTakingUpLoseNothing) {
    std::mt19937_64 random{37};
    const JobTable job = random_job(2, 30, 5, Joining::zigzag);
    const auto points = points_of(job);
    MachineRig sut(with_backlash());
    ASSERT_TRUE(sut.prepare(job));
    sut.ask(RequestKind::start_interpolation);
    int held = 0;
    while (sut.cycle->state() == MachineState::carving) {
        sut.run(1 + random() % 400);
        if (sut.ask(RequestKind::hold) != Refusal::none) continue;
        ASSERT_TRUE(sut.run_until(MachineState::held));
        EXPECT_EQ(errors(sut), Positions{});
        ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
        ++held;
    }
    EXPECT_GT(held, 50);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.cycle->sample().points_done, points.size());
    EXPECT_EQ(errors(sut), Positions{});
    for (const Axis axis : kAllAxes) EXPECT_EQ(sut.machine->report().axis(axis).stalls, 0U) << name_of(axis);
}

TEST(Backlash, AStopInTheMidstOfTakingUpKeepsTheTruth) {
    for (std::uint64_t ticks = 100; ticks < 6000; ticks += 370) {
        MachineRig sut(with_backlash());
        ASSERT_TRUE(sut.prepare(random_job(1, 30, 5)));
        sut.ask(RequestKind::start_interpolation);
        sut.run(ticks);
        sut.stop();
        ASSERT_TRUE(sut.run_until(MachineState::ready)) << ticks;
        EXPECT_EQ(errors(sut), Positions{}) << ticks;
    }
}

}  // namespace
}  // namespace psicarve::cycle
