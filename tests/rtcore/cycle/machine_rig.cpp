// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rtcore/cycle/machine_rig.hpp"

#include <algorithm>
#include <random>

#include "rtcore/sim/sim_config.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::cycle {
namespace {

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

sim::SimConfig sim_config(const Profile& profile, const std::function<void(sim::SimConfig&)>& change) {
    sim::SimConfig config = sim::sim_config_from_profile(profile);
    if (change) change(config);
    return config;
}

}  // namespace

MachineRig::MachineRig(const Profile& machine_profile, const std::function<void(sim::SimConfig&)>& change)
    : profile(machine_profile),
      machine(std::make_unique<sim::Machine>(sim_config(machine_profile, change))),
      port(std::make_unique<RecordingPort>(PinMap::from_profile(machine_profile).value(), *machine,
                                           tick_period_ns(machine_profile))),
      io(std::make_unique<CycleIo>()),
      cycle(std::make_unique<Cycle>(plan::cycle_config_from_profile(machine_profile), *port, *io)),
      planner(std::make_unique<plan::Planner>(machine_profile, *io)) {}

void MachineRig::tick() {
    if (planner->wants_poll() || cycle->next_tick() % poll_every == 0) planner->poll();
    cycle->tick();
    if (io->reports.size() > 0) drain();
    IncrementEntry entry;
    while (io->increments.pop_into(entry)) {
    }
}

void MachineRig::drain() {
    Report report;
    while (io->reports.pop_into(report)) reports.push_back(report);
}

bool MachineRig::run_while(const std::function<bool()>& condition, std::uint64_t most_ticks) {
    for (std::uint64_t n = 0; n < most_ticks; ++n) {
        if (!condition()) return true;
        tick();
    }
    return false;
}

bool MachineRig::run_until(MachineState state, std::uint64_t most_ticks) {
    return run_while([&] { return cycle->state() != state && cycle->state() != MachineState::alarm; },
                     most_ticks) &&
           cycle->state() == state;
}

void MachineRig::run(std::uint64_t ticks) {
    for (std::uint64_t n = 0; n < ticks; ++n) tick();
}

Refusal MachineRig::ask(RequestKind kind, std::uint8_t axis, std::uint64_t value) {
    Request request{};
    request.kind = kind;
    request.axis = axis;
    request.value = value;
    return ask(request);
}

Refusal MachineRig::ask(Request request) {
    request.sequence = ++sequence_;
    io->requests.push(request);
    tick();
    const auto found = std::ranges::find_if(reports, [&](const Report& report) {
        return report.kind == Report::Kind::answer && report.sequence == sequence_;
    });
    return found == reports.end() ? Refusal::not_in_this_state : found->refusal;
}

bool MachineRig::home() {
    return ask(RequestKind::home) == Refusal::none && run_until(MachineState::ready);
}

void MachineRig::load(const JobTable& table) {
    auto job = std::make_shared<OwnedJob>();
    job->blob = job_blob_from_table(table);
    job->view = JobView::check(job->blob).value();
    planner->set_job(std::shared_ptr<const JobView>(job, &job->view), 1);
    Request request{};
    request.sequence = ++sequence_;
    request.kind = RequestKind::job_loaded;
    request.value = 1;
    request.points_total = std::uint64_t{table.layer_count} * table.point_count;
    request.points_per_layer = table.point_count;
    request.runs_back = table.joining == Joining::zigzag ? 1 : 0;
    io->requests.push(request);
    tick();
}

bool MachineRig::prepare(const JobTable& table) {
    if (!home()) return false;
    load(table);
    return ask(RequestKind::start) == Refusal::none && run_until(MachineState::waiting);
}

std::vector<FlightRecord> MachineRig::records_of(RecordKind kind) const {
    std::vector<FlightRecord> found;
    for (const Report& report : reports) {
        if (report.record.kind == kind) found.push_back(report.record);
    }
    return found;
}

Profile quick_profile() {
    Profile profile;
    profile.r1.travel_mm = {0.0, 20.0};
    profile.r1.home_position_mm = 20.0;
    profile.r2 = profile.r1;
    profile.y.travel_mm = {0.0, 20.0};
    profile.job.spindle_spinup_s = 0.01;
    profile.job.planner = Planner::angle;
    profile.port.pins[index_of(Signal::estop)] = 15;
    return profile;
}

Profile always_on_profile() {
    Profile profile = quick_profile();
    for (const Axis axis : kAllAxes) profile.port.pins[index_of(enable_of(axis))] = 0;
    return profile;
}

JobTable random_job(std::uint32_t layers, std::uint32_t points, std::uint64_t seed, Joining joining) {
    std::mt19937_64 random(seed);
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = 3200;
    table.joining = joining;
    table.feed_mm_s = 20.0;
    const auto wobble = static_cast<std::int32_t>(random() % 60);
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(400 + std::int64_t{layer} * 100);
        std::int32_t left = 4000;
        std::int32_t right = 3600;
        for (std::uint32_t point = 0; point < points; ++point) {
            left = std::clamp<std::int32_t>(left + static_cast<std::int32_t>(random() % 41) - 20, 1200, 6000);
            right = std::clamp<std::int32_t>(right + static_cast<std::int32_t>(random() % 3) - 1 + wobble % 2,
                                             1200, 6000);
            table.r_left_pulses.push_back(left);
            table.r_right_pulses.push_back(right);
        }
    }
    table.source_name = "random";
    table.profile_toml = profile_to_toml(quick_profile());
    return joining == Joining::spiral ? spiral_of(table) : table;
}

std::vector<Positions> points_of(const JobTable& table) {
    std::vector<Positions> points;
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        for (std::uint32_t step = 0; step < table.point_count; ++step) {
            const std::uint32_t point = carved_point(table.joining, table.point_count, layer, step);
            const std::size_t cell = std::size_t{layer} * table.point_count + point;
            points.push_back(
                {table.r_left_pulses[cell], table.r_right_pulses[cell],
                 table_angle_pulses(table.joining, table.psi_sweep_pulses, table.point_count, layer, point),
                 table_height_pulses(table.joining, table.layer_height_pulses, table.point_count, layer,
                                     point)});
        }
    }
    return points;
}

std::uint32_t PinCounter::take(SignalWord levels) {
    const SignalWord rising = levels & ~levels_ & kStepMask;
    for (const Axis axis : kAllAxes) {
        if ((rising & bit_of(step_of(axis))) == 0) continue;
        positions_[index_of(axis)] += (levels & bit_of(dir_of(axis))) != 0 ? 1 : -1;
    }
    levels_ = levels;
    return rising;
}

std::vector<std::uint32_t> order_of(const std::vector<PortWrite>& writes) {
    PinCounter pins({});
    std::vector<std::uint32_t> order;
    for (const PortWrite& write : writes) {
        const std::uint32_t axes = pins.take(write.levels);
        if (axes != 0) order.push_back(axes);
    }
    return order;
}

}  // namespace psicarve::cycle
