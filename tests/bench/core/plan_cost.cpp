// SPDX-License-Identifier: GPL-3.0-or-later
// What planning a job costs: processor time a point, as a share of the time that the carving takes, and until
// the first block can go to the tick. The heap is kept as the core keeps its own.
//
//     plan_cost JOB...     jobs as psicarve slice writes them; the profile is each job's own
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>

#include "rtcore/plan/lookahead_program.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/record/snapshot_file.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

constexpr int kRounds = 7;

double processor_s() {
    std::timespec at{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
}

struct Cost {
    double seconds = 1e30;  ///< the least of all rounds
    double first_s = 1e30;  ///< until there was a block
    std::uint64_t blocks = 0;
    double carving_s = 0.0;
};

double seconds_of(const cycle::MotionBlock& block) {
    if (block.kind != cycle::BlockKind::path) return 0.0;
    const cycle::PathTiming& path = block.path;
    return 2.0 * path.length / (std::sqrt(path.start_speed2[0]) + std::sqrt(path.end_speed2[0]));
}

Cost cost_of(const plan::MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    Cost cost;
    for (int round = 0; round < kRounds; ++round) {
        const double begin_s = processor_s();
        plan::LookaheadProgram program(limits, job);
        cycle::MotionBlock block;
        cost.blocks = 0;
        cost.carving_s = 0.0;
        while (program.next(block)) {
            if (cost.blocks == 0) cost.first_s = std::min(cost.first_s, processor_s() - begin_s);
            ++cost.blocks;
            cost.carving_s += seconds_of(block);
        }
        cost.seconds = std::min(cost.seconds, processor_s() - begin_s);
    }
    return cost;
}

Result<void> measure(const char* path) {
    const auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    const auto view = JobView::check(snapshot.value().job_blob);
    if (!view) return view.error();
    const auto profile = job_profile(view.value());
    if (!profile) return profile.error();
    const auto job = std::make_shared<const JobView>(view.value());
    const Cost cost = cost_of(plan::machine_limits(profile.value()), job);
    const double points = static_cast<double>(job->layer_count()) * job->point_count();
    std::printf(
        "%s: %.0f ns a point, %.4f %% of %.3f s of carving, %.2f segments a point, the first after %.2f ms\n",
        path, cost.seconds / points * 1e9, 100.0 * cost.seconds / cost.carving_s, cost.carving_s,
        static_cast<double>(cost.blocks) / points, cost.first_s * 1e3);
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: plan_cost JOB...\n", stderr);
        return 2;
    }
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_MMAP_MAX, 0);
    bool all_read = true;
    for (int i = 1; i < argc; ++i) {
        const auto measured = measure(argv[i]);
        if (measured) continue;
        std::fprintf(stderr, "plan_cost: %s\n", measured.error().message.c_str());
        all_read = false;
    }
    return all_read ? 0 : 3;
}
