// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/turned_mesh.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "hmi/session/file_watch.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// What turns a table into a job: the machine with the tool, the blank and the roughing that are wanted.
struct TableWay {
    Profile profile;
    std::optional<Joining> joining;  ///< nothing: the profile's
    /// Whether the other would make the same job on the same machine.
    bool is_as(const TableWay& other) const;
};

/// A mesh, a job or an error.
struct OpenedFile {
    std::shared_ptr<const model::Mesh> mesh;
    std::shared_ptr<const model::Mesh> file_mesh;  ///< before it was turned
    flat::ModelKind kind = flat::ModelKind::mesh;
    flat::FlatOptions shape;
    bool is_line_art = false;  ///< only open lines: they are engraved, since nothing else can be made of them
    std::shared_ptr<const MeshScene> scene;
    std::uint64_t mesh_bytes = 0;
    std::shared_ptr<const cam::PreparedJob> job;
    bool is_table = false;                  ///< the job was made of a table
    std::optional<FileWatch::Stamp> stamp;  ///< of the file, before it was read
    std::optional<Error> error;
};

/// Reads a model, a job, a snapshot or a table, which becomes a job in this way. Without a shape a drawing of
/// open lines alone is engraved with the machine's tool.
OpenedFile read_opened(const std::string& path, const Profile& machine,
                       const std::optional<flat::FlatOptions>& shape, const model::MeshTurn& turn,
                       const TableWay& way);
/// Makes a job of a table as `psicarve slice` does.
Result<std::shared_ptr<const cam::PreparedJob>> job_of_table(const std::string& path, const TableWay& way);
/// Reads a model as this body.
OpenedFile read_opened_model(const std::string& path, const flat::FlatOptions& options,
                             const model::MeshTurn& turn);
/// The same model, turned otherwise.
OpenedFile turned_again(const std::shared_ptr<const model::Mesh>& file_mesh, const model::MeshTurn& turn);

}  // namespace psicarve::session
