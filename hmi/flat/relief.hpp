// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hmi/flat/grey_image.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// Depths below a cylinder's surface over a rectangle of it, row by row from the top. A sample stands in the
/// middle of its cell: over a full turn the last sample is followed by the first.
struct DepthMap {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<float> depth_mm;
    double radius_mm = 0.0;  ///< of the cylinder
    double height_mm = 0.0;
    double share_of_turn = 1.0;  ///< how far round it goes, from direction 0 on
    double rest_depth_mm = 0.0;  ///< depth beside the rectangle, when it does not go all round
    std::vector<std::string> warnings;

    float& at(std::size_t x, std::size_t y) { return depth_mm[y * width + x]; }
    float at(std::size_t x, std::size_t y) const { return depth_mm[y * width + x]; }
};

/// Makes depths of a picture: averages it to the resolution that can be carved, inverts it, applies gamma and
/// the depths of black and white, smooths it, and blends its seam or warns of it.
Result<DepthMap> depths_of(const GreyImage& image, const FlatOptions& options, const std::string& file);

/// The body: rows of points at the samples' heights, as many columns as keep it round, both ends closed.
Result<model::Mesh> body_of(const DepthMap& map, const std::string& format, const std::string& file);

}  // namespace psicarve::flat
