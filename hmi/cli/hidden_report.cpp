// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/hidden_report.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "shared/units.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;
using Spans = std::vector<report::Span>;

constexpr std::size_t kMostInALine = 2;

/// The largest shares, "40-70 deg (12 %), 200-210 deg (5 %), ...".
std::string worst_text(const Spans& spans, const char* pattern, const char* unit) {
    std::string text;
    for (const report::Span& span : report::worst_of(spans, kMostInALine)) {
        std::array<char, 96> one{};
        std::snprintf(one.data(), one.size(), pattern, span.from, span.to, unit, 100.0 * span.share);
        text += (text.empty() ? "" : ", ") + std::string(one.data());
    }
    return text + (spans.size() > kMostInALine ? ", ..." : "");
}

Json spans_json(const Spans& spans, const char* from, const char* to) {
    Json all = Json::array();
    for (const report::Span& span : spans)
        all.push_back({{from, span.from}, {to, span.to}, {"share", span.share}});
    return all;
}

constexpr const char* kDegrees = "%.0f-%.0f %s (%.1f %%)";
constexpr const char* kHeights = "%.1f-%.1f %s (%.1f %%)";

}  // namespace

std::vector<std::string> hidden_lines(const report::HiddenPlaces& places) {
    std::vector<std::string> lines;
    if (!places.hidden_deg.empty())
        lines.push_back("           most in " + worst_text(places.hidden_deg, kDegrees, "deg"));
    if (!places.hidden_mm.empty())
        lines.push_back("           and at " + worst_text(places.hidden_mm, kHeights, "mm"));
    return lines;
}

std::vector<std::string> open_lines(const report::HiddenPlaces& places) {
    if (places.open_deg.empty()) return {};
    return {"           most in " + worst_text(places.open_deg, kDegrees, "deg")};
}

std::string hidden_json(const report::HiddenPlaces& places) {
    const auto& counts = places.parts.sectors;
    const double step_deg = kDegPerRev / static_cast<double>(counts.size());
    Json sectors = Json::array();
    for (std::size_t k = 0; k < counts.size(); ++k) {
        sectors.push_back({{"from_deg", step_deg * static_cast<double>(k)},
                           {"hidden_share", counts[k].hidden_share()},
                           {"open_share", counts[k].open_share()}});
    }
    const Json object{{"directions", spans_json(places.hidden_deg, "from_deg", "to_deg")},
                      {"heights", spans_json(places.hidden_mm, "from_mm", "to_mm")},
                      {"open_directions", spans_json(places.open_deg, "from_deg", "to_deg")},
                      {"open_heights", spans_json(places.open_mm, "from_mm", "to_mm")},
                      {"by_direction", sectors}};
    return object.dump();
}

}  // namespace psicarve::cli
