// SPDX-License-Identifier: GPL-3.0-or-later
// A whole carving, then a start: what the flight recorder says that it did, by what the pins did. Only pins
// that did it are right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_start.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint32_t kStartPoints = 21;
constexpr std::uint32_t kStartLayers = 4;
constexpr std::int64_t kOut_pulses = 2000;

/// What a start asked for, and how it ended.
struct LastStart {
    const char* name;
    std::uint32_t layer = 0;
    std::uint32_t layers = 0;  ///< 0: all that follow
    bool is_told = true;       ///< to carve
    bool is_dry = false;
    std::uint32_t cut_behind = 0;  ///< points; 0: it came to its end
    bool is_status_known = true;   ///< where not, the recorder's positions tell alone
    bool is_far = false;           ///< it was called off before the heads came near the first point
};

enum class Went { right, only_in, wrong, early, none };

class ToldStarts {
public:
    explicit ToldStarts(const JobView& job) : job_(job) { state(MachineState::ready, 0); }

    void take(const LastStart& start) {
        const std::uint64_t dry = start.is_dry ? kRecordedDryRun : 0;
        spindle_ = false;
        const std::uint64_t layers = std::uint64_t{start.layers} << 32U;
        command(CommandKind::start, dry | start.layer | layers, start.layer);
        spindle_ = !start.is_dry;
        is_far_ = start.is_far;
        state(start.is_far ? MachineState::stopping : MachineState::waiting, start.layer);
        std::uint32_t end = start.layer;
        std::uint32_t step = 0;
        if (start.is_told) {
            command(CommandKind::start_interpolation, 0, start.layer);
            const std::uint32_t layers_done = start.layers == 0 ? kStartLayers - start.layer : start.layers;
            end = start.layer +
                  (start.cut_behind != 0 ? (start.cut_behind - 1) / kStartPoints : layers_done - 1);
            step = start.cut_behind != 0 ? (start.cut_behind - 1) % kStartPoints : kStartPoints - 1;
            points_done = start.layer * kStartPoints +
                          (start.cut_behind != 0 ? start.cut_behind : layers_done * kStartPoints);
        } else {
            points_done = start.layer * kStartPoints + 1;
        }
        if (!start.is_status_known) points_done = 0;
        if (!start.is_told || start.cut_behind != 0) add(RecordKind::stop, 0, 0, end, step);
        spindle_ = false;
        state(MachineState::ready, end, step);
        is_far_ = false;
    }

    std::vector<FlightRecord> records;
    std::uint64_t points_done = 0;

private:
    void add(RecordKind kind, std::uint16_t code, std::uint64_t value, std::uint32_t layer,
             std::uint32_t step = 0) {
        FlightRecord record{};
        record.kind = kind;
        record.code = code;
        record.value = static_cast<std::int64_t>(value);
        record.answer = static_cast<std::uint32_t>(AnswerKind::done);
        record.signals = spindle_ ? bit_of(Signal::spindle) : 0;
        const std::uint32_t point = carved_point(job_.joining(), job_.point_count(), layer, step);
        record.position_pulses[0] = job_.r_left_pulses(layer)[point];
        if (is_far_) record.position_pulses[0] += kOut_pulses;
        record.position_pulses[1] = job_.r_right_pulses(layer)[point];
        record.position_pulses[2] = job_.psi_pulses(layer, point);
        record.position_pulses[3] = job_.y_pulses(layer, point);
        records.push_back(record);
    }
    void command(CommandKind kind, std::uint64_t value, std::uint32_t layer) {
        add(RecordKind::command, static_cast<std::uint16_t>(kind), value, layer);
    }
    void state(MachineState state, std::uint32_t layer, std::uint32_t step = 0) {
        add(RecordKind::state_change, static_cast<std::uint16_t>(state), 0, layer, step);
    }

    const JobView& job_;
    bool spindle_ = false;
    bool is_far_ = false;
};

/// So many points from a layer's first on; one of them wrongly.
void carve_points(PerfectMachine& machine, const JobView& job, std::uint32_t layer, std::uint32_t points,
                  bool is_wrong = false) {
    machine.approach(layer);
    for (std::uint32_t done = 1; done < points; ++done) {
        const std::uint32_t in_layer = layer + done / kStartPoints;
        const std::uint32_t step = done % kStartPoints;
        if (is_wrong && done == 3) {
            machine.line({0, 0, 40, 0}).move(Axis::r1, -60).move(Axis::r1, 60);
        }
        if (step != 0) {
            machine.to_point(in_layer, step);
        } else if (!job.is_joint(in_layer, 0)) {
            machine.link_to(in_layer);
        }
    }
    machine.finish();
}

std::uint32_t points_of(const LastStart& start) {
    if (start.cut_behind != 0) return start.cut_behind;
    return (start.layers == 0 ? kStartLayers - start.layer : start.layers) * kStartPoints;
}

void go_by(PerfectMachine& machine, const JobView& job, const LastStart& start, Went pins) {
    const bool is_nothing = !start.is_told || start.is_dry;
    if (pins == Went::none || (pins == Went::right && is_nothing)) return;
    machine.move(Axis::r1, kOut_pulses).move(Axis::r2, kOut_pulses);
    const std::uint32_t points = points_of(start);
    if (pins == Went::only_in) return carve_points(machine, job, start.layer, 1);
    const bool is_early = pins == Went::early;
    carve_points(machine, job, start.layer, is_early ? std::min(points - 1, 9U) : points,
                 pins == Went::wrong);
}

VerifyReport judged_by(const SampleJob& job, const PerfectMachine& machine, const ToldStarts& recorder,
                       TraceHolds holds) {
    const auto asked = asked_carving(job.view(), recorder.records, recorder.points_done, holds);
    EXPECT_TRUE(asked);
    auto sut = Verifier::make_for(job.view(), job.profile, asked.value_or(AskedCarving{}));
    EXPECT_TRUE(sut);
    EXPECT_TRUE(sut->begin(machine.start));
    sut->feed(machine.events);
    return sut->finish();
}

constexpr LastStart kWholeJob{.name = "whole"};
constexpr LastStart kLastStarts[] = {
    kWholeJob,
    {.name = "called off", .is_told = false},
    {.name = "called off, from a layer", .layer = 2, .is_told = false},
    {.name = "cut", .cut_behind = 30},
    {.name = "cut, no status", .cut_behind = 12, .is_status_known = false},
    {.name = "from a layer", .layer = 2},
    {.name = "from a layer, cut", .layer = 2, .cut_behind = 12},
    {.name = "from a layer, cut, no status", .layer = 2, .cut_behind = 12, .is_status_known = false},
    {.name = "one layer", .layer = 2, .layers = 1},
    {.name = "the first layer", .layers = 1},
    {.name = "dry", .is_dry = true},
};

/// Whether such pins are what a start asked for.
bool is_right(const LastStart& start, Went pins) {
    if (pins == Went::right) return true;
    // The first carving is all that there was to be.
    if (pins == Went::none) return !start.is_told || start.is_dry;
    if (pins == Went::only_in) return !start.is_told;
    // How far it came is not known.
    return pins == Went::early && start.cut_behind != 0 && !start.is_status_known;
}

class LastStarts : public ::testing::TestWithParam<Joining> {
protected:
    const SampleJob job = wavy_job(GetParam());
    const JobView view = job.view();
};

TEST_P(LastStarts, AreJudgedByWhatTheyWereTold) {
    for (const LastStart& start : kLastStarts) {
        for (const Went pins : {Went::right, Went::only_in, Went::wrong, Went::early, Went::none}) {
            for (const TraceHolds holds : {TraceHolds::all_runs, TraceHolds::the_last_ones}) {
                // Right where the one before it alone may be in the trace.
                if (pins == Went::none && holds == TraceHolds::the_last_ones) continue;
                // One that was called off and carved from a later layer on did what was asked for before it.
                const bool is_untold = !start.is_told || start.is_dry;
                if (is_untold && pins == Went::early && start.layer != 0) continue;
                ToldStarts recorder(view);
                recorder.take(kWholeJob);
                recorder.take(start);
                PerfectMachine machine(job);
                machine.carve_job();
                go_by(machine, view, start, pins);
                const VerifyReport report = judged_by(job, machine, recorder, holds);
                EXPECT_EQ(report.ok, is_right(start, pins))
                    << start.name << ", pins " << static_cast<int>(pins) << ", holds "
                    << static_cast<int>(holds) << "\n"
                    << report_text(report);
            }
        }
    }
}

// One that was called off may have come to its first point, or not: for one before it that did not carve it
// is no excuse.
TEST_P(LastStarts, CalledOffBehindOneThatDidNotCarve) {
    for (const bool comes_in : {false, true}) {
        for (const Went pins : {Went::right, Went::only_in}) {
            ToldStarts recorder(view);
            recorder.take(kWholeJob);
            recorder.take(kWholeJob);
            recorder.take({.name = "called off", .is_told = false});
            PerfectMachine machine(job);
            machine.carve_job();
            go_by(machine, view, kWholeJob, pins);
            if (comes_in) go_by(machine, view, kWholeJob, Went::only_in);
            const VerifyReport report = judged_by(job, machine, recorder, TraceHolds::all_runs);
            EXPECT_EQ(report.ok, pins == Went::right) << report_text(report);
            if (!report.ok) {
                EXPECT_EQ(report.rules[0].offences, 1U) << report_text(report);
                EXPECT_EQ(first_of(report, 1).fault, "ends-early");
                EXPECT_EQ(report.points_visited, 1U);
                EXPECT_FALSE(report.is_cut);
            }
        }
    }
}

// The same where earlier runs may not be in the trace: the one that was called off was not near.
TEST_P(LastStarts, CalledOffOutsideItIsNotTheOneThatWentIn) {
    for (const bool is_far : {false, true}) {
        ToldStarts recorder(view);
        recorder.take(kWholeJob);
        recorder.take({.name = "called off", .is_told = false, .is_far = is_far});
        PerfectMachine machine(job);
        machine.carve_job();
        go_by(machine, view, kWholeJob, Went::only_in);
        EXPECT_EQ(judged_by(job, machine, recorder, TraceHolds::the_last_ones).ok, !is_far);
        EXPECT_TRUE(judged_by(job, machine, recorder, TraceHolds::all_runs).ok);
    }
}

// A run that was stopped carved less than the one before; the heads only went in.
TEST_P(LastStarts, WhatWasCarvedBeforeIsNotItsOwn) {
    for (const std::uint32_t before : {30U, 84U}) {
        ToldStarts recorder(view);
        recorder.take({.name = "before", .cut_behind = before});
        recorder.take({.name = "cut", .cut_behind = 12});
        for (const Went pins : {Went::right, Went::only_in, Went::early}) {
            PerfectMachine machine(job);
            carve_points(machine, view, 0, before);
            go_by(machine, view, {.name = "cut", .cut_behind = 12}, pins);
            for (const TraceHolds holds : {TraceHolds::all_runs, TraceHolds::the_last_ones}) {
                const VerifyReport report = judged_by(job, machine, recorder, holds);
                EXPECT_EQ(report.ok, pins == Went::right) << report_text(report);
                EXPECT_EQ(report.points_visited, pins == Went::right ? 12U : pins == Went::early ? 9U : 1U);
            }
        }
    }
}

// Stopped before psi turned, told to carve or not: nothing is missing.
TEST_P(LastStarts, CutAtItsFirstPointItIsAsIfCalledOff) {
    ToldStarts recorder(view);
    recorder.take(kWholeJob);
    recorder.take({.name = "cut", .cut_behind = 1});
    PerfectMachine machine(job);
    machine.carve_job();
    go_by(machine, view, kWholeJob, Went::only_in);
    EXPECT_TRUE(judged_by(job, machine, recorder, TraceHolds::all_runs).ok);
    EXPECT_TRUE(judged_by(job, machine, recorder, TraceHolds::the_last_ones).ok);
    // The status is then of a start behind it.
    recorder.take({.name = "called off", .layer = 3, .is_told = false});
    EXPECT_TRUE(judged_by(job, machine, recorder, TraceHolds::all_runs).ok);
}

// A trace of the last run alone.
TEST_P(LastStarts, TheLastRunAloneMayBeInTheTrace) {
    ToldStarts recorder(view);
    recorder.take(kWholeJob);
    recorder.take(kWholeJob);
    PerfectMachine machine(job);
    machine.carve_job();
    EXPECT_TRUE(judged_by(job, machine, recorder, TraceHolds::the_last_ones).ok);
    const VerifyReport report = judged_by(job, machine, recorder, TraceHolds::all_runs);
    EXPECT_EQ(first_of(report, 1).fault, "no-carving") << report_text(report);
}

INSTANTIATE_TEST_SUITE_P(Verify, LastStarts,
                         ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral),
                         [](const auto& named) { return "Case" + std::to_string(named.index); });

}  // namespace
}  // namespace psicarve::verify
