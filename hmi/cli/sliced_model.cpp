// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/sliced_model.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/cam/table_job.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/model/turned_mesh.hpp"

namespace psicarve::cli {
namespace {

model::MeshTurn turn_of(const nlohmann::json& report) {
    model::MeshTurn turn;
    const auto said = report.find("turn");
    if (!report.is_object() || said == report.end() || !said->is_object()) return turn;
    const auto rotate = said->find("rotate_deg");
    for (std::size_t axis = 0; rotate != said->end() && rotate->is_array() && axis < 3; ++axis) {
        if (axis < rotate->size() && (*rotate)[axis].is_number())
            turn.rotate_deg[axis] = (*rotate)[axis].get<double>();
    }
    const auto mirror = said->find("mirror");
    if (mirror != said->end() && mirror->is_string())
        turn.mirror = *mirror == "x" ? 0U : *mirror == "y" ? 1U : 2U;
    return turn;
}

}  // namespace

Result<std::shared_ptr<const model::Mesh>> model_of_job(const std::string& path, const PreparedJob& job) {
    if (path.empty()) return std::shared_ptr<const model::Mesh>{};
    if (cam::is_table_file(path))
        return Error{ErrorCode::bad_usage, "--model " + path + ": a table has no model to compare with"};
    const auto report = nlohmann::json::parse(job.view.report_json(), nullptr, false);
    const bool has_body = report.is_object() && report.contains("body");
    auto mesh = flat::load_model(path, flat::flat_options_from_json(has_body ? report["body"].dump() : ""));
    if (!mesh) return mesh.error();
    return std::make_shared<const model::Mesh>(model::turned(std::move(mesh).value(), turn_of(report)));
}

}  // namespace psicarve::cli
