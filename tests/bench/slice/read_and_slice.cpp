// SPDX-License-Identifier: GPL-3.0-or-later
// A binary STL of a million facets, each program in a process of its own, alternating: our reading, slicing
// into 500 layers and building of a job, on one thread and on two, next to admesh reading the same file.
//   bench_read_and_slice [PSICARVE]     with the program's path also `PSICARVE slice FILE -o JOB --layers
//   500`
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/load_mesh.hpp"
#include "shared/profile/profile.hpp"
#include "tests/bench/slice/binary_stl.hpp"
#include "tests/bench/slice/child_cost.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"

namespace {

using namespace psicarve;
using bench::Cost;

constexpr std::size_t kTriangles = 1'000'000;
constexpr int kRuns = 5;
constexpr double kMostCpuOfAdmesh = 0.25;
constexpr double kMostPeak_mb = 500.0;

int generate(const std::string& file) {
    return bench::write_binary_stl(bench::relief_mesh(kTriangles).triangles, file) ? 0 : 1;
}

int read_and_slice(const std::string& file, unsigned thread_count) {
    const auto mesh = model::load_mesh(file);
    if (!mesh) {
        std::fprintf(stderr, "%s\n", mesh.error().message.c_str());
        return 1;
    }
    cam::JobOptions options;
    options.layer_count = 500;
    options.thread_count = thread_count;
    const auto job = cam::build_job(*mesh, Profile{}, options);
    if (!job) {
        std::fprintf(stderr, "%s\n", job.error().message.c_str());
        return 1;
    }
    return 0;
}

void print(const Cost& cost) {
    if (cost.failed || cost.cpu_s.empty()) {
        std::printf("%s: could not be run, left out\n", cost.name.c_str());
        return;
    }
    std::printf("%s: CPU %.0f ms, wall %.0f ms, peak memory %.0f MB\n", cost.name.c_str(),
                1e3 * bench::median(cost.cpu_s), 1e3 * bench::median(cost.wall_s), cost.peak_mb);
}

void compare_with_admesh(const Cost& ours, const Cost& admesh) {
    if (ours.failed || admesh.failed || ours.cpu_s.empty() || admesh.cpu_s.empty()) return;
    const double ratio = bench::median(ours.cpu_s) / bench::median(admesh.cpu_s);
    std::printf("%s: %.3f of admesh's CPU time (wanted at most %.2f): %s; peak %.0f MB (under %.0f): %s\n",
                ours.name.c_str(), ratio, kMostCpuOfAdmesh, ratio <= kMostCpuOfAdmesh ? "ok" : "TOO SLOW",
                ours.peak_mb, kMostPeak_mb, ours.peak_mb < kMostPeak_mb ? "ok" : "TOO MUCH");
}

int compare(const std::string& self, const char* psicarve) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("psicarve-bench-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    const std::string model = folder / "relief.stl";
    const std::string job = folder / "relief.job";
    Cost generation{"generate", {self, "--generate", model}, {}, {}, 0.0, false};
    bench::run(generation);
    std::vector<Cost> costs{{"admesh", {"admesh", model}, {}, {}, 0.0, false},
                            {"read, slice, build", {self, "--slice", model, "1"}, {}, {}, 0.0, false},
                            {"the same, two threads", {self, "--slice", model, "2"}, {}, {}, 0.0, false}};
    if (psicarve != nullptr) {
        costs.push_back(
            {"psicarve slice", {psicarve, "slice", model, "-o", job, "--layers", "500"}, {}, {}, 0.0, false});
    }
    for (int round = 0; round < kRuns; ++round) {
        for (Cost& cost : costs) bench::run(cost);
    }
    std::filesystem::remove_all(folder);
    for (const Cost& cost : costs) print(cost);
    for (std::size_t i = 1; i < costs.size(); ++i) {
        if (i != 2) compare_with_admesh(costs[i], costs[0]);
    }
    if (!costs[1].failed && !costs[2].failed) {
        std::printf("two threads: %.2f times faster by the clock\n",
                    bench::median(costs[1].wall_s) / bench::median(costs[2].wall_s));
    }
    return generation.failed || costs[1].failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == "--generate") return generate(words[1]);
    if (words.size() == 3 && words[0] == "--slice") {
        return read_and_slice(words[1], static_cast<unsigned>(std::atoi(words[2].c_str())));
    }
    return compare(std::filesystem::canonical("/proc/self/exe"), argc > 1 ? argv[1] : nullptr);
}
