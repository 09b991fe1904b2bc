// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "hmi/slice/placement.hpp"

namespace psicarve::session {

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The direction from which a scene is seen, in parallel projection.
struct SceneView {
    double azimuth_rad = 0.0;    ///< direction of the turned model that faces the viewer
    double elevation_rad = 0.0;  ///< above the horizon
    double zoom = 1.0;           ///< 1: the whole model fits
    double pan_x = 0.0;          ///< of the picture's height
    double pan_y = 0.0;
    slice::Up up = slice::Up::z;

    bool operator==(const SceneView&) const = default;
};

/// The place of a body in the scene: shifted, then turned about the vertical axis. Placed coordinates.
struct ScenePlace {
    std::array<double, 3> shift{};
    double turn_rad = 0.0;

    bool operator==(const ScenePlace&) const = default;
};

/// Projects a point of the scene into the picture: x to the right, y down [px]; z towards the viewer.
class SceneCamera {
public:
    /// `size`: of the scene's box, in the file's axes.
    SceneCamera(const std::array<double, 3>& size, const SceneView& view, double width_px, double height_px);

    /// Placed coordinates: z up, relative to the middle of the box.
    std::array<double, 3> project(const std::array<double, 3>& placed_point) const noexcept;
    double px_per_unit() const noexcept { return scale_; }
    /// The direction, in placed coordinates, that goes to the right in the picture.
    const std::array<double, 3>& right() const noexcept { return right_; }
    const std::array<double, 3>& up() const noexcept { return up_; }
    const std::array<double, 3>& towards() const noexcept { return towards_; }  ///< the viewer

private:
    std::array<double, 3> right_{};
    std::array<double, 3> up_{};
    std::array<double, 3> towards_{};
    double scale_ = 1.0;
    double x0_ = 0.0;
    double y0_ = 0.0;
};

/// Maps a body's own points (the file's axes) into the picture: origin + x * columns[0] + ...
struct SceneMatrix {
    std::array<double, 3> origin{};
    std::array<std::array<double, 3>, 3> columns{};

    std::array<double, 3> project(const std::array<float, 3>& point) const noexcept;
};
SceneMatrix scene_matrix(const SceneCamera& camera, slice::Up up, const ScenePlace& place) noexcept;

}  // namespace psicarve::session
