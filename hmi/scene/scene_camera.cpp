// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/scene_camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace psicarve::session {
namespace {

using Vec = std::array<double, 3>;

constexpr double kMargin = 0.86;  // of the picture is used

}  // namespace

SceneCamera::SceneCamera(const std::array<double, 3>& size, const SceneView& view, double width_px,
                         double height_px) {
    const double ca = std::cos(view.azimuth_rad);
    const double sa = std::sin(view.azimuth_rad);
    const double ce = std::cos(view.elevation_rad);
    const double se = std::sin(view.elevation_rad);
    right_ = {-sa, ca, 0.0};
    up_ = {-ca * se, -sa * se, ce};
    towards_ = {ca * ce, sa * ce, se};
    const auto upright = slice::placed(view.up, size);
    const double across = std::hypot(upright[0], upright[1]);
    const double high = std::fabs(upright[2] * ce) + across * std::fabs(se);
    const double fit = std::min(width_px / std::max(across, 1e-9), height_px / std::max(high, 1e-9));
    scale_ = kMargin * fit * view.zoom;
    x0_ = width_px / 2.0 + view.pan_x * height_px;
    y0_ = height_px / 2.0 + view.pan_y * height_px;
}

Vec SceneCamera::project(const Vec& p) const noexcept {
    return {x0_ + scale_ * dot(p, right_), y0_ - scale_ * dot(p, up_), scale_ * dot(p, towards_)};
}

Vec SceneMatrix::project(const std::array<float, 3>& point) const noexcept {
    Vec result = origin;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t k = 0; k < 3; ++k) result[k] += static_cast<double>(point[axis]) * columns[axis][k];
    }
    return result;
}

SceneMatrix scene_matrix(const SceneCamera& camera, slice::Up up, const ScenePlace& place) noexcept {
    const double c = std::cos(place.turn_rad);
    const double s = std::sin(place.turn_rad);
    const auto seen = [&](const Vec& file_point) {
        Vec p = slice::placed(up, file_point);
        for (std::size_t k = 0; k < 3; ++k) p[k] += place.shift[k];
        return camera.project({c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]});
    };
    SceneMatrix matrix;
    matrix.origin = seen({0.0, 0.0, 0.0});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vec unit{};
        unit[axis] = 1.0;
        const Vec end = seen(unit);
        for (std::size_t k = 0; k < 3; ++k) matrix.columns[axis][k] = end[k] - matrix.origin[k];
    }
    return matrix;
}

}  // namespace psicarve::session
