// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/units.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::flat {

class FlatTest : public ::testing::Test {
protected:
    std::string file(const std::string& name, const std::string& content) const {
        const std::string path = folder_.path(name);
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    model::Mesh loaded(const std::string& path, const FlatOptions& options = {}) const {
        auto mesh = load_model(path, options);
        EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().message);
        return mesh ? std::move(*mesh) : model::Mesh{};
    }
    model::Mesh svg(const std::string& inside, const FlatOptions& options = {}) const {
        return loaded(file("drawing.svg", picture(inside)), options);
    }
    /// A picture whose user unit is a millimetre.
    static std::string picture(const std::string& inside) {
        return "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>" +
               inside + "</svg>";
    }
    std::string refusal(const std::string& path, const FlatOptions& options = {}) const {
        const auto mesh = load_model(path, options);
        EXPECT_FALSE(mesh.has_value());
        return mesh ? "" : mesh.error().message;
    }

private:
    test::TemporaryFolder folder_;
};

/// r(theta) of a body at half its height, about its own centre.
inline double radius(const model::Mesh& mesh, double angle_deg, double height_share = 0.5) {
    const auto& axis = mesh.axis_hint;
    const slice::Placement place{slice::Up::z, axis ? (*axis)[0] : 0.0, axis ? (*axis)[1] : 0.0};
    const double height = mesh.facts.min[2] + height_share * (mesh.facts.max[2] - mesh.facts.min[2]);
    const std::vector<double> heights{height};
    // Directions all round, as a job has them, one of them this one.
    const double positive_deg = std::fmod(angle_deg + 720.0, 360.0);
    const auto wanted = static_cast<std::size_t>(positive_deg / 45.0);
    std::vector<double> angles;
    for (std::size_t k = 0; k < 8; ++k) {
        angles.push_back(
            rad_from_deg(positive_deg + 45.0 * (static_cast<double>(k) - static_cast<double>(wanted))));
    }
    const auto map = slice::radial_map(mesh, place, heights, slice::Directions(angles), {1, {}});
    EXPECT_TRUE(map.has_value());
    return map ? map->radius[wanted] : -1.0;
}

inline constexpr double kExact_mm = 1e-5;              // what single precision holds at such sizes
inline constexpr double kCurve_mm = 2 * kFlatness_mm;  // straight pieces instead of a curve

}  // namespace psicarve::flat
