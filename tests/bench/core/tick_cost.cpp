// SPDX-License-Identifier: GPL-3.0-or-later
// What a tick costs while carving: alone, with a port that does nothing (median and 99.9th percentile), of a
// job and of a program of motion records, in turns. Both carve the same table at the same feed, so that they
// have as many pulses and segments a tick, which is told, too. Wanted is a ratio of
// the medians of at most 1.05, the middle one of five rounds; else it ends with 1. And with the simulated
// machine behind it (ticks a second on the virtual clock, without a trace). What planning costs a point:
// plan_cost.
#include <x86intrin.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rtcore/cycle/cycle.hpp"
#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/plan/planner.hpp"
#include "rtcore/port/sim_port.hpp"
#include "rtcore/sim/machine.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"
#include "tests/bench/core/null_port.hpp"
#include "tests/rtcore/plan/scripted_source.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

constexpr double kMostProgramRatio = 1.05;

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

/// A wavy body: half the radii change at every point.
std::shared_ptr<const JobView> wavy_job(const Profile& profile, std::uint32_t layers, std::uint32_t points) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = profile.job.feed_mm_s;
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(1000 + std::int64_t{layer} * 40);
        for (std::uint32_t point = 0; point < points; ++point) {
            const auto wave = static_cast<std::int32_t>((point + 7 * layer) % 50);
            table.r_left_pulses.push_back(8000 + 4 * (wave < 25 ? wave : 50 - wave));
            table.r_right_pulses.push_back(8100 - 3 * (wave < 25 ? wave : 50 - wave));
        }
    }
    table.source_name = "wavy";
    table.profile_toml = profile_to_toml(profile);
    auto job = std::make_shared<OwnedJob>();
    job->blob = job_blob_from_table(table);
    job->view = JobView::check(job->blob).value();
    return {job, &job->view};
}

/// What the job's feed over the surface leaves for this way, as the faster of the heads has it.
double seconds_of(const plan::Pulses4& from, const plan::Pulses4& to, const Profile& profile) {
    const double turn = rad_from_pulses(to[2] - from[2], profile.psi.pulses_per_rev);
    const double lift_mm = static_cast<double>(to[3] - from[3]) / profile.y.pulses_per_mm;
    double longest_mm = 0.0;
    for (std::size_t head = 0; head < 2; ++head) {
        const double per_mm = (head == 0 ? profile.r1 : profile.r2).pulses_per_mm;
        const double around_mm = 0.5 * static_cast<double>(from[head] + to[head]) / per_mm * turn;
        const double out_mm = static_cast<double>(to[head] - from[head]) / per_mm;
        longest_mm = std::max(longest_mm, std::hypot(around_mm, out_mm, lift_mm));
    }
    return longest_mm / profile.job.feed_mm_s;
}

/// The same points in the same order and at the same feed, as a program's ways.
std::vector<plan::ProgramStep> program_of(const JobView& job, const Profile& profile,
                                          const plan::Pulses4& start) {
    plan::test::Script script{start};
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        for (std::uint32_t step = 0; step < job.point_count(); ++step) {
            const std::uint32_t point = carved_point(job.joining(), job.point_count(), layer, step);
            const plan::Pulses4 to{job.r_left_pulses(layer)[point], job.r_right_pulses(layer)[point],
                                   job.psi_pulses(layer, point), job.y_pulses(layer, point)};
            plan::Pulses4 way{};
            for (std::size_t k = 0; k < kAxisCount; ++k) way[k] = to[k] - script.at()[k];
            script.way(way, profile.job.path_tolerance_mm, seconds_of(script.at(), to, profile));
        }
    }
    return std::move(script.end().steps);
}

struct Core {
    Core(const Profile& profile, port::Port& port)
        : io(std::make_unique<cycle::CycleIo>()),
          cycle(plan::cycle_config_from_profile(profile), port, *io),
          planner(profile, *io) {}
    void tick() {
        if (planner.wants_poll()) planner.poll();
        cycle.tick();
    }
    void ask(cycle::RequestKind kind, const JobView* job = nullptr) {
        cycle::Request request{};
        request.kind = kind;
        if (job != nullptr) {
            request.points_total = std::uint64_t{job->layer_count()} * job->point_count();
            request.points_per_layer = job->point_count();
        }
        io->requests.push(request);
    }
    bool has_carved(const JobView& job) const {
        return cycle.sample().points_done == std::uint64_t{job.layer_count()} * job.point_count();
    }
    void drain() {
        cycle::Report report;
        while (io->reports.pop_into(report)) {
        }
        IncrementEntry entry;
        while (io->increments.pop_into(entry)) {
        }
    }
    void run_until(MachineState state) {
        while (cycle.state() != state) {
            tick();
            drain();
        }
    }
    void start_program(std::vector<plan::ProgramStep> steps, const plan::Pulses4& start) {
        constexpr std::uint64_t kProgram = 7;
        cycle.assume_homed(start);
        planner.set_source(std::make_shared<plan::test::ScriptedSource>(std::move(steps)), kProgram);
        cycle::Request request{};
        request.kind = cycle::RequestKind::run_program;
        request.value = kProgram;
        io->requests.push(request);
        run_until(MachineState::carving);
    }
    void start(const std::shared_ptr<const JobView>& job, const sim::Machine* machine) {
        if (machine == nullptr) {
            cycle.assume_homed({8600, 8600, 0, 400});
        } else {
            ask(cycle::RequestKind::home);
            run_until(MachineState::ready);
        }
        planner.set_job(job, 0);
        ask(cycle::RequestKind::job_loaded, job.get());
        ask(cycle::RequestKind::start);
        run_until(MachineState::waiting);
        ask(cycle::RequestKind::start_interpolation);
        run_until(MachineState::carving);
    }

    std::unique_ptr<cycle::CycleIo> io;
    cycle::Cycle cycle;
    plan::Planner planner;
};

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double ns_per_count() {
    const double start_s = now_s();
    const std::uint64_t start = __rdtsc();
    while (now_s() - start_s < 0.1) {
    }
    return (now_s() - start_s) * 1e9 / static_cast<double>(__rdtsc() - start);
}

/// A figure of less than the whole job would be of another one.
void fail_to_carve(MachineState state) {
    std::printf("not carved to its end: %s\n", std::string{name_of(state)}.c_str());
    std::exit(1);
}

/// What the ticks of one core take, and what is done in them.
class TickTimes {
public:
    static constexpr std::size_t kBatch = 16;  // the counter's own steps are as long as a tick

    TickTimes(Core& core, const char* what) : core_(&core), what_(what) {}
    void take() {
        if (core_->planner.wants_poll()) core_->planner.poll();
        core_->drain();
        const std::size_t queued = core_->io->blocks.size();
        const std::uint64_t pulses = pulses_so_far();
        const std::uint64_t batch_start = __rdtsc();
        for (std::size_t n = 0; n < kBatch; ++n) core_->cycle.tick();
        batches_.push_back(static_cast<std::uint32_t>(__rdtsc() - batch_start));
        for (std::size_t n = 0; n < kBatch; ++n) {
            const std::uint64_t start = __rdtsc();
            core_->cycle.tick();
            singles_.push_back(static_cast<std::uint32_t>(__rdtsc() - start));
        }
        if (core_->cycle.state() != MachineState::carving) fail_to_carve(core_->cycle.state());
        segments_ += queued - core_->io->blocks.size();
        pulses_ += pulses_so_far() - pulses;
    }
    /// Tells of them, and forgets them; the median [ns].
    double tell(double ns_scale) {
        const auto at = [&](std::vector<std::uint32_t>& times, double part) {
            std::ranges::sort(times);
            return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))] * ns_scale;
        };
        const double median_ns = at(batches_, 0.5) / kBatch;
        const auto ticks = static_cast<double>(2 * singles_.size());
        std::printf(
            "tick, null port, %-8s median %.1f ns (of %zu in a row), p99.9 %.1f ns (single, clock included);"
            " %.3f pulses and %.4f segments a tick\n",
            what_, median_ns, kBatch, at(singles_, 0.999), static_cast<double>(pulses_) / ticks,
            static_cast<double>(segments_) / ticks);
        singles_.clear();
        batches_.clear();
        segments_ = pulses_ = 0;
        return median_ns;
    }

private:
    std::uint64_t pulses_so_far() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t of_axis : core_->cycle.pulses().emitted()) sum += of_axis;
        return sum;
    }

    Core* core_;
    const char* what_;
    std::vector<std::uint32_t> singles_;
    std::vector<std::uint32_t> batches_;
    std::uint64_t segments_ = 0;
    std::uint64_t pulses_ = 0;
};

/// A program's tick by a job's: both in turns, some thousand at a time, as others may keep the computer busy.
double measure_ticks(const Profile& profile) {
    constexpr std::uint32_t kLayers = 100;
    constexpr int kRounds = 5;
    constexpr int kTurns = 100;
    constexpr int kBatchesInATurn = 200;
    const auto job = wavy_job(profile, kLayers, 500);
    const plan::Pulses4 start{8600, 8600, 0, 3000};
    bench::NullPort port;
    Core of_job(profile, port);
    of_job.start(job, nullptr);
    Core of_program(profile, port);
    of_program.start_program(program_of(*job, profile, start), start);
    TickTimes job_times{of_job, "job:"};
    TickTimes program_times{of_program, "program:"};
    const double scale = ns_per_count();
    std::array<double, kRounds> ratios{};
    for (double& ratio : ratios) {
        for (int turn = 0; turn < kTurns; ++turn) {
            for (int n = 0; n < kBatchesInATurn; ++n) job_times.take();
            for (int n = 0; n < kBatchesInATurn; ++n) program_times.take();
        }
        const double job_ns = job_times.tell(scale);
        ratio = program_times.tell(scale) / job_ns;
    }
    std::ranges::sort(ratios);
    const double median = ratios[kRounds / 2];
    std::printf("a program's tick costs %.3f of a job's (%.3f to %.3f; wanted: at most %.2f)\n", median,
                ratios.front(), ratios.back(), kMostProgramRatio);
    return median;
}

void measure_virtual_clock(const Profile& profile, const std::shared_ptr<const JobView>& job) {
    sim::Machine machine(sim::sim_config_from_profile(profile));
    port::SimPort port(PinMap::from_profile(profile).value(), machine);
    Core core(profile, port);
    core.start(job, &machine);
    const double start_s = now_s();
    const std::uint64_t first = core.cycle.next_tick();
    while (core.cycle.state() == MachineState::carving) {
        for (int n = 0; n < 4096 && core.cycle.state() == MachineState::carving; ++n) core.tick();
        core.drain();
    }
    if (!core.has_carved(*job)) return fail_to_carve(core.cycle.state());
    const double ticks = static_cast<double>(core.cycle.next_tick() - first);
    const double wall_s = now_s() - start_s;
    std::printf("virtual clock, simulated machine: %.2f million ticks/s (%.0f ticks, %.1f ns each)\n",
                ticks / wall_s / 1e6, ticks, wall_s / ticks * 1e9);
}

}  // namespace

int main() {
    const Profile profile;
    const double ratio = measure_ticks(profile);
    const auto job = wavy_job(profile, 60, 500);
    for (int round = 0; round < 3; ++round) measure_virtual_clock(profile, job);
    return ratio <= kMostProgramRatio ? 0 : 1;
}
