// SPDX-License-Identifier: GPL-3.0-or-later
// The exact offset of each tool at 500 x 1000 positions round a body of deep relief: processor time and
// memory on one thread, and as a share of what a search through all facets takes, measured on a sample of the
// positions.
//   bench_tool_offset [TRIANGLES]     default 100 000
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "hmi/slice/directions.hpp"
#include "hmi/tool/tool_offset.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"
#include "tests/hmi/tool/brute_force.hpp"

namespace {

using namespace psicarve;

constexpr std::size_t kRows = 500;
constexpr std::int64_t kPoints = 501;  // 1000 directions
constexpr std::size_t kSamples = 40;
constexpr double kHeight_mm = 60.0;

struct Named {
    const char* name;
    tool::Tool tool;
};

double peak_mb() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

int measure(const model::Mesh& mesh, const Named& named) {
    const std::vector<double> directions = slice::full_circle_rad(kPoints, 6400, 0.0);
    const std::vector<double> heights = slice::layer_heights(0.0, kHeight_mm, kRows);
    const double before_s = bench::cpu_s();
    const auto tips = tool::tip_radii(mesh, {}, named.tool, {directions, kRows, heights}, {1, {}});
    const double exact_s = bench::cpu_s() - before_s;
    if (!tips) return 1;
    const auto rise_of = [&named](double s) { return tool::rise(named.tool, s); };
    const brute::Shape<decltype(rise_of)> shape{named.tool.radius, rise_of};
    double worst_mm = 0.0;
    const double search_begin_s = bench::cpu_s();
    for (std::size_t i = 0; i < kSamples; ++i) {
        const std::size_t at = (i * 7919 * 64) % tips->size();
        const double found = brute::tip_radius(mesh, directions[at / kRows], heights[at % kRows], shape);
        worst_mm = std::max(worst_mm, std::abs(found - (*tips)[at]));
    }
    const double places = static_cast<double>(tips->size());
    const double search_s = (bench::cpu_s() - search_begin_s) * places / static_cast<double>(kSamples);
    std::printf(
        "%-12s %7zu triangles: %.2f s for %.0f positions (%.2f s per 100 000 triangles), peak %.0f MB;\n"
        "             search through all facets %.0f s, %.0f times as long; they differ by %.1e mm\n",
        named.name, mesh.triangles.size(), exact_s, places,
        exact_s * 1e5 / static_cast<double>(mesh.triangles.size()), peak_mb(), search_s, search_s / exact_s,
        worst_mm);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t triangles = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100'000;
    const model::Mesh mesh = bench::relief_mesh(triangles);
    int failures = 0;
    for (const Named& named : {Named{"ball 3 mm", {tool::Shape::ball, 1.5, 0.0}},
                               Named{"flat 3 mm", {tool::Shape::flat, 1.5, 0.0}},
                               Named{"vee 3 mm 60", {tool::Shape::vee, 1.5, 60.0}}}) {
        failures += measure(mesh, named);
    }
    return failures;
}
