// SPDX-License-Identifier: GPL-3.0-or-later
// A binary STL of a million facets, each program in a process of its own, alternating: our reading, slicing
// into 500 layers and building of a job, on one thread and on two, next to admesh reading the same file.
//   bench_read_and_slice [PSICARVE]     with the program's path also `PSICARVE slice FILE -o JOB --layers
//   500`
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/load_mesh.hpp"
#include "shared/profile.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"

extern char** environ;

namespace {

using namespace psicarve;

constexpr std::size_t kTriangles = 1'000'000;
constexpr int kRuns = 5;
constexpr double kMostCpuOfAdmesh = 0.25;
constexpr double kMostPeak_mb = 500.0;

int generate(const std::string& file) {
    const model::Mesh mesh = bench::relief_mesh(kTriangles);
    std::ofstream out(file, std::ios::binary);
    std::array<char, 80> header{};
    out.write(header.data(), header.size());
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    out.write(reinterpret_cast<const char*>(&count), sizeof(count));
    std::array<char, 50> facet{};
    for (const model::Triangle& triangle : mesh.triangles) {
        std::memcpy(facet.data() + 12, &triangle, sizeof(triangle));
        out.write(facet.data(), facet.size());
    }
    return out.good() ? 0 : 1;
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

struct Cost {
    std::string name;
    std::vector<std::string> command;
    std::vector<double> cpu_s;
    std::vector<double> wall_s;
    double peak_mb = 0.0;
    bool failed = false;
};

/// Runs the command and adds what it cost. The parent stays small: a child's peak begins with its parent's.
void run(Cost& cost) {
    std::vector<char*> arguments;
    for (std::string& word : cost.command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1, 0);
    const double begin = bench::wall_s();
    ::pid_t child = 0;
    cost.failed = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ) != 0;
    ::posix_spawn_file_actions_destroy(&actions);
    if (cost.failed) return;
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    cost.wall_s.push_back(bench::wall_s() - begin);
    cost.cpu_s.push_back(seconds(usage.ru_utime) + seconds(usage.ru_stime));
    cost.peak_mb = std::max(cost.peak_mb, static_cast<double>(usage.ru_maxrss) / 1024.0);
    cost.failed = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
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
    run(generation);
    std::vector<Cost> costs{{"admesh", {"admesh", model}, {}, {}, 0.0, false},
                            {"read, slice, build", {self, "--slice", model, "1"}, {}, {}, 0.0, false},
                            {"the same, two threads", {self, "--slice", model, "2"}, {}, {}, 0.0, false}};
    if (psicarve != nullptr) {
        costs.push_back(
            {"psicarve slice", {psicarve, "slice", model, "-o", job, "--layers", "500"}, {}, {}, 0.0, false});
    }
    for (int round = 0; round < kRuns; ++round) {
        for (Cost& cost : costs) run(cost);
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
