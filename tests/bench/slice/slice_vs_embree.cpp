// SPDX-License-Identifier: GPL-3.0-or-later
// 500 layers x 1000 directions of a deep-relief mesh: our slicer against Embree 3 (robust scene, one thread,
// scene build plus a first-hit ray from outside for each sample), in alternating runs of one process.
#include <embree3/rtcore.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/slicer.hpp"
#include "tests/bench/slice/embree_trace.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"

namespace {

using namespace psicarve;

constexpr std::size_t kLayers = 500;
constexpr std::size_t kDirections = 1000;
constexpr int kRuns = 5;

double run_embree(const model::Mesh& mesh, const bench::Rays& samples, RTCDevice device,
                  std::vector<double>& radius) {
    const double begin = bench::cpu_s();
    bench::trace_with_embree(mesh.triangles, samples, device, radius);
    return bench::cpu_s() - begin;
}

double run_ours(const model::Mesh& mesh, const bench::Rays& samples, std::vector<double>& radius) {
    const double begin = bench::cpu_s();
    const slice::Directions directions(samples.angles_rad);
    auto map = slice::radial_map(mesh, {}, samples.heights, directions, {});
    if (!map) {
        std::fprintf(stderr, "%s\n", map.error().message.c_str());
        std::exit(1);
    }
    radius.swap(map->radius);
    return bench::cpu_s() - begin;
}

/// Whether the slicer was fast enough.
bool compare(std::size_t triangle_count, double least_ratio, RTCDevice device) {
    const model::Mesh mesh = bench::relief_mesh(triangle_count);
    bench::Rays samples;
    samples.heights = slice::layer_heights(mesh.facts.min[2], mesh.facts.max[2] - mesh.facts.min[2], kLayers);
    for (std::size_t k = 0; k < kDirections; ++k) {
        samples.angles_rad.push_back(2.0 * kPi * static_cast<double>(k) / kDirections);
    }
    std::vector<double> theirs(kLayers * kDirections);
    std::vector<double> ours;
    std::vector<double> embree_s;
    std::vector<double> ours_s;
    for (int run = 0; run < kRuns; ++run) {
        ours_s.push_back(run_ours(mesh, samples, ours));
        embree_s.push_back(run_embree(mesh, samples, device, theirs));
    }
    std::size_t agree = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) agree += std::abs(ours[i] - theirs[i]) < 0.001 ? 1 : 0;
    const double ratio = bench::median(embree_s) / bench::median(ours_s);
    std::printf(
        "triangles %zu: slicer %.1f ms, Embree %.1f ms (build + trace), ratio %.2f (wanted %.0f): %s\n",
        mesh.triangles.size(), 1e3 * bench::median(ours_s), 1e3 * bench::median(embree_s), ratio, least_ratio,
        ratio >= least_ratio ? "ok" : "TOO SLOW");
    std::printf("  the two agree within 0.001 mm in %.3f %% of %zu samples\n",
                100.0 * static_cast<double>(agree) / static_cast<double>(ours.size()), ours.size());
    std::fflush(stdout);
    return ratio >= least_ratio;
}

}  // namespace

int main() {
    RTCDevice device = rtcNewDevice("threads=1");
    const bool is_small_fast = compare(100'000, 2.0, device);
    const bool is_large_fast = compare(1'000'000, 6.0, device);
    rtcReleaseDevice(device);
    return is_small_fast && is_large_fast ? 0 : 1;
}
