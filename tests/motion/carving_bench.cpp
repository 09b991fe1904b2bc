// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/motion/carving_bench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shared/base/units.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::motion {
namespace {

using cycle::MachineRig;
using cycle::RequestKind;
using trace::TraceEntry;

/// The trace's way from the tick to the verifier.
class Witness {
public:
    Witness(const JobView& job, const Profile& profile, trace::TraceRing& ring, bool is_dry)
        : verifier_(verify::Verifier::make_for(job, profile, {.carves = !is_dry}).value()), ring_(&ring) {
        period_ns_ = tick_period_ns(profile);
        verify::TraceStart start;
        start.present = (SignalWord{1} << kSignalCount) - 1;
        start.has_positions = true;
        start.period_ns = period_ns_;
        EXPECT_TRUE(verifier_.begin(start).has_value());
    }
    void drain() {
        TraceEntry entry;
        std::vector<verify::TraceEvent> events;
        while (ring_->pop_into(entry)) {
            if (entry.kind == TraceEntry::Kind::job) continue;
            verify::TraceEvent event;
            event.time_ns = static_cast<std::int64_t>(entry.tick) * period_ns_;
            event.levels = entry.levels;
            if (entry.kind == TraceEntry::Kind::position) event.kind = verify::TraceEvent::Kind::position;
            event.position_pulses = entry.position_pulses;
            events.push_back(event);
        }
        verifier_.feed(events);
    }
    verify::VerifyReport finish() {
        drain();
        return verifier_.finish();
    }

private:
    verify::Verifier verifier_;
    trace::TraceRing* ring_;
    std::int64_t period_ns_ = 0;
};

bool is_at_work(const MachineRig& rig) {
    const MachineState state = rig.cycle->state();
    return state == MachineState::carving || state == MachineState::holding || state == MachineState::held;
}

}  // namespace

std::vector<NamedShape> sample_shapes() {
    const auto noise = [](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        return static_cast<double>(random() % 10'000) / 10'000.0 - 0.5;
    };
    return {
        {"vase", [](double, std::uint32_t layer) { return 10.0 + 1.5 * std::sin(0.3 * layer); }},
        {"figurine",
         [](double at, std::uint32_t layer) {
             return 9.0 + 1.2 * std::cos(5.0 * at + 0.2 * layer) + 0.5 * std::cos(13.0 * at);
         }},
        {"gear", [](double at, std::uint32_t) { return std::sin(12.0 * at) > 0.0 ? 10.0 : 8.5; }},
        {"relief",
         [noise](double at, std::uint32_t layer) {
             const auto cell = static_cast<std::uint64_t>(at * 100'000.0) * 1'000 + layer;
             return 9.0 + 0.3 * std::cos(3.0 * at) + 0.15 * noise(cell);
         }},
    };
}

JobTable table_of(const Profile& profile, const Shape& shape, std::uint32_t layers, std::uint32_t points,
                  Joining joining) {
    const auto pulses = [](const LinearAxisProfile& axis, double value_mm) {
        return static_cast<std::int32_t>(std::lround(value_mm * axis.pulses_per_mm));
    };
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = profile.job.feed_mm_s;
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(pulses(profile.y, 1.0 + 0.2 * layer));
        for (std::uint32_t point = 0; point < points; ++point) {
            const double part = static_cast<double>(point) / static_cast<double>(points - 1);
            const double direction = std::numbers::pi * (part + layer);
            table.r_left_pulses.push_back(pulses(profile.r1, shape(direction, layer)));
            table.r_right_pulses.push_back(pulses(profile.r2, shape(direction + std::numbers::pi, layer)));
        }
    }
    table.source_name = "shape";
    table.profile_toml = profile_to_toml(profile);
    return joining == Joining::spiral ? spiral_of(table) : table;
}

Carved carved(const Profile& profile, const JobTable& table, const Disturbance& disturb,
              const Conditions& conditions) {
    Carved result;
    const std::vector<std::byte> blob = job_blob_from_table(table);
    const JobView view = JobView::check(blob).value();
    const auto ring = std::make_unique<trace::TraceRing>();
    MachineRig rig(profile, conditions.machine);
    rig.io->trace = ring.get();
    Witness witness(view, conditions.judged_by.value_or(profile), *ring, conditions.layers.is_dry);
    const auto drain_while = [&](const std::function<bool()>& condition) {
        while (condition()) {
            for (int n = 0; n < 1000 && condition(); ++n) rig.tick();
            witness.drain();
        }
    };
    EXPECT_EQ(rig.ask(RequestKind::home), cycle::Refusal::none);
    drain_while([&] { return rig.cycle->state() == MachineState::homing; });
    rig.load(table);
    EXPECT_EQ(rig.ask(RequestKind::start, 0, cycle::packed(conditions.layers)), cycle::Refusal::none);
    drain_while([&] { return rig.cycle->state() == MachineState::positioning; });
    rig.port->writes.clear();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), cycle::Refusal::none);
    drain_while([&] {
        if (disturb && is_at_work(rig)) disturb(rig);
        return is_at_work(rig);
    });
    result.order = order_of(rig.port->writes);
    result.iterations = result.order.size();
    result.waited_ticks = rig.cycle->sample().waited_ticks;
    drain_while([&] {
        return rig.cycle->state() == MachineState::finishing || rig.cycle->state() == MachineState::stopping;
    });
    EXPECT_EQ(rig.cycle->state(), MachineState::ready);
    const cycle::Sample sample = rig.cycle->sample();
    result.carve_s = static_cast<double>(sample.carve_last_tick - sample.carve_first_tick) *
                     static_cast<double>(tick_period_ns(profile)) * 1e-9;
    result.t_ref_s = rig.planner->reference_seconds();
    const sim::SimReport machine = rig.machine->report();
    for (const Axis axis : kAllAxes) result.stalls += machine.axis(axis).stalls;
    result.report = witness.finish();
    return result;
}

}  // namespace psicarve::motion
