// SPDX-License-Identifier: GPL-3.0-or-later
// How long a ready job of 500 x 500 points takes from the call that publishes it until a real core process
// has accepted it. Target: 20 ms.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "hmi/machine/core_process.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "tests/places.hpp"

namespace {

using namespace psicarve;

constexpr std::uint32_t kLayers = 500;
constexpr std::uint32_t kPoints = 500;
constexpr int kRuns = 51;
constexpr double kTargetMs = 20.0;

/// A lobed column: no two neighbouring radii alike, as in a real piece.
JobTable lobed_column(const Profile& profile) {
    JobTable table;
    table.layer_count = kLayers;
    table.point_count = kPoints;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = profile.job.feed_mm_s;
    table.source_name = "lobed-column";
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    for (std::uint32_t layer = 0; layer < kLayers; ++layer) {
        table.layer_height_pulses.push_back(pulses_from_mm(0.2 * layer + 0.1, profile.y.pulses_per_mm));
        for (std::uint32_t point = 0; point < kPoints; ++point) {
            const double angle_rad = kPi * point / (kPoints - 1) + 0.01 * layer;
            const double radius_mm = 15.0 + 3.0 * std::cos(5.0 * angle_rad);
            const auto pulses =
                static_cast<std::int32_t>(pulses_from_mm(radius_mm, profile.r1.pulses_per_mm));
            table.r_left_pulses.push_back(pulses);
            table.r_right_pulses.push_back(pulses);
        }
    }
    return table;
}

int fail(const Error& error) {
    std::fprintf(stderr, "publish_latency: %s\n", error.message.c_str());
    return 1;
}

int measure(bool on_real_clock) {
    const Profile profile;
    const std::vector<std::byte> blob = job_blob_from_table(lobed_column(profile));
    machine::CoreLaunch launch;
    launch.segment_name = "/psicarve-bench-" + std::to_string(getpid());
    launch.is_private = true;
    launch.on_real_clock = on_real_clock;
    auto core = machine::CoreProcess::start(launch);
    if (!core) return fail(core.error());
    auto link = machine::MachineLink::attach(launch.segment_name);
    if (!link) return fail(link.error());
    std::vector<double> times_ms;
    for (int run = 0; run < kRuns; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const auto published = link->publish(blob);
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
        if (!published) return fail(published.error());
        times_ms.push_back(taken.count());
    }
    const double first_ms = times_ms.front();
    std::sort(times_ms.begin(), times_ms.end());
    std::printf(
        "publish to accepted, %u x %u points (%.1f MB), %s clock, %d runs: first %.2f ms, median %.2f ms, "
        "max %.2f ms; target %.0f ms, median is %.2f of it\n",
        kLayers, kPoints, static_cast<double>(blob.size()) / 1e6, on_real_clock ? "real" : "virtual", kRuns,
        first_ms, times_ms[times_ms.size() / 2], times_ms.back(), kTargetMs,
        times_ms[times_ms.size() / 2] / kTargetMs);
    return 0;
}

}  // namespace

int main() {
    // The core is looked for beside the running program, then in PATH.
    const char* path = std::getenv("PATH");
    setenv("PATH", (in_build("bin:") + (path != nullptr ? path : "")).c_str(), 1);
    const int on_virtual_clock = measure(false);
    return on_virtual_clock != 0 ? on_virtual_clock : measure(true);
}
