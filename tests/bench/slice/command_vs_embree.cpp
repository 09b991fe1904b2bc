// SPDX-License-Identifier: GPL-3.0-or-later
// The whole command, from its start to the written job, against what Embree 3 takes to load, build and trace
// the same samples, in alternating runs: CPU time of one thread each.
//   bench_command_vs_embree [--points N] PSICARVE MESH...
// 500 layers x N points (1000); MESH in any format that slice takes.
// Each mesh is written as a binary STL first, which both read: a plain copy of its facets for Embree (robust
// scene, one thread, a first-hit ray from outside for each sample of both heads), the program with all its
// checks and warnings. Embree's start is not counted, the program's is.
#include <embree3/rtcore.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/best_axis.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/profile/profile.hpp"
#include "tests/bench/slice/binary_stl.hpp"
#include "tests/bench/slice/child_cost.hpp"
#include "tests/bench/slice/embree_trace.hpp"
#include "tests/bench/slice/measure.hpp"

namespace {

using namespace psicarve;

constexpr std::size_t kLayers = 500;
constexpr int kUsualPoints = 1000;
constexpr int kRuns = 7;
constexpr double kMostOfEmbree = 0.5;

/// The samples of the program's job: about the middle of the box.
bench::Rays rays_of(const model::Mesh& mesh, int points) {
    const auto& low = mesh.facts.min;
    const auto& high = mesh.facts.max;
    const slice::Placement placement{slice::Up::z, 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
    bench::Rays rays;
    rays.heights = slice::layer_heights(low[2], high[2] - low[2], kLayers);
    rays.angles_rad = slice::full_circle_rad(points, Profile{}.psi.pulses_per_rev, 0.0);
    rays.axis_x = static_cast<float>(placement.axis_x);
    rays.axis_y = static_cast<float>(placement.axis_y);
    rays.outside = static_cast<float>(1.1 * slice::largest_radius(mesh, placement));
    return rays;
}

/// How many of Embree's rays meet the model.
std::size_t run_embree(const std::string& file, const bench::Rays& rays, RTCDevice device,
                       std::vector<double>& runs_s) {
    std::vector<double> radius(rays.heights.size() * rays.angles_rad.size());
    const double begin = bench::cpu_s();
    bench::trace_with_embree(bench::read_binary_stl_plainly(file), rays, device, radius);
    runs_s.push_back(bench::cpu_s() - begin);
    return static_cast<std::size_t>(
        std::count_if(radius.begin(), radius.end(), [](double r) { return r > 0.0; }));
}

/// Whether the program was fast enough.
bool compare(const std::string& psicarve, const std::string& path, const std::string& folder, int points,
             RTCDevice device) {
    const auto mesh = model::load_mesh(path);
    if (!mesh) {
        std::fprintf(stderr, "%s\n", mesh.error().message.c_str());
        return false;
    }
    const std::string model = folder + "/model.stl";
    if (!bench::write_binary_stl(mesh->triangles, model)) return false;
    const bench::Rays rays = rays_of(*mesh, points);
    bench::Cost ours{"psicarve slice",
                     {psicarve, "slice", model, "-o", folder + "/model.job", "--fit", "--layers",
                      std::to_string(kLayers), "--points", std::to_string(points), "--threads", "1"},
                     {},
                     {},
                     0.0,
                     false};
    std::vector<double> embree_s;
    std::vector<double> ratios;
    std::size_t hits = 0;
    for (int round = 0; round < kRuns; ++round) {
        bench::run(ours, true);
        if (ours.failed) {
            std::fprintf(stderr, "%s: could not be sliced\n", path.c_str());
            return false;
        }
        hits = run_embree(model, rays, device, embree_s);
        ratios.push_back(ours.cpu_s.back() / embree_s.back());
    }
    const double ratio = bench::median(ratios);
    std::printf(
        "%-24s %7zu triangles, %4.1f %% of the samples meet it: command %4.0f ms, Embree %4.0f ms, "
        "ratio %.2f (%.2f to %.2f; wanted at most %.2f): %s\n",
        std::filesystem::path(path).filename().c_str(), mesh->triangles.size(),
        100.0 * static_cast<double>(hits) / static_cast<double>(rays.heights.size() * rays.angles_rad.size()),
        1e3 * bench::median(ours.cpu_s), 1e3 * bench::median(embree_s), ratio,
        *std::min_element(ratios.begin(), ratios.end()), *std::max_element(ratios.begin(), ratios.end()),
        kMostOfEmbree, ratio <= kMostOfEmbree ? "ok" : "TOO SLOW");
    std::fflush(stdout);
    return ratio <= kMostOfEmbree;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    int points = kUsualPoints;
    if (words.size() > 2 && words[0] == "--points") {
        points = std::max(2, std::atoi(words[1].c_str()));
        words.erase(words.begin(), words.begin() + 2);
    }
    if (words.size() < 2) {
        std::fprintf(stderr, "usage: bench_command_vs_embree [--points N] PSICARVE MESH...\n");
        return 2;
    }
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("psicarve-bench-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    RTCDevice device = rtcNewDevice("threads=1");
    bool is_fast = true;
    for (std::size_t i = 1; i < words.size(); ++i)
        is_fast = compare(words[0], words[i], folder, points, device) && is_fast;
    rtcReleaseDevice(device);
    std::filesystem::remove_all(folder);
    return is_fast ? 0 : 1;
}
