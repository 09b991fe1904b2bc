// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/snapshot_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "hmi/replay/carving_timeline.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/machine/recorded_start.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

using test::RecordedRun;
using testing::HasSubstr;

class SnapshotReplay : public RecordedRun {};

TEST_F(SnapshotReplay, ShowsTheMachineAtEachEntryAndWholeAtTheEnd) {
    record();
    const auto opened = open_recording({snapshot(), {}, Profile{}}, {});
    ASSERT_TRUE(opened) << opened.error().message;
    Recording& sut = **opened;
    const auto saved = load_snapshot(snapshot());
    ASSERT_EQ(sut.facts().entries.size(), saved->records.size());
    ASSERT_GT(saved->records.size(), 10U);
    EXPECT_EQ(sut.facts().entries.front().time_ns, 0);
    EXPECT_FALSE(sut.facts().knows_every_pulse);
    EXPECT_EQ(sut.facts().job->view.layer_count(), kLayers);
    const std::uint64_t first_tick = saved->records.front().tick;
    for (std::size_t i = 0; i < saved->records.size(); ++i) {
        const bool is_last_of_its_tick =
            i + 1 == saved->records.size() || saved->records[i + 1].tick != saved->records[i].tick;
        const std::int64_t time_ns = sut.facts().entries[i].time_ns;
        EXPECT_EQ(time_ns,
                  static_cast<std::int64_t>(saved->records[i].tick - first_tick) * saved->status->period_ns);
        if (!is_last_of_its_tick || time_ns == sut.facts().end_ns) continue;
        const auto shown = sut.at(time_ns, true);
        ASSERT_TRUE(shown);
        EXPECT_EQ(shown->status.tick, saved->records[i].tick);
        EXPECT_EQ(shown->status.signals, saved->records[i].signals);
        for (std::size_t k = 0; k < kAxisCount; ++k)
            EXPECT_EQ(shown->status.position_pulses[k], saved->records[i].position_pulses[k]);
    }
    const auto end = sut.at(sut.facts().end_ns, false);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->status.points_done, saved->status->points_done);
    EXPECT_EQ(end->status.tick, saved->status->tick);
    EXPECT_EQ(end->carving_time, kLayers);
}

TEST_F(SnapshotReplay, SaysOfWhichProgramItIsAndHowThatIsRunAgain) {
    record();
    const auto listed = [&](const Snapshot& saved) {
        EXPECT_TRUE(save_snapshot(saved, file("program.snap")));
        const auto sut = open_recording({file("program.snap"), {}, Profile{}}, {});
        EXPECT_TRUE(sut);
        std::string text;
        for (const session::Check& row : (*sut)->facts().contents)
            text += in_english(row.name) + ": " + in_english(row.detail) + "\n";
        return text;
    };
    auto saved = load_snapshot(snapshot());
    ASSERT_TRUE(saved);
    EXPECT_THAT(listed(*saved), testing::Not(HasSubstr("Program")));
    FlightRecord line{};
    line.tick = saved->records.back().tick;
    line.kind = RecordKind::program;
    line.code = recorded_code(ProgramEvent::line);
    line.axis = kNoAxis;
    line.value = 12;
    saved->records.push_back(line);
    EXPECT_THAT(listed(*saved), HasSubstr("Program: of an unknown text\nIts line at the end: 12\n"
                                          "To run it again: replay --program FILE\n"));
    auto source = std::make_shared<RecordedSource>();
    source->source.program = 7;
    source->source.text_bytes = 345;
    std::copy_n("pocket.ngc", sizeof "pocket.ngc", source->source.name);
    saved->source = source;
    EXPECT_THAT(listed(*saved), HasSubstr("Program: pocket.ngc, 345 bytes\n"));
    source->source.flags = kSourceIsStream;
    EXPECT_THAT(listed(*saved), HasSubstr("Program: from standard input\n"));
}

TEST_F(SnapshotReplay, ShowsNothingCarvedOfADryRun) {
    record();
    auto saved = load_snapshot(snapshot());
    ASSERT_TRUE(saved);
    saved->status->is_dry = 1;
    for (FlightRecord& record : saved->records) {
        const bool is_start = record.kind == RecordKind::command &&
                              record.code == static_cast<std::uint16_t>(CommandKind::start);
        if (is_start)
            record.value =
                static_cast<std::int64_t>(static_cast<std::uint64_t>(record.value) | kRecordedDryRun);
    }
    const std::string dry = snapshot() + ".dry.snap";
    ASSERT_TRUE(save_snapshot(*saved, dry));
    const auto opened = open_recording({dry, {}, Profile{}}, {});
    ASSERT_TRUE(opened);
    bool was_at_job = false;
    for (const Entry& entry : (*opened)->facts().entries) {
        const auto shown = (*opened)->at(entry.time_ns, false);
        if (shown->status.state == MachineState::carving) {
            was_at_job = true;
            EXPECT_EQ(shown->status.is_dry, 1U);
        }
        EXPECT_EQ(shown->carving_time, 0);
    }
    EXPECT_TRUE(was_at_job);
    EXPECT_EQ((*opened)->at((*opened)->facts().end_ns, false)->carving_time, 0);
}

TEST_F(SnapshotReplay, HasTheStatesOfItsEntries) {
    record();
    const auto opened = open_recording({snapshot(), {}, Profile{}}, {});
    ASSERT_TRUE(opened);
    std::string states;
    for (const Entry& entry : (*opened)->facts().entries) {
        const auto shown = (*opened)->at(entry.time_ns, false);
        const std::string name{name_of(shown->status.state)};
        if (!states.ends_with(name + " ")) states += name + " ";
    }
    EXPECT_THAT(states, HasSubstr("homing ready positioning waiting carving finishing ready"));
}

TEST_F(SnapshotReplay, ItsPieceIsTheJobLayerByLayer) {
    record();
    const auto opened = open_recording({snapshot(), {}, Profile{}}, {});
    ASSERT_TRUE(opened);
    const auto timeline = CarvingTimeline::of_job((*opened)->facts().job, {});
    ASSERT_TRUE(timeline);
    auto made = session::CarvingRecord::make((*opened)->facts().job);
    ASSERT_TRUE(made);
    const auto record = std::move(made).value();
    std::size_t cuts = (*timeline)->apply(*record, 0, 2, 1'000'000);
    const auto blank = static_cast<float>(record->geometry().blank_radius_mm());
    EXPECT_LT(record->surface().radii_mm(1)[5], blank);
    EXPECT_EQ(record->surface().radii_mm(2)[5], blank);
    cuts = (*timeline)->apply(*record, cuts, 0, 1'000'000);
    EXPECT_EQ(cuts, 0U);
    EXPECT_EQ(record->surface().radii_mm(0)[5], blank);
}

}  // namespace
}  // namespace psicarve::replay
