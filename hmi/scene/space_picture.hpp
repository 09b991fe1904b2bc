// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hmi/picture/piece_view.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "hmi/scene/scene_camera.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::session {

/// One solid of a picture.
struct SceneBody {
    std::shared_ptr<const MeshScene> scene;
    ScenePlace place;
    std::uint32_t rgb = 0xC2C8CE;  ///< where the scene has no colours of its own

    bool operator==(const SceneBody&) const = default;  // the same scene, not one like it
};

/// A straight line between two places of the scene (placed coordinates).
struct SceneLine {
    std::array<double, 3> from;
    std::array<double, 3> to;
    std::uint32_t rgb = 0;
};

/// The content of a view of the space.
struct SpacePicture {
    std::array<double, 3> size{};  ///< of the box that has to fit, in the file's axes
    SceneView view;
    std::vector<SceneBody> bodies;
    std::vector<SceneLine> lines;
    bool is_coarse = false;  ///< drawn with the coarse facets, to be quick
    /// Its scenes do not change once they are shown: another thread may draw them.
    bool is_lasting = false;
};

/// The number of facets that its bodies are drawn with.
std::size_t facet_count(const SpacePicture& picture) noexcept;
/// Whether both are seen from the same side, at the same size.
bool has_same_view(const SpacePicture& a, const SpacePicture& b) noexcept;
/// Whether both look the same but for their lines; only for scenes that last.
bool has_same_bodies(const SpacePicture& a, const SpacePicture& b) noexcept;

// The light of both renderers: from the upper left, in front; x right, y down, z towards the viewer.
inline constexpr std::array<double, 3> kLight{-0.40, -0.56, 0.725};
inline constexpr double kAmbient = 0.42;
inline constexpr double kDiffuse = 0.58;

/// Draws the bodies shaded, nearer ones over farther ones; transparent around them. No lines.
verify::PixelImage draw_bodies(const SpacePicture& picture, std::size_t width_px, std::size_t height_px);

/// Facets between rows of `round` vertices each that stand one above the other, with a lid whose middle is
/// the vertex behind the last row's; every `step`-th vertex and row, the last row and the seam always.
std::vector<Facet> lathe_facets(std::size_t round, std::size_t up, std::size_t step);

/// A head: its tip in the origin, its rod along +x (placed coordinates, so for up z), with its tool, in the
/// scene's units; for a point a needle.
MeshScene head_scene(double rod_length, double rod_radius, const tool::Tool& tool);

/// A circle that looks the same from any side, as lines.
std::vector<SceneLine> ring_outline(const SceneCamera& camera, const std::array<double, 3>& centre,
                                    double radius, std::uint32_t rgb);

/// The file's x, y and z in the view's direction, from a place of the picture.
std::array<SceneLine, 3> axis_triad(const SceneCamera& camera, slice::Up up, double x_px, double y_px,
                                    double length_px, std::uint32_t rgb);

/// The outline of an upright cylinder, for a view with `right` to the right: two dashed rims and two dashed
/// sides.
std::vector<SceneLine> cylinder_outline(const std::array<double, 2>& axis, double radius, double low,
                                        double high, const std::array<double, 3>& right, std::uint32_t rgb);

}  // namespace psicarve::session
