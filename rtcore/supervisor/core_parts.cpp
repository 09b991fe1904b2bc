// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/core_parts.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "rtcore/cycle/inputs.hpp"
#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/port/open_port.hpp"
#include "rtcore/port/parallel_port.hpp"
#include "rtcore/port/sim_port.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "rtcore/supervisor/piece_file.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::supervisor {
namespace {

sim::SimConfig machine_for(const Profile& profile, const HomedStart& homed_start) {
    sim::SimConfig config = sim::sim_config_from_profile(profile);
    if (homed_start) {
        for (const Axis axis : kAllAxes) config.axis(axis).start_pulses = (*homed_start)[index_of(axis)];
    }
    return config;
}

/// The gaps as the core takes them to be: a replay may begin with some crossed.
trace::TraceStart trace_start_of(const CoreParts& parts) {
    trace::TraceStart start;
    start.period_ns = parts.period_ns;
    start.crossed_pulses = parts.cycle->pulses().crossed_pulses();
    if (parts.machine == nullptr) return start;  // where a real machine stands is not known
    for (const Axis axis : kAllAxes)
        start.position_pulses[index_of(axis)] = parts.machine->position_pulses(axis);
    return start;
}

Result<void> make_port(CoreParts& parts, const PinMap& pin_map, PartsRequest& request,
                       const std::string& piece_path) {
    if (!request.real_port) {
        const sim::SimConfig config = machine_for(request.machine, request.homed_start);
        parts.machine = std::make_unique<sim::Machine>(config);
        if (!piece_path.empty()) {
            if (auto put = put_blank_on_table(*parts.machine, config); !put) return put;
        }
        parts.port = std::make_unique<port::SimPort>(pin_map, *parts.machine);
        return {};
    }
    parts.guard = std::move(request.real_port->guard);
    // A guard has more of it.
    constexpr std::chrono::milliseconds kAlone{60'000};
    const auto patience = parts.guard == nullptr ? kAlone : std::chrono::milliseconds{0};
    parts.port = std::make_unique<port::ParallelPort>(std::move(request.real_port->open), pin_map,
                                                      port::PulseTimes{parts.profile.port}, patience);
    return {};
}

}  // namespace

std::array<std::int64_t, kAxisCount> home_positions(const Profile& profile) {
    std::array<std::int64_t, kAxisCount> positions{};
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        std::int64_t& position = positions[index_of(axis)];
        position = motion.home_position_pulses;
        if (motion.has_travel)
            position = std::clamp(position, motion.travel_min_pulses, motion.travel_max_pulses);
    }
    return positions;
}

Result<std::unique_ptr<CoreParts>> build_core(const CoreOptions& options, const Profile& profile,
                                              PartsRequest request) {
    auto parts = std::make_unique<CoreParts>();
    parts->profile = profile;
    parts->period_ns = tick_period_ns(profile);
    parts->port_name = port::port_text(options.port);
    parts->planned_files = {options.layer_times_path, options.point_times_path};
    parts->state_folder = options.state_folder;
    const auto pin_map = PinMap::from_profile(profile);
    if (!pin_map) return pin_map.error();
    if (const auto made = make_port(*parts, *pin_map, request, options.piece_path); !made)
        return made.error();
    if (request.plays_recorded_inputs) {
        const SignalWord heeded = options.port.is_simulated() ? 0 : cycle::kLimitMask | cycle::kEstopBit;
        auto recorded = std::make_unique<RecordedInputsPort>(std::move(parts->port), heeded);
        parts->recorded_inputs = recorded.get();
        parts->port = std::move(recorded);
    }
    parts->traces = TraceOutlet{options.clock == ClockKind::real ? TraceOutlet::WhenFull::loses
                                                                 : TraceOutlet::WhenFull::waits};
    parts->io = std::make_unique<cycle::CycleIo>();
    parts->trace_ring = std::make_unique<trace::TraceRing>();
    parts->io->trace = parts->trace_ring.get();
    parts->cycle =
        std::make_unique<cycle::Cycle>(plan::cycle_config_from_profile(profile), *parts->port, *parts->io);
    if (request.homed_start)
        parts->cycle->assume_homed(*request.homed_start, request.start_levels, request.start_gaps);
    if (const auto opened = parts->traces.open(options.trace_paths, trace_start_of(*parts)); !opened) {
        return opened.error();
    }
    parts->io->traces_always = parts->traces.is_open();
    parts->planner = std::make_unique<plan::Planner>(profile, *parts->io);
    if (!request.homed_start && !options.no_estimate)
        parts->estimator =
            std::make_unique<plan::JobEstimator>(profile, !parts->planned_files.points.empty());
    return parts;
}

}  // namespace psicarve::supervisor
