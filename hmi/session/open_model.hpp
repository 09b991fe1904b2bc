// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "hmi/flat/load_model.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "hmi/session/opened_file.hpp"

namespace psicarve::session {

/// The model that is open: its mesh as in the file and as turned, how it is drawn, and the body and the turn
/// that the form asks for. What is asked for while a task is under way waits in `wished_shape` and
/// `wishes_turn` until it is done.
struct OpenModel {
    std::shared_ptr<const model::Mesh> mesh;
    std::shared_ptr<const model::Mesh> file_mesh;  ///< before it was turned
    std::shared_ptr<const MeshScene> scene;        ///< the mesh as drawn
    flat::ModelKind kind = flat::ModelKind::mesh;  ///< of the file that the mesh was made of
    std::uint64_t bytes = 0;                       ///< of its file; 0: not known
    model::MeshTurn turn;
    bool wishes_turn = false;
    flat::FlatOptions shape;
    std::optional<flat::FlatOptions> wished_shape;

    /// Another body of the same file, or none: never one that was not asked for.
    void take_body(OpenedFile& opened) {
        mesh = std::move(opened.mesh);
        file_mesh = std::move(opened.file_mesh);
        scene = std::move(opened.scene);
    }
    /// What a file held. Another file than the one that was open begins unturned.
    void take_file(OpenedFile& opened, bool is_other) {
        take_body(opened);
        kind = opened.kind;
        bytes = opened.mesh_bytes;
        shape = opened.shape;
        wished_shape.reset();
        if (!is_other) return;
        turn = {};
        wishes_turn = false;
    }
};

}  // namespace psicarve::session
