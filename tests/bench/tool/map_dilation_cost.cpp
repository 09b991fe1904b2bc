// SPDX-License-Identifier: GPL-3.0-or-later
// The dilation of 2 000 x 3 600 samples of a body of deep relief, 200 mm high and 100 mm across, by tools
// of 6 mm: time and memory on two threads, and as a share of what the definition takes, sample by sample,
// measured on some places; and how far off it stands there.
//   bench_map_dilation
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "hmi/tool/map_dilation.hpp"
#include "shared/base/units.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"

namespace {

using namespace psicarve;

constexpr std::size_t kRows = 2000;
constexpr std::size_t kColumns = 3600;
constexpr double kPitch_mm = 0.1;
constexpr double kScale = 2.0;
constexpr std::size_t kSamples = 100;

/// The definition, over all samples that the tool can reach by the smallest radius of all.
double plain_tip(const tool::SampledRadii& map, const tool::Tool& tool, std::size_t place) {
    static const float least = *std::min_element(map.radius.begin(), map.radius.end());
    const auto columns = static_cast<std::int64_t>(map.column_count);
    const auto reach = static_cast<std::int64_t>(std::asin(std::min(1.0, tool.radius / double{least})) /
                                                 (2.0 * kPi) * static_cast<double>(columns));
    const auto within = static_cast<std::size_t>(tool.radius / map.row_pitch) + 1;
    const std::size_t middle = place / map.column_count;
    const std::size_t end = std::min(map.row_count, middle + within + 1);
    double most = 0.0;
    for (std::size_t row = middle > within ? middle - within : 0; row < end; ++row) {
        const double up = (static_cast<double>(row) - static_cast<double>(middle)) * map.row_pitch;
        for (std::int64_t aside = -reach; aside <= reach; ++aside) {
            const double turn = 2.0 * kPi * static_cast<double>(aside) / static_cast<double>(columns);
            const auto column = (static_cast<std::int64_t>(place) + aside + columns) % columns;
            const double r = map.radius[row * map.column_count + static_cast<std::size_t>(column)];
            const double s = std::hypot(r * std::sin(turn), up);
            if (std::cos(turn) > 0.0 && s <= tool.radius)
                most = std::max(most, r * std::cos(turn) - tool::rise(tool, s));
        }
    }
    return most;
}

double wall_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void measure(const tool::SampledRadii& map, const char* name, const tool::Tool& tool) {
    const double begin_s = wall_s();
    const double cpu_begin_s = bench::cpu_s();
    const auto tips = tool::dilated(map, tool, 0.0, {2, {}});
    const double cpu_s = bench::cpu_s() - cpu_begin_s;
    const double took_s = wall_s() - begin_s;
    if (!tips) return;
    double worst_mm = 0.0;
    double least_mm = 1e9;
    double sum_mm = 0.0;
    const double plain_begin_s = bench::cpu_s();
    for (std::size_t i = 0; i < kSamples; ++i) {
        const std::size_t place = (i * 7919 * 7907) % tips->size();
        const double more_mm = static_cast<double>((*tips)[place]) - plain_tip(map, tool, place);
        worst_mm = std::max(worst_mm, more_mm);
        least_mm = std::min(least_mm, more_mm);
        sum_mm += more_mm;
    }
    const double places = static_cast<double>(tips->size());
    const double plain_s = (bench::cpu_s() - plain_begin_s) * places / static_cast<double>(kSamples);
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    std::printf(
        "%-12s %.2f s, %.2f s of processor time, peak %.0f MB; plainly %.0f s, %.0f times "
        "as long;\n             off by %.7f mm on average, %.7f to %.7f mm\n",
        name, took_s, cpu_s, static_cast<double>(usage.ru_maxrss) / 1024.0, plain_s, plain_s / cpu_s,
        sum_mm / static_cast<double>(kSamples), least_mm, worst_mm);
}

}  // namespace

int main() {
    std::vector<float> radii;
    for (std::size_t row = 0; row < kRows; ++row) {
        for (std::size_t column = 0; column < kColumns; ++column)
            radii.push_back(static_cast<float>(
                kScale * bench::relief_radius_mm(
                             2.0 * kPi * static_cast<double>(column) / static_cast<double>(kColumns),
                             static_cast<double>(row) / static_cast<double>(kRows))));
    }
    const tool::SampledRadii map{kRows, kColumns, kPitch_mm, radii};
    measure(map, "ball 6 mm", {tool::Shape::ball, 3.0, 0.0});
    measure(map, "flat 6 mm", {tool::Shape::flat, 3.0, 0.0});
    measure(map, "vee 6 mm 60", {tool::Shape::vee, 3.0, 60.0});
    return 0;
}
