// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/verify/piece_view.hpp"

namespace psicarve::session {

/// A mesh fit for drawing: with no more facets than a picture can show. File units and axes.
struct MeshScene {
    std::vector<std::array<float, 3>> vertices;  ///< relative to the middle of the bounding box
    std::vector<std::array<std::uint32_t, 3>> facets;
    std::vector<std::uint32_t> facet_rgb;  ///< a colour each, or none at all
    std::array<double, 3> size{};          ///< of the bounding box
    std::array<double, 3> middle{};        ///< of the bounding box in the file
};

/// Vertices that fall into one cell of a grid of `cells` along the longest side become one.
MeshScene make_mesh_scene(const model::Mesh& mesh, std::uint32_t cells = 200);

/// From where a model is seen, by parallel rays.
struct SceneView {
    double azimuth_rad = 0.0;    ///< direction of the turned model that faces the viewer
    double elevation_rad = 0.0;  ///< above the horizon
    double zoom = 1.0;           ///< 1: the whole model fits
    double pan_x = 0.0;          ///< of the picture's height
    double pan_y = 0.0;
    slice::Up up = slice::Up::z;
};

/// How the view turns a point of the scene into the picture: x to the right, y down [px]; z towards the
/// viewer.
class SceneCamera {
public:
    SceneCamera(const MeshScene& scene, const SceneView& view, double width_px, double height_px);

    /// Placed coordinates: z up, relative to the middle of the box.
    std::array<double, 3> project(const std::array<double, 3>& placed_point) const noexcept;
    double px_per_unit() const noexcept { return scale_; }

private:
    std::array<double, 3> right_{};
    std::array<double, 3> up_{};
    std::array<double, 3> towards_{};
    double scale_ = 1.0;
    double x0_ = 0.0;
    double y0_ = 0.0;
};

/// The model shaded in a colour (0xRRGGBB), or in those of its facets; transparent around it.
verify::PixelImage draw_mesh_scene(const MeshScene& scene, const SceneView& view, std::size_t width_px,
                                   std::size_t height_px, std::uint32_t rgb);

}  // namespace psicarve::session
