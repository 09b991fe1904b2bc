// SPDX-License-Identifier: GPL-3.0-or-later
// Ticks a second of the virtual clock while a job is carved on the simulated machine: the whole core process,
// one thread, its own CPU time; without a trace and with the binary one.
//
//   virtual_clock PSICARVE-RTCORE [RUNS]

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/record/snapshot_file.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"

extern char** environ;

namespace {

using namespace psicarve;

/// 100 layers x 500 points of a lobed body on the built-in machine.
Snapshot lobed_job() {
    const Profile profile;
    JobTable table;
    table.layer_count = 100;
    table.point_count = 500;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = profile.job.feed_mm_s;
    table.source_name = "lobed";
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses.push_back(pulses_from_mm(1.0 + 0.1 * layer, profile.y.pulses_per_mm));
        for (std::uint32_t point = 0; point < table.point_count; ++point) {
            const auto psi =
                table_angle_pulses(table.joining, table.psi_sweep_pulses, table.point_count, layer, point);
            const double angle_rad = rad_from_pulses(psi, profile.psi.pulses_per_rev);
            const auto radius_pulses = [&](double angle) {
                const double radius_mm =
                    15.0 + 2.0 * std::cos(5.0 * angle) + std::cos(13.0 * angle + 0.1 * layer);
                return static_cast<std::int32_t>(pulses_from_mm(radius_mm, profile.r1.pulses_per_mm));
            };
            table.r_left_pulses.push_back(radius_pulses(angle_rad));
            table.r_right_pulses.push_back(radius_pulses(angle_rad + kPi));
        }
    }
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(table);
    return snapshot;
}

double cpu_seconds(const rusage& usage) {
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Million ticks per second of the core's CPU time.
double run_once(const std::string& core, const std::string& job, const std::string& trace) {
    const std::string segment_name = "/psicarve-bench-" + std::to_string(getpid());
    std::vector<std::string> words{core, "--segment", segment_name, "--clock", "virtual", "--replay", job};
    if (!trace.empty()) words.insert(words.end(), {"--trace", trace});
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t pid = -1;
    if (posix_spawn(&pid, core.c_str(), nullptr, nullptr, pointers.data(), environ) != 0) {
        std::perror(core.c_str());
        std::exit(1);
    }
    int status = 0;
    rusage usage{};
    wait4(pid, &status, 0, &usage);
    const auto segment = Segment::attach(segment_name);
    if (status != 0 || !segment) {
        std::fprintf(stderr, "the core failed\n");
        std::exit(1);
    }
    const auto end = read_record(segment->header().status);
    [[maybe_unused]] const auto removed = Segment::remove(segment_name);
    return end ? 1e-6 * static_cast<double>(end->tick) / cpu_seconds(usage) : 0.0;
}

void report(const char* name, std::vector<double> rates, double wanted) {
    std::ranges::sort(rates);
    std::printf("%-28s median %6.1f million ticks/s of CPU time (min %.1f, max %.1f); wanted %.0f\n", name,
                rates[rates.size() / 2], rates.front(), rates.back(), wanted);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s PSICARVE-RTCORE [RUNS]\n", argv[0]);
        return 2;
    }
    const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
    const std::string base = "/tmp/psicarve-bench-" + std::to_string(getpid());
    if (!save_snapshot(lobed_job(), base + ".job")) return 1;
    std::vector<double> plain;
    std::vector<double> traced;
    for (int run = 0; run < runs; ++run) {
        plain.push_back(run_once(argv[1], base + ".job", ""));
        traced.push_back(run_once(argv[1], base + ".job", base + ".trace"));
    }
    report("without a trace", plain, 10.0);
    report("with the binary trace", traced, 2.0);
    unlink((base + ".job").c_str());
    unlink((base + ".trace").c_str());
    return 0;
}
