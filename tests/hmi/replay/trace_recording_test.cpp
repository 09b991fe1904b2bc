// SPDX-License-Identifier: GPL-3.0-or-later
// A real core's trace, shown at any time: what a plain count from the begin gives.
#include "hmi/replay/trace_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <vector>

#include "hmi/replay/carving_timeline.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

using test::PlainTrace;
using test::RecordedRun;
using testing::HasSubstr;
using two_process::text_of;

class TraceReplay : public RecordedRun {
protected:
    std::unique_ptr<Recording> open(const std::string& path, const std::string& job_path = {}) {
        auto opened = open_recording({path, job_path, Profile{}}, {});
        EXPECT_TRUE(opened) << opened.error().message;
        return opened ? std::move(*opened) : nullptr;
    }
    std::string problem_of(const std::string& bytes) {
        std::ofstream(file("bad.trace"), std::ios::binary) << bytes;
        const auto opened = open_recording({file("bad.trace"), {}, Profile{}}, {});
        return opened ? std::string{} : opened.error().message;
    }
    static std::int64_t ns_of(const session::LevelHistory::Look& look) {
        return std::chrono::nanoseconds{look.time.time_since_epoch()}.count();
    }
    static testing::AssertionResult agrees(const PinMoment& moment, const PlainTrace::At& plain) {
        if (moment.levels == plain.levels && moment.position_pulses == plain.position_pulses &&
            moment.pulses == plain.pulses)
            return testing::AssertionSuccess();
        return testing::AssertionFailure() << "at " << moment.time_ns << " ns";
    }
};

TEST_F(TraceReplay, ShowsAnyInstantAsACountFromTheBeginDoes) {
    record();
    const PlainTrace plain{trace()};
    ASSERT_GT(plain.states.size(), 50'000U);
    for (const std::size_t most_keyframes : {std::size_t{4}, TraceIndex::kMostKeyframes}) {
        const auto index = TraceIndex::build(trace(), Profile{}, {}, most_keyframes);
        ASSERT_TRUE(index);
        EXPECT_LE((*index)->keyframes().size(), most_keyframes);
        EXPECT_GT((*index)->keyframes().size(), 1U);
        EXPECT_EQ((*index)->end_ns(), plain.states.back().time_ns);
        TraceCursor sut{*index};
        std::mt19937_64 random{most_keyframes};
        std::uniform_int_distribution<std::int64_t> any_time{0, (*index)->end_ns()};
        for (int i = 0; i < 300; ++i) {
            // Half of them right at an event, or right before it.
            const auto& state = plain.states[random() % plain.states.size()];
            const std::int64_t time_ns = i % 2 == 0 ? any_time(random) : state.time_ns - i / 2 % 2;
            const auto moment = sut.at(std::max<std::int64_t>(time_ns, 0));
            ASSERT_TRUE(moment);
            ASSERT_TRUE(agrees(*moment, plain.at(std::max<std::int64_t>(time_ns, 0))));
        }
    }
}

TEST_F(TraceReplay, EndsWhereTheCoreSaidThatItWas) {
    record();
    const auto sut = open(trace(), snapshot());
    const auto shown = sut->at(sut->facts().end_ns, false);
    ASSERT_TRUE(shown);
    for (std::size_t k = 0; k < kAxisCount; ++k)
        EXPECT_EQ(shown->status.position_pulses[k], end_.position_pulses[k]);
    EXPECT_TRUE(sut->facts().knows_every_pulse);
    EXPECT_TRUE(sut->facts().warnings.empty());
}

TEST_F(TraceReplay, SaysWhatItsFlightRecorderHasAskedFor) {
    record();
    const auto whole = open(trace(), snapshot());
    ASSERT_TRUE(whole);
    ASSERT_TRUE(whole->facts().asked);
    EXPECT_EQ(whole->facts().asked->layers.first, 0U);
    EXPECT_FALSE(whole->facts().asked->may_end_early);
    auto later = load_snapshot(snapshot());
    ASSERT_TRUE(later);
    for (FlightRecord& entry : later->records) {
        if (entry.kind == RecordKind::command && entry.code == static_cast<std::uint16_t>(CommandKind::start))
            entry.value = 1;
    }
    ASSERT_TRUE(save_snapshot(*later, file("later.snap")));
    const auto part = open(trace(), file("later.snap"));
    ASSERT_TRUE(part);
    ASSERT_TRUE(part->facts().asked);
    EXPECT_EQ(part->facts().asked->layers.first, 1U);
}

TEST_F(TraceReplay, TellsTheLayerOfThePinsAndTheStatesOfTheFlightRecorder) {
    record();
    const auto sut = open(trace(), snapshot());
    ASSERT_TRUE(sut->facts().knows_states);
    const auto period_ns = static_cast<std::int64_t>(end_.period_ns);
    const auto at_tick = [&](std::uint64_t tick) {
        auto shown = sut->at(static_cast<std::int64_t>(tick) * period_ns, false);
        EXPECT_TRUE(shown);
        return *shown;
    };
    const Shown first = at_tick(end_.carve_first_tick + 1);
    EXPECT_EQ(first.status.state, MachineState::carving);
    ASSERT_TRUE(first.place);
    EXPECT_EQ(first.place->layer, 0U);
    const Shown last = at_tick(end_.carve_last_tick - 1);
    ASSERT_TRUE(last.place);
    EXPECT_EQ(last.place->layer, kLayers - 1);
    EXPECT_EQ(last.status.override_percent, 80U);
    EXPECT_EQ(at_tick(0).status.state, MachineState::off);
    EXPECT_EQ(at_tick(0).status.homed_mask, 0);
    EXPECT_EQ(sut->at(sut->facts().end_ns, false)->status.state, MachineState::ready);
}

TEST_F(TraceReplay, KnowsWithoutASnapshotWhatThePinsSay) {
    record();
    const auto sut = open(trace());
    EXPECT_FALSE(sut->facts().job);
    EXPECT_FALSE(sut->facts().knows_states);
    std::string texts;
    for (const Entry& entry : sut->facts().entries) texts += in_english(entry.what) + "\n";
    for (const char* text : {"Drives switched on", "Limit switch R1 closed", "Homing: positions defined",
                             "Spindle on", "Spindle off"})
        EXPECT_THAT(texts, HasSubstr(text));
    EXPECT_EQ(sut->at(0, false)->status.state, MachineState::off);
    EXPECT_LT(sut->at(0, false)->status.seconds_left, 0.0) << "not known";
    EXPECT_LT(sut->at(0, false)->status.reference_seconds, 0.0) << "not known";
}

TEST_F(TraceReplay, TakesTheJobThatLiesBesideIt) {
    record();
    std::filesystem::copy_file(job(), file("run.job"));
    EXPECT_EQ(open(trace())->facts().job->view.layer_count(), kLayers);
    std::filesystem::copy_file(snapshot(), file("run.snap"));
    EXPECT_TRUE(open(trace())->facts().knows_states);
}

TEST_F(TraceReplay, NeedsNoFileBesideATraceThatCarriesItsJob) {
    record();
    const auto sut = open(whole_trace());
    ASSERT_TRUE(sut->facts().job);
    EXPECT_EQ(sut->facts().job->view.layer_count(), kLayers);
    EXPECT_TRUE(sut->facts().warnings.empty());
    EXPECT_FALSE(sut->facts().knows_states);
    const auto shown = sut->at(
        static_cast<std::int64_t>(end_.carve_last_tick - 1) * static_cast<std::int64_t>(end_.period_ns),
        false);
    ASSERT_TRUE(shown && shown->place);
    EXPECT_EQ(shown->place->layer, kLayers - 1);
    // The same pins as without it.
    const auto older = open(trace());
    EXPECT_EQ(sut->facts().end_ns, older->facts().end_ns);
    EXPECT_EQ(sut->index()->events(), older->index()->events());
}

TEST_F(TraceReplay, TakesTheEntriesOfASnapshotBesideATraceThatCarriesItsJob) {
    record();
    std::filesystem::copy_file(snapshot(), file("whole.snap"));
    const auto sut = open(whole_trace());
    EXPECT_TRUE(sut->facts().knows_states);
    EXPECT_TRUE(sut->facts().warnings.empty());
}

TEST_F(TraceReplay, RefusesAnotherJobThanTheOneItCarries) {
    record();
    EXPECT_TRUE(open(whole_trace(), job())->facts().job) << "the same";
    JobTable other = two_process::lobed_job(kLayers, kPoints);
    ++other.r_left_pulses[3];
    Snapshot other_job;
    other_job.job_blob = job_blob_from_table(other);
    ASSERT_TRUE(save_snapshot(other_job, file("third.job")));
    const auto opened = open_recording({whole_trace(), file("third.job"), Profile{}}, {});
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message, HasSubstr("third.job"));
    EXPECT_THAT(opened.error().message, HasSubstr("is not the job that"));
    // One that happens to lie beside it is not asked for.
    std::filesystem::copy_file(file("third.job"), file("whole.job"));
    EXPECT_EQ(open(whole_trace())->facts().job->view.r_left_pulses(0)[3], other.r_left_pulses[3] - 1);
}

TEST_F(TraceReplay, ShowsThePinsOfATraceWhoseJobIsDamaged) {
    record();
    std::string bytes = text_of(whole_trace());
    const std::size_t at = bytes.find("PSCAJOB1");
    ASSERT_NE(at, std::string::npos);
    bytes[at + 400] ^= 1;
    std::ofstream(file("damaged.trace"), std::ios::binary) << bytes;
    const auto sut = open(file("damaged.trace"));
    EXPECT_FALSE(sut->facts().job);
    ASSERT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_THAT(in_english(sut->facts().warnings[0]),
                HasSubstr("damaged.trace: the job that it carries is damaged"));
    EXPECT_EQ(sut->facts().end_ns, open(trace())->facts().end_ns);
}

TEST_F(TraceReplay, DoesNotTakeAnotherRunsEntriesForItsOwn) {
    record();
    auto other = load_snapshot(snapshot());
    ASSERT_TRUE(other);
    other->records[other->records.size() / 2].position_pulses[0] += 5;
    for (FlightRecord& entry : other->records) entry.position_pulses[1] += 5;
    ASSERT_TRUE(save_snapshot(*other, file("wrong.snap")));
    const auto sut = open(trace(), file("wrong.snap"));
    ASSERT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_THAT(in_english(sut->facts().warnings[0]), HasSubstr("another run"));
    EXPECT_FALSE(sut->facts().knows_states);
    EXPECT_TRUE(sut->facts().job);
}

/// Of the last entry of that kind, nothing: there is none.
std::optional<std::size_t> last_of(const std::vector<FlightRecord>& entries, RecordKind kind) {
    for (std::size_t i = entries.size(); i-- > 0;) {
        if (entries[i].kind == kind) return i;
    }
    return std::nullopt;
}

// A core of its own, which counts ticks anew and begins at the rest behind homing.
TEST_F(TraceReplay, TakesTheEntriesOfTheSnapshotThatReplayRanAgain) {
    record();
    const auto recorded = load_snapshot(snapshot());
    ASSERT_TRUE(recorded);
    start_core({"--replay", snapshot(), "--trace", file("again.trace")});
    ASSERT_EQ(core_->wait_for_exit(), 0);
    ASSERT_TRUE(save_snapshot(*recorded, file("again.snap")));
    const auto sut = open(file("again.trace"));
    EXPECT_TRUE(sut->facts().warnings.empty()) << in_english(sut->facts().warnings.front());
    ASSERT_TRUE(sut->facts().knows_states);
    ASSERT_TRUE(sut->facts().asked);
    EXPECT_LT(sut->facts().entries.size(), recorded->records.size()) << "homing was not run again";
    const auto period_ns = static_cast<std::int64_t>(end_.period_ns);
    std::int64_t from_ns = -1;
    for (const Entry& entry : sut->facts().entries) {
        const auto at = sut->at(entry.time_ns + period_ns - 1, false);
        ASSERT_TRUE(at);
        EXPECT_GE(entry.time_ns, from_ns);
        from_ns = entry.time_ns;
        if (at->status.state == MachineState::carving) {
            EXPECT_EQ(at->status.override_percent, 80U);
            EXPECT_TRUE(at->place);
        }
    }
    EXPECT_EQ(sut->at(0, false)->status.state, MachineState::ready);
    const auto end = sut->at(sut->facts().end_ns, false);
    for (std::size_t k = 0; k < kAxisCount; ++k)
        EXPECT_EQ(end->status.position_pulses[k], end_.position_pulses[k]);

    // Entries of other runs fit nowhere: elsewhere by some pulses, later by some ticks, or of a run that
    // ended while this one went on.
    const auto is_taken = [&](const std::vector<FlightRecord>& records) {
        Snapshot other = *recorded;
        other.records = records;
        EXPECT_TRUE(save_snapshot(other, file("again.snap")));
        return open(file("again.trace"))->facts().knows_states;
    };
    EXPECT_TRUE(is_taken(recorded->records));
    std::vector<FlightRecord> other = recorded->records;
    other[other.size() - 2].position_pulses[1] += 5;
    EXPECT_FALSE(is_taken(other));
    other = recorded->records;
    const auto edge = last_of(other, RecordKind::input_edge);
    ASSERT_TRUE(edge);
    for (std::size_t i = *edge; i < other.size(); ++i) other[i].tick += 400;
    EXPECT_FALSE(is_taken(other));
    other = recorded->records;
    other.resize(*edge - 2);
    EXPECT_FALSE(is_taken(other));
}

TEST_F(TraceReplay, ShowsATraceThatWasCutOffUpToThereAndSaysSo) {
    record();
    const std::string whole = text_of(trace());
    std::ofstream(file("cut.trace"), std::ios::binary) << whole.substr(0, whole.size() / 2);
    const auto sut = open(file("cut.trace"));
    ASSERT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_THAT(in_english(sut->facts().warnings[0]), HasSubstr("cut.trace: byte"));
    const PlainTrace plain{trace()};
    EXPECT_LT(sut->facts().end_ns, plain.states.back().time_ns);
    const auto shown = sut->at(sut->facts().end_ns, true);
    ASSERT_TRUE(shown);
    const auto& expected = plain.at(sut->facts().end_ns);
    for (std::size_t k = 0; k < kAxisCount; ++k)
        EXPECT_EQ(shown->status.position_pulses[k], expected.position_pulses[k]);
}

TEST_F(TraceReplay, RefusesWhatIsNoneInOneLine) {
    record();
    EXPECT_THAT(problem_of(""), HasSubstr("bad.trace"));
    EXPECT_THAT(problem_of("$date today $end"), HasSubstr("bad.trace"));
    EXPECT_THAT(problem_of(text_of(trace()).substr(0, 40)), HasSubstr("cut off inside its header"));
    EXPECT_THAT(problem_of(text_of(trace()).substr(0, 64)), HasSubstr("cut off"));
    const auto missing = open_recording({file("none.trace"), {}, Profile{}}, {});
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message, HasSubstr("none.trace"));
    EXPECT_FALSE(is_recording(job()));
    EXPECT_TRUE(is_recording(trace()));
    EXPECT_TRUE(is_recording(snapshot()));
}

TEST_F(TraceReplay, CanBeCancelled) {
    record();
    const auto opened = open_recording({trace(), {}, Profile{}}, [](double) { return false; });
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::cancelled);
}

TEST_F(TraceReplay, DrawsTheLastSecondsTheSameWhicheverWayOneCameThere) {
    record();
    const auto played = open(trace());
    const auto jumped = open(trace());
    const std::int64_t end_ns = played->facts().end_ns;
    const PlainTrace plain{trace()};
    for (int step = 1; step <= 40; ++step) {
        const std::int64_t time_ns = end_ns / 40 * step;
        const auto shown = played->at(time_ns, true);
        ASSERT_TRUE(shown);
        const std::int64_t from_ns = ns_of(shown->looks.front());
        EXPECT_LE(time_ns - from_ns, 21'000'000'000);
        std::array<std::uint64_t, kAxisCount> pulses = plain.at(from_ns).pulses;
        for (std::size_t i = 1; i < shown->looks.size(); ++i) {
            for (std::size_t k = 0; k < kAxisCount; ++k) pulses[k] += shown->looks[i].pulses[k];
            ASSERT_GT(ns_of(shown->looks[i]), ns_of(shown->looks[i - 1]));
            ASSERT_EQ(pulses, plain.at(ns_of(shown->looks[i])).pulses) << i;
        }
        EXPECT_EQ(shown->looks.back().levels, plain.at(time_ns).levels);
    }
    const auto there = jumped->at(end_ns, true);
    EXPECT_EQ(there->looks.back().levels, plain.states.back().levels);
}

/// Every cell of the piece.
std::vector<float> cells_of(const session::CarvingRecord& record) {
    std::vector<float> cells;
    for (std::uint32_t layer = 0; layer < record.surface().layer_count(); ++layer) {
        const auto radii = record.surface().radii_mm(layer);
        cells.insert(cells.end(), radii.begin(), radii.end());
    }
    return cells;
}

TEST_F(TraceReplay, ThePieceIsTheSameForwardsAndBackwards) {
    record();
    const auto recording = open(trace(), job());
    const auto timeline = CarvingTimeline::of_trace(recording->facts().job, recording->index(), {});
    ASSERT_TRUE(timeline);
    const CarvingTimeline& sut = **timeline;
    EXPECT_TRUE(sut.is_whole());
    const auto fresh = [&] {
        auto made = session::CarvingRecord::make(recording->facts().job);
        EXPECT_TRUE(made);
        return std::move(made).value();
    };
    const auto scrubbed = fresh();
    const std::vector<float> blank = cells_of(*scrubbed);
    std::size_t cuts = 0;
    std::mt19937_64 random{11};
    std::uniform_int_distribution<std::int64_t> any_time{0, recording->facts().end_ns};
    for (int i = 0; i < 60; ++i) {
        const std::int64_t time_ns = any_time(random);
        while (!sut.is_applied(cuts, time_ns)) cuts = sut.apply(*scrubbed, cuts, time_ns, 777);
        const auto straight = fresh();
        sut.apply(*straight, 0, time_ns, sut.cuts());
        ASSERT_EQ(cells_of(*scrubbed), cells_of(*straight));
    }
    while (!sut.is_applied(cuts, -1)) cuts = sut.apply(*scrubbed, cuts, -1, 777);
    EXPECT_EQ(cells_of(*scrubbed), blank);
    sut.apply(*scrubbed, 0, recording->facts().end_ns, sut.cuts());
    // Every cell was carved, and none deeper than the job wants by more than a pulse or two.
    const verify::JobGeometry& geometry = scrubbed->geometry();
    for (std::uint32_t layer = 0; layer < kLayers; ++layer) {
        for (std::uint32_t cell = 0; cell < geometry.direction_count(); ++cell) {
            const auto wanted_mm = geometry.wanted_mm(layer, geometry.direction_of(cell));
            ASSERT_TRUE(wanted_mm);
            EXPECT_NEAR(scrubbed->surface().radii_mm(layer)[cell], *wanted_mm, 0.25) << layer << " " << cell;
        }
    }
    ASSERT_TRUE(sut.begin_of_layer(3));
    EXPECT_GT(*sut.begin_of_layer(3), *sut.begin_of_layer(2));
    EXPECT_FALSE(sut.begin_of_layer(kLayers));
}

}  // namespace
}  // namespace psicarve::replay
