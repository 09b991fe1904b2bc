// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/opened_file.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "hmi/cam/table_job.hpp"
#include "hmi/session/job_making.hpp"

namespace psicarve::session {
namespace {

using OpenedMesh = std::shared_ptr<const model::Mesh>;

/// The same one where nothing is turned.
OpenedMesh turned_mesh(const OpenedMesh& mesh, const model::MeshTurn& turn) {
    return turn.any() ? std::make_shared<const model::Mesh>(model::turned(*mesh, turn)) : mesh;
}

/// Lines are cut with the machine's tool into its blank, if its profile has them.
flat::FlatOptions engraved_on(const Profile& machine) {
    flat::FlatOptions options;
    options.engraving.emplace();
    options.engraving->tool = machine.tool;
    if (machine.blank.radius_mm > 0.0) options.diameter_mm = 2.0 * machine.blank.radius_mm;
    return options;
}

}  // namespace

bool TableWay::is_as(const TableWay& other) const {
    return profile.tool == other.profile.tool && profile.blank == other.profile.blank &&
           profile.roughing == other.profile.roughing && joining == other.joining;
}

Result<std::shared_ptr<const cam::PreparedJob>> job_of_table(const std::string& path, const TableWay& way) {
    auto built = cam::job_from_table(path, way.profile, way.joining);
    if (!built) return built.error();
    return prepared(std::move(*built), way.profile, path);
}

OpenedFile read_opened(const std::string& path, const Profile& machine,
                       const std::optional<flat::FlatOptions>& shape, const model::MeshTurn& turn,
                       const TableWay& way) {
    const bool is_job = is_snapshot_file(path);
    if (!is_job && !cam::is_table_file(path)) {
        OpenedFile opened = read_opened_model(path, shape.value_or(flat::FlatOptions{}), turn);
        if (shape || !opened.error || !flat::has_only_open_lines(path)) return opened;
        opened = read_opened_model(path, engraved_on(machine), turn);
        opened.is_line_art = true;
        return opened;
    }
    OpenedFile opened;
    const auto job = is_job ? read_job(path) : job_of_table(path, way);
    opened.is_table = !is_job;
    if (job) opened.job = *job;
    if (!job) opened.error = job.error();
    return opened;
}

OpenedFile read_opened_model(const std::string& path, const flat::FlatOptions& options,
                             const model::MeshTurn& turn) {
    OpenedFile opened;
    opened.kind = flat::kind_of_model(path);
    opened.shape = options;
    auto mesh = flat::load_model(path, options);
    if (!mesh) {
        opened.error = mesh.error();
        return opened;
    }
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(path, unknown);
    if (!unknown) opened.mesh_bytes = bytes;
    opened.file_mesh = std::make_shared<const model::Mesh>(std::move(*mesh));
    opened.mesh = turned_mesh(opened.file_mesh, turn);
    opened.scene = std::make_shared<const MeshScene>(make_mesh_scene(*opened.mesh));
    return opened;
}

OpenedFile turned_again(const std::shared_ptr<const model::Mesh>& file_mesh, const model::MeshTurn& turn) {
    OpenedFile opened;
    opened.file_mesh = file_mesh;
    opened.mesh = turned_mesh(file_mesh, turn);
    opened.scene = std::make_shared<const MeshScene>(make_mesh_scene(*opened.mesh));
    return opened;
}

}  // namespace psicarve::session
