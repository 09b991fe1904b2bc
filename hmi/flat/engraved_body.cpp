// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/engraved_body.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "hmi/flat/relief.hpp"
#include "hmi/flat/stroke_index.hpp"

namespace psicarve::flat {
namespace {

// To look at, and for the expected piece to be compared with: 300 000 facets.
constexpr double kMostGrooveSamples = 150'000.0;
constexpr double kFinestSample_mm = 0.05;

}  // namespace

Result<model::Mesh> engraved_body(std::shared_ptr<const Grooves> grooves, const std::string& format,
                                  const std::string& file) {
    const StrokeIndex index(*grooves, grooves->wall_mm());
    const double round_mm = grooves->round_mm();
    const double cell_mm =
        std::max(kFinestSample_mm, std::sqrt(round_mm * grooves->height_mm / kMostGrooveSamples));
    DepthMap map;
    map.width = static_cast<std::size_t>(std::max(8.0, std::ceil(round_mm / cell_mm)));
    map.height = static_cast<std::size_t>(std::max(1.0, std::ceil(grooves->height_mm / cell_mm)));
    map.radius_mm = grooves->radius_mm;
    map.height_mm = grooves->height_mm;
    map.depth_mm.resize(map.width * map.height);
    map.warnings = grooves->warnings;
    for (std::size_t y = 0; y < map.height; ++y) {
        const double height_mm =
            map.height_mm * (1.0 - (static_cast<double>(y) + 0.5) / static_cast<double>(map.height));
        for (std::size_t x = 0; x < map.width; ++x) {
            const double along_mm =
                round_mm * (static_cast<double>(x) + 0.5) / static_cast<double>(map.width);
            const double beside_mm = index.beside_floor_mm(along_mm, height_mm);
            map.at(x, y) = static_cast<float>(grooves->depth_beside_mm(beside_mm));
        }
    }
    auto mesh = body_of(map, format, file);
    if (mesh) mesh->grooves = std::move(grooves);
    return mesh;
}

}  // namespace psicarve::flat
