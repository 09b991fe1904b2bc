// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/session/mesh_scene.hpp"
#include "hmi/slice/slicer.hpp"

namespace psicarve::session {

/// What the heads can and cannot reach of a model as it is placed. Lengths in file units, places in the
/// turned model relative to the middle of its box.
struct ModelSight {
    std::vector<std::uint8_t> is_hidden;  ///< by vertex of the scene: behind another wall, seen from outside
    double undercut_share = 0.0;          ///< part of the surface, as the slicer counts it
    std::array<double, 2> axis{};
    double blank_radius = 0.0;  ///< the least round blank that holds the model
    double mm_per_unit = 1.0;
};

/// Slices coarsely and compares. Of the options: up, axis_at, height or scale, search_progress.
Result<ModelSight> look_at_model(const model::Mesh& mesh, const MeshScene& scene, const Profile& profile,
                                 const cam::JobOptions& options);

/// The scene with hidden vertices in a colour of their own.
MeshScene painted_scene(const MeshScene& scene, const ModelSight& sight, std::uint32_t rgb,
                        std::uint32_t hidden_rgb);

}  // namespace psicarve::session
