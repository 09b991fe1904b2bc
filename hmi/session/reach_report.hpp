// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "hmi/scene/scene_camera.hpp"
#include "hmi/slice/slicer.hpp"

namespace psicarve::session {

/// The parts of a placed model that the heads can and cannot reach. Lengths in file units, places in the
/// turned model relative to the middle of its box.
struct ReachReport {
    std::vector<std::uint8_t> is_hidden;  ///< by vertex of the scene: behind another wall, seen from outside
    double undercut_share = 0.0;          ///< share of the surface, as the slicer counts it
    std::array<double, 2> axis{};
    double blank_radius = 0.0;  ///< the least round blank that holds the model
    double mm_per_unit = 1.0;
    std::array<double, 3> size{};   ///< of the turned model's box
    std::vector<double> outermost;  ///< by direction, once round from 0 on: the largest radius of all heights
};

/// Slices coarsely and compares. Uses of the options: up, axis_at, height or scale, search_progress.
Result<ReachReport> look_at_model(const model::Mesh& mesh, const MeshScene& scene, const Profile& profile,
                                  const cam::JobOptions& options);

/// The slicer's future warnings about the profile's blank.
std::vector<std::string> blank_warnings(const ReachReport& reach, const Profile& profile);

/// A cylinder to be drawn round the model. File units, relative to the middle of the model's box.
struct BlankOutline {
    std::array<double, 2> centre{};
    double radius = 0.0;
    double low = 0.0;
    double high = 0.0;
    double diameter_mm = 0.0;
    bool is_chosen = false;  ///< else the least that holds the model

    bool operator==(const BlankOutline&) const = default;
};
/// The profile's blank at its place, as high as the model where its height is not known; without one the
/// least that holds the model.
BlankOutline blank_outline(const ReachReport& reach, const Profile& profile);

/// The scene with hidden vertices in a colour of their own.
MeshScene painted_scene(const MeshScene& scene, const ReachReport& reach, std::uint32_t rgb,
                        std::uint32_t hidden_rgb);

/// The direction from which most hidden parts are visible: the view looks past the wall before them. Nothing
/// when nothing is hidden.
std::optional<SceneView> view_of_hidden(const MeshScene& scene, const ReachReport& reach, slice::Up up);

}  // namespace psicarve::session
