// SPDX-License-Identifier: GPL-3.0-or-later
// What the tick tells of itself: samples, edges of its inputs, the times of its writes and of its trace.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "rtcore/trace/trace_entry.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

struct Edge {
    Signal input;
    std::uint8_t axis;
};
constexpr Edge kEdges[] = {{Signal::r1_limit, 0},
                           {Signal::r2_limit, 1},
                           {Signal::psi_index, 2},
                           {Signal::y_limit, 3},
                           {Signal::estop, kNoAxis}};

std::uint64_t told_tick(const MachineRig& rig) {
    return rig.io->sample.read().tick;
}

TEST(Telling, ASampleIsThereBeforeTheFirstTick) {
    const MachineRig sut(quick_profile());
    const Sample told = sut.io->sample.read();
    EXPECT_EQ(told.state, MachineState::off);
    EXPECT_EQ(told.override_percent, 100U);
    EXPECT_EQ(told.position_pulses, sut.positions());
}

TEST(Telling, ThePortIsAtRestBeforeTheFirstTick) {
    const MachineRig sut(quick_profile());
    ASSERT_EQ(sut.port->writes.size(), 1U);
    EXPECT_EQ(sut.port->writes[0].levels, 0U);
    EXPECT_EQ(sut.port->writes[0].time_ns, 0);
}

TEST(Telling, ASampleComesEveryTwentiethTickAtMost) {
    const auto sample_ticks = plan::cycle_config_from_profile(quick_profile()).sample_ticks;
    MachineRig sut(quick_profile());
    std::vector<std::uint64_t> told;
    for (std::uint64_t n = 0; n < 10 * sample_ticks; ++n) {
        sut.tick();
        if (told.empty() || told_tick(sut) != told.back()) told.push_back(told_tick(sut));
    }
    ASSERT_EQ(told.size(), 10U);
    for (std::size_t k = 0; k < told.size(); ++k) EXPECT_EQ(told[k], k * sample_ticks);
}

TEST(Telling, APortThatFallsSilentOrAnswersAgainIsToldAtOnce) {
    MachineRig sut(quick_profile());
    sut.run(25);
    sut.port->healthy = false;
    sut.run(23);
    ASSERT_EQ(sut.cycle->state(), MachineState::alarm);
    for (const bool silent : {true, false, true}) {
        sut.port->silent = silent;
        sut.run(2);
        EXPECT_EQ(sut.io->sample.read().is_port_silent, silent ? 1 : 0);
        const std::uint64_t told = told_tick(sut);
        EXPECT_GE(told + 2, sut.cycle->next_tick());
        sut.run(3);
        EXPECT_EQ(told_tick(sut), told) << "once";
    }
}

TEST(Telling, EveryEdgeOfEveryInputIsRecordedOnceWithItsAxisAndWay) {
    for (const auto& [input, axis] : kEdges) {
        MachineRig sut(quick_profile());
        sut.run(5);
        const bool begin = (sut.cycle->sample().signals & bit_of(input)) != 0;
        std::vector<FlightRecord> edges = sut.records_of(RecordKind::input_edge);
        const std::size_t before = edges.size();
        for (const bool level : {!begin, begin}) {
            sut.machine->hold_input(input, level);
            sut.run(12);
        }
        edges = sut.records_of(RecordKind::input_edge);
        ASSERT_EQ(edges.size(), before + 2) << static_cast<int>(axis);
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(edges[before + k].axis, axis);
            EXPECT_EQ(edges[before + k].code, (k == 0) != begin ? 1 : 0) << static_cast<int>(axis);
        }
    }
}

TEST(Telling, EdgesOfOneTickAreRecordedEach) {
    MachineRig sut(quick_profile());
    sut.run(5);
    const std::size_t before = sut.records_of(RecordKind::input_edge).size();
    for (const auto& [input, axis] : kEdges) {
        sut.machine->hold_input(input, (sut.cycle->sample().signals & bit_of(input)) == 0);
    }
    sut.tick();
    const auto edges = sut.records_of(RecordKind::input_edge);
    ASSERT_EQ(edges.size(), before + 5);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(edges[before + k].axis, kEdges[k].axis);
}

TEST(Telling, AStopAndAnEmergencyStopAreRecordedWithoutAnythingElse) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(2, 30, 3)));
    sut.stop();
    sut.tick();
    sut.emergency_stop();
    sut.tick();
    for (const RecordKind kind : {RecordKind::stop, RecordKind::emergency_stop}) {
        const auto records = sut.records_of(kind);
        ASSERT_EQ(records.size(), 1U);
        EXPECT_EQ(records[0].code, 0);
        EXPECT_EQ(records[0].axis, kNoAxis);
        EXPECT_EQ(records[0].value, 0);
    }
}

TEST(Telling, TimeGoesOnWithMissedTicks) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.home());
    sut.port->writes.clear();
    ASSERT_EQ(sut.ask(RequestKind::spindle, 0, 1), Refusal::none);
    sut.run(10);
    const std::uint64_t before = sut.cycle->next_tick();
    sut.cycle->advance_missed(3);
    EXPECT_EQ(sut.cycle->next_tick(), before + 3);
    ASSERT_EQ(sut.ask(RequestKind::spindle, 0, 0), Refusal::none);
    sut.run(10);
    ASSERT_FALSE(sut.port->writes.empty());
    const auto period_ns = tick_period_ns(sut.profile);
    EXPECT_EQ(sut.port->writes.back().tick, before + 3);
    EXPECT_EQ(sut.port->writes.back().time_ns, static_cast<std::int64_t>(before + 3) * period_ns);
}

TEST(Telling, ARefusalNamesItsOwnAxisAndNotThatOfTheOneBefore) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.home());
    Request too_far{};
    too_far.kind = RequestKind::move;
    too_far.order.axes = 1U << index_of(Axis::y);
    too_far.order.target_pulses[index_of(Axis::y)] = 1'000'000;
    ASSERT_EQ(sut.ask(too_far), Refusal::outside_travel);
    ASSERT_EQ(sut.ask(RequestKind::start), Refusal::no_job);
    const auto commands = sut.records_of(RecordKind::command);
    ASSERT_GE(commands.size(), 2U);
    EXPECT_EQ((commands.end() - 2)->axis, index_of(Axis::y));
    EXPECT_EQ(commands.back().axis, kNoAxis);
}

/// How many pin entries each offset within the tick has, of homing and an emergency stop.
std::map<std::uint32_t, std::size_t> traced_offsets(PulseForm form) {
    Profile profile = quick_profile();
    profile.port.pulses = form;
    MachineRig rig(profile);
    const auto ring = std::make_unique<trace::TraceRing>();
    rig.io->trace = ring.get();
    std::map<std::uint32_t, std::size_t> found;
    const auto take = [&] {
        trace::TraceEntry entry;
        while (ring->pop_into(entry)) {
            if (entry.kind == trace::TraceEntry::Kind::pins) ++found[entry.offset_ns];
        }
    };
    EXPECT_EQ(rig.ask(RequestKind::home), Refusal::none);
    for (int i = 0; i < 5000; ++i) {
        rig.tick();
        take();
    }
    rig.machine->hold_input(Signal::estop, true);
    rig.run(2);
    take();
    return found;
}

TEST(Telling, ATracesEntriesStandWhereTheTickOrAPulseBeginsAndWhereAPulseWithinItEnds) {
    const auto over = traced_offsets(PulseForm::over_ticks);
    ASSERT_EQ(over.size(), 1U);
    EXPECT_GT(over.at(0), 500U);
    const auto within = traced_offsets(PulseForm::within_tick);
    ASSERT_EQ(within.size(), 2U);
    ASSERT_TRUE(within.contains(0));
    EXPECT_EQ(within.rbegin()->first, static_cast<std::uint32_t>(quick_profile().port.step_high_ns));
    EXPECT_GT(within.rbegin()->second, 250U);
}

}  // namespace
}  // namespace psicarve::cycle
