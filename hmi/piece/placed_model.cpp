// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/placed_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hmi/slice/directions.hpp"

namespace psicarve::piece {
namespace {

Error says_nothing(const JobView& job) {
    return bad_input("the job of " + std::string(job.source_name()) +
                     " does not say how its model stood; slice it again");
}

}  // namespace

Result<PlacedModel> place_as_sliced(std::shared_ptr<const model::Mesh> mesh, const JobView& job,
                                    const Profile& profile) {
    if (mesh->source_hash != job.source_hash()) {
        return bad_input(mesh->source_name + ": is not the file that the job was sliced from (" +
                         std::string(job.source_name()) + ")");
    }
    const auto report = nlohmann::json::parse(job.report_json(), nullptr, false);
    if (!report.is_object()) return says_nothing(job);
    const auto scale = report.find("scale");
    const auto axis = report.find("axis");
    if (scale == report.end() || !scale->is_number() || axis == report.end() || !axis->is_array() ||
        axis->size() != 2 || !(*axis)[0].is_number() || !(*axis)[1].is_number()) {
        return says_nothing(job);
    }
    PlacedModel model;
    const auto up = report.find("up");
    if (up != report.end() && *up == "x") model.placement.up = slice::Up::x;
    if (up != report.end() && *up == "y") model.placement.up = slice::Up::y;
    model.placement.axis_x = (*axis)[0].get<double>();
    model.placement.axis_y = (*axis)[1].get<double>();
    model.scale = scale->get<double>();
    if (!(model.scale > 0.0) || !std::isfinite(model.scale)) return says_nothing(job);
    model.base_mm = profile.job.base_height_mm;
    model.core_mm = profile.core_radius_mm;
    model.mesh = std::move(mesh);
    return model;
}

Result<std::vector<float>> wanted_radii(const PlacedModel& model, const StockMap& stock,
                                        const slice::SliceOptions& options) {
    const double lowest = slice::placed(model.placement.up, model.mesh->facts.min)[2];
    std::vector<double> heights;
    for (std::size_t row = 0; row < stock.row_count(); ++row)
        heights.push_back(lowest + (stock.height_mm(row) - model.base_mm) / model.scale);
    std::vector<double> directions;
    for (std::size_t column = 0; column < stock.column_count(); ++column)
        directions.push_back(stock.direction_rad(column));
    std::vector<float> wanted(heights.size() * directions.size());
    const auto store = [&](const slice::LayerSection& section) {
        float* out = wanted.data() + section.layer * directions.size();
        for (const double radius : section.radius)
            *out++ = static_cast<float>(std::max(model.core_mm, radius * model.scale));
    };
    const auto done = slice::slice_layers(*model.mesh, model.placement, heights,
                                          slice::Directions(directions), store, options);
    if (!done) return done.error();
    return wanted;
}

}  // namespace psicarve::piece
