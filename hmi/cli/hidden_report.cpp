// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/hidden_report.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "shared/base/units.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;
using Spans = std::vector<report::Span>;

constexpr std::size_t kMostInALine = 2;

std::string degrees_text(const report::Span& span) {
    std::array<char, 96> text{};
    const report::Directions told = report::directions_of(span);
    std::snprintf(text.data(), text.size(), "%.0f-%.0f deg%s (%.1f %%)", told.from_deg, told.to_deg,
                  told.passes_zero ? ", through 0" : "", 100.0 * span.share);
    return text.data();
}

std::string heights_of_span(const report::Span& span) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.1f-%.1f mm (%.1f %%)", span.from, span.to, 100.0 * span.share);
    return text.data();
}

/// The largest shares, "40-70 deg (12 %), 350-10 deg, through 0 (5 %), ...".
std::string worst_text(const Spans& spans, std::string (*span_text)(const report::Span&)) {
    std::string text;
    for (const report::Span& span : report::worst_of(spans, kMostInALine)) {
        text += (text.empty() ? "" : ", ") + span_text(span);
    }
    return text + (spans.size() > kMostInALine ? ", ..." : "");
}

Json spans_json(const Spans& spans, const char* from, const char* to) {
    Json all = Json::array();
    for (const report::Span& span : spans)
        all.push_back({{from, span.from}, {to, span.to}, {"share", span.share}});
    return all;
}

}  // namespace

std::vector<std::string> hidden_lines(const report::HiddenPlaces& places) {
    std::vector<std::string> lines;
    if (!places.hidden_deg.empty())
        lines.push_back("           most in " + worst_text(places.hidden_deg, degrees_text));
    if (!places.hidden_mm.empty())
        lines.push_back("           and at " + worst_text(places.hidden_mm, heights_of_span));
    return lines;
}

std::vector<std::string> open_lines(const report::HiddenPlaces& places) {
    if (places.open_deg.empty()) return {};
    return {"           most in " + worst_text(places.open_deg, degrees_text)};
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
