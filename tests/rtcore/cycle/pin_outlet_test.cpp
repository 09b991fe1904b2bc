// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pin_outlet.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kOutletTick_ns = 50'000;

/// What the port was told, in order; a wait has no levels.
struct OutletWrite {
    SignalWord levels;
    std::int64_t time_ns;
    friend bool operator==(const OutletWrite&, const OutletWrite&) = default;
};

class OutletPort final : public port::Port {
public:
    SignalWord read_inputs(std::int64_t /*time_ns*/) noexcept override { return 0; }
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override {
        writes.push_back({levels, time_ns});
    }
    void wait(std::int64_t width_ns) noexcept override { waits_ns.push_back(width_ns); }
    bool is_healthy() const noexcept override { return true; }

    std::vector<OutletWrite> writes;
    std::vector<std::int64_t> waits_ns;
};

CycleConfig outlet_config(std::int64_t pulse_ns) {
    CycleConfig config;
    config.period_ns = kOutletTick_ns;
    config.pulse_ns = pulse_ns;
    config.step_high_ticks = pulse_ns > 0 ? 0 : 1;
    config.input_mask = kLimitMask | kIndexBit;
    return config;
}

struct OutletRig {
    explicit OutletRig(std::int64_t pulse_ns = 0) : config(outlet_config(pulse_ns)) {
        io->trace = ring.get();
        port.writes.clear();
    }
    std::vector<trace::TraceEntry> traced() {
        std::vector<trace::TraceEntry> entries;
        trace::TraceEntry entry;
        while (ring->pop_into(entry)) entries.push_back(entry);
        return entries;
    }

    CycleConfig config;
    OutletPort port;
    std::unique_ptr<trace::TraceRing> ring = std::make_unique<trace::TraceRing>();
    std::unique_ptr<CycleIo> io = std::make_unique<CycleIo>();
    TickClock clock{kOutletTick_ns};
    PulseStage pulses{config};
    Inputs inputs{config};
    PinOutlet sut{config, port, *io, pulses, inputs, clock};
};

TEST(PinOutlet, WritesWhatThePulseStageWantsAtTheTimeOfTheTick) {
    OutletRig rig;
    EXPECT_FALSE(rig.sut.has_change());
    rig.clock.advance(4);
    rig.pulses.step(0b0101, 4);
    EXPECT_TRUE(rig.sut.has_change());
    rig.sut.write();
    EXPECT_FALSE(rig.sut.has_change());
    EXPECT_EQ(rig.port.writes, (std::vector<OutletWrite>{{0b0101, 4 * kOutletTick_ns}}));
    EXPECT_TRUE(rig.port.waits_ns.empty());
}

TEST(PinOutlet, EndsPulsesWithinTheTickAndTracesBothEdges) {
    OutletRig rig(5'000);
    rig.clock.advance(2);
    rig.pulses.step(0b0001, 2);
    rig.sut.write();
    EXPECT_EQ(rig.port.writes,
              (std::vector<OutletWrite>{{0b0001, 2 * kOutletTick_ns}, {0, 2 * kOutletTick_ns + 5'000}}));
    EXPECT_EQ(rig.port.waits_ns, (std::vector<std::int64_t>{5'000}));
    const std::vector<trace::TraceEntry> entries = rig.traced();
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].levels, 0b0001U);
    EXPECT_EQ(entries[0].offset_ns, 0U);
    EXPECT_EQ(entries[1].levels, 0U);
    EXPECT_EQ(entries[1].offset_ns, 5'000U);
    EXPECT_EQ(entries[1].tick, 2U);
}

TEST(PinOutlet, EndsPulsesBetweenTwoTicksAndLeavesOtherLevelsForTheNext) {
    OutletRig rig;
    rig.clock.advance(10);
    rig.pulses.step(0b0010, 10);
    rig.sut.write();
    rig.traced();
    rig.clock.advance(5);
    rig.pulses.set_spindle(true);
    rig.sut.end_pulses(rig.clock.before(4));
    EXPECT_EQ(rig.port.writes.back(), (OutletWrite{0, 11 * kOutletTick_ns}));
    EXPECT_TRUE(rig.sut.has_change()) << "the spindle waits";
    const std::vector<trace::TraceEntry> entries = rig.traced();
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].tick, 11U);
    EXPECT_EQ(entries[0].levels, 0U);
    EXPECT_EQ(rig.clock.tick(), 15U);
}

TEST(PinOutlet, TracesOutputsAsWrittenWithInputsAsReadAndNoChargePump) {
    OutletRig rig;
    rig.inputs.take(kIndexBit, 0, {});
    rig.pulses.set_spindle(true);
    rig.sut.trace();
    rig.sut.toggle_charge_pump();
    EXPECT_TRUE(rig.sut.has_change());
    rig.sut.write();
    rig.sut.trace();
    const std::vector<trace::TraceEntry> entries = rig.traced();
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].levels, kIndexBit) << "the spindle is not written yet";
    EXPECT_EQ(entries[1].levels, kIndexBit | bit_of(Signal::spindle));
    EXPECT_EQ(rig.port.writes.back().levels, bit_of(Signal::spindle) | kChargePumpBit);
    rig.sut.rest_charge_pump();
    rig.sut.write();
    EXPECT_EQ(rig.port.writes.back().levels, bit_of(Signal::spindle));
}

TEST(PinOutlet, TracesANewPositionOnceAndBehindTheTicksPins) {
    OutletRig rig;
    rig.clock.advance(3);
    rig.pulses.set_position(1, -77);
    rig.pulses.step(0b0001, 3);
    rig.sut.note_new_position();
    rig.sut.write();
    rig.sut.trace();
    rig.sut.trace();
    const std::vector<trace::TraceEntry> entries = rig.traced();
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].kind, trace::TraceEntry::Kind::pins);
    EXPECT_EQ(entries[1].kind, trace::TraceEntry::Kind::position);
    EXPECT_EQ(entries[1].position_pulses[1], -77);
    EXPECT_EQ(entries[1].tick, 3U);
}

TEST(PinOutlet, TellsARecordingAndAJobWhereTheyBegin) {
    OutletRig rig;
    rig.clock.advance(6);
    rig.pulses.set_position(0, 12);
    EXPECT_TRUE(rig.sut.can_record());
    rig.sut.trace_job(9);
    rig.sut.begin_recording(RecordingForm::vcd, 5);
    EXPECT_FALSE(rig.sut.can_record());
    EXPECT_FALSE(rig.sut.end_recording(6)) << "another's";
    EXPECT_TRUE(rig.sut.end_recording(5));
    const std::vector<trace::TraceEntry> entries = rig.traced();
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_EQ(entries[0].kind, trace::TraceEntry::Kind::job);
    EXPECT_EQ(entries[0].token, 9U);
    EXPECT_EQ(entries[1].kind, trace::TraceEntry::Kind::begin_vcd);
    EXPECT_EQ(entries[2].kind, trace::TraceEntry::Kind::end);
    for (const trace::TraceEntry& entry : entries) {
        EXPECT_EQ(entry.tick, 6U);
        EXPECT_EQ(entry.position_pulses[0], 12);
    }
}

}  // namespace
}  // namespace psicarve::cycle
