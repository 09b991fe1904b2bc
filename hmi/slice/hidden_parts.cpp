// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/hidden_parts.hpp"

#include <cstddef>
#include <mutex>

#include "hmi/slice/directions.hpp"
#include "shared/base/units.hpp"

namespace psicarve::slice {
namespace {

constexpr std::size_t kSectors = 36;
constexpr std::size_t kRaysOfSector = 10;

void add(WallCount& to, const WallCount& more) {
    to.walls += more.walls;
    to.hidden += more.hidden;
    to.rays += more.rays;
    to.open += more.open;
}

}  // namespace

std::vector<HiddenParts::Run> HiddenParts::runs(const std::vector<WallCount>& counts, Share share,
                                                double least, bool is_round) {
    std::vector<Run> found;
    const std::size_t count = counts.size();
    const auto is_in = [&](std::size_t i) { return (counts[i % count].*share)() > least; };
    std::size_t first = 0;  // of a turn: where no run goes on from before
    while (is_round && first < count && is_in(first)) ++first;
    if (first == count) first = 0;
    for (std::size_t i = first; i < first + count;) {
        if (!is_in(i)) {
            ++i;
            continue;
        }
        WallCount all;
        const std::size_t begin = i;
        for (; i < first + count && is_in(i); ++i) add(all, counts[i % count]);
        found.push_back({begin, i, (all.*share)()});
    }
    return found;
}

Result<HiddenParts> hidden_parts(const model::Mesh& mesh, const Placement& placement,
                                 const std::vector<double>& heights, const SliceOptions& options) {
    constexpr std::size_t kRays = kSectors * kRaysOfSector;
    std::vector<double> angles_rad;
    for (std::size_t k = 0; k < kRays; ++k)
        angles_rad.push_back(2.0 * kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(kRays));
    HiddenParts parts;
    parts.sectors.resize(kSectors);
    parts.layers.resize(heights.size());
    std::mutex mutex;
    const auto note = [&](const LayerSection& section) {
        const std::scoped_lock lock(mutex);
        for (std::size_t k = 0; k < kRays; ++k) {
            const std::uint32_t walls = section.walls[k];
            const bool is_open = (walls % 2 != 0) != section.totals->is_odd;
            const WallCount ray{walls, walls > 1 ? walls - 1U : 0U, 1, is_open ? 1U : 0U};
            add(parts.sectors[k / kRaysOfSector], ray);
            add(parts.layers[section.layer], ray);
        }
    };
    const auto done = slice_layers(mesh, placement, heights, Directions(angles_rad), note, options);
    if (!done) return done.error();
    return parts;
}

}  // namespace psicarve::slice
