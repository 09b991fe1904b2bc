// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/flat/load_model.hpp"

namespace psicarve::flat {
namespace {

using Json = nlohmann::json;

void read(const Json& json, const char* key, double& target) {
    const auto value = json.find(key);
    if (value != json.end() && value->is_number()) target = value->get<double>();
}

void read(const Json& json, const char* key, std::optional<double>& target) {
    const auto value = json.find(key);
    if (value != json.end() && value->is_number()) target = value->get<double>();
}

void read(const Json& json, const char* key, bool& target) {
    const auto value = json.find(key);
    if (value != json.end() && value->is_boolean()) target = value->get<bool>();
}

Engraving engraving_of(const Json& json) {
    Engraving engraving;
    read(json, "depth_mm", engraving.depth_mm);
    read(json, "start_deg", engraving.start_deg);
    read(json, "stroke_width", engraving.follows_strokes);
    read(json, "diameter_mm", engraving.tool.diameter_mm);
    read(json, "angle_deg", engraving.tool.angle_deg);
    const auto shape = json.find("tool");
    if (shape != json.end() && shape->is_string())
        engraving.tool.shape = tool_shape_from_name(shape->get<std::string>()).value_or(ToolShape::point);
    return engraving;
}

}  // namespace

std::string flat_options_json(const FlatOptions& options) {
    Json json{{"scale", options.scale},
              {"depth_mm", options.depth_mm},
              {"white_depth_mm", options.white_depth_mm},
              {"gamma", options.gamma},
              {"smooth_mm", options.smooth_mm},
              {"invert", options.is_inverted},
              {"full_turn", options.is_full_turn},
              {"blend_seam", options.blends_seam}};
    if (options.engraving) {
        const Engraving& engraving = *options.engraving;
        json["engrave"] = {{"depth_mm", engraving.depth_mm},
                           {"start_deg", engraving.start_deg},
                           {"stroke_width", engraving.follows_strokes},
                           {"tool", name_of(engraving.tool.shape)},
                           {"diameter_mm", engraving.tool.diameter_mm},
                           {"angle_deg", engraving.tool.angle_deg}};
    }
    if (options.height_mm) json["height_mm"] = *options.height_mm;
    if (options.diameter_mm) json["diameter_mm"] = *options.diameter_mm;
    return json.dump();
}

FlatOptions flat_options_from_json(const std::string& text) {
    FlatOptions options;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return options;
    read(json, "height_mm", options.height_mm);
    read(json, "scale", options.scale);
    read(json, "diameter_mm", options.diameter_mm);
    read(json, "depth_mm", options.depth_mm);
    read(json, "white_depth_mm", options.white_depth_mm);
    read(json, "gamma", options.gamma);
    read(json, "smooth_mm", options.smooth_mm);
    read(json, "invert", options.is_inverted);
    read(json, "full_turn", options.is_full_turn);
    read(json, "blend_seam", options.blends_seam);
    const auto engraving = json.find("engrave");
    if (engraving != json.end() && engraving->is_object()) options.engraving = engraving_of(*engraving);
    return options;
}

}  // namespace psicarve::flat
