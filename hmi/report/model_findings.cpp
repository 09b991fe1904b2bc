// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/model_findings.hpp"

#include <algorithm>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::report {
namespace {

constexpr std::size_t kFindingsLayers = 200;
// A smaller share behind other walls needs no mention.
constexpr double kHiddenShare = 0.01;

using slice::HiddenParts;
using slice::WallCount;

std::vector<Span> spans_of(const std::vector<HiddenParts::Run>& runs, double start, double step) {
    std::vector<Span> spans;
    spans.reserve(runs.size());
    for (const HiddenParts::Run& run : runs) {
        spans.push_back({start + step * static_cast<double>(run.begin),
                         start + step * static_cast<double>(run.end), run.share});
    }
    return spans;
}

Result<HiddenPlaces> hidden_places(const piece::PlacedModel& model, const slice::SliceOptions& options) {
    const auto least = slice::placed(model.placement.up, model.mesh->facts.min);
    const auto most = slice::placed(model.placement.up, model.mesh->facts.max);
    const double height = most[2] - least[2];
    auto parts = slice::hidden_parts(*model.mesh, model.placement,
                                     slice::layer_heights(least[2], height, kFindingsLayers), options);
    if (!parts) return parts.error();
    HiddenPlaces places;
    places.parts = std::move(*parts);
    const double step_deg = kDegPerRev / static_cast<double>(places.parts.sectors.size());
    const double layer_mm = height * model.scale / static_cast<double>(kFindingsLayers);
    const auto round = [&](HiddenParts::Share share, double over) {
        return spans_of(HiddenParts::runs(places.parts.sectors, share, over, true), 0.0, step_deg);
    };
    const auto upright = [&](HiddenParts::Share share, double over) {
        return spans_of(HiddenParts::runs(places.parts.layers, share, over, false), model.base_mm, layer_mm);
    };
    places.hidden_deg = round(&WallCount::hidden_share, kHiddenShare);
    places.hidden_mm = upright(&WallCount::hidden_share, kHiddenShare);
    places.open_deg = round(&WallCount::open_share, 0.0);
    places.open_mm = upright(&WallCount::open_share, 0.0);
    return places;
}

}  // namespace

std::vector<FlawCount> flaws_of(const model::MeshFacts& facts, const model::MeshParts* parts) {
    std::vector<FlawCount> flaws;
    const auto add = [&flaws](MeshFlaw flaw, std::uint64_t count) {
        if (count > 0) flaws.push_back({flaw, count});
    };
    if (parts != nullptr) add(MeshFlaw::holes, parts->holes);
    if (parts == nullptr && !facts.closed) flaws.push_back({MeshFlaw::holes, 0});
    add(MeshFlaw::turned_edges, facts.turned_edge_count);
    if (parts != nullptr) add(MeshFlaw::inside_out, parts->inside_out);
    const bool is_inside_out = facts.closed && facts.same_orientation && facts.signed_volume < 0.0;
    if (parts == nullptr && is_inside_out) flaws.push_back({MeshFlaw::inside_out, 0});
    add(MeshFlaw::degenerate, facts.degenerate_count);
    add(MeshFlaw::duplicate, facts.duplicate_count);
    add(MeshFlaw::dropped, facts.dropped_count);
    return flaws;
}

const char* probable_unit(const model::MeshFacts& facts) noexcept {
    double largest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, facts.max[k] - facts.min[k]);
    if (largest < 0.5) return "m";
    if (largest < 3.0) return "inch";
    return largest > 5000.0 ? "um" : "mm";
}

Directions directions_of(const Span& span_deg) noexcept {
    const bool passes_zero = span_deg.to > kDegPerRev;
    return {span_deg.from, passes_zero ? span_deg.to - kDegPerRev : span_deg.to, passes_zero};
}

std::vector<Span> worst_of(std::vector<Span> spans, std::size_t most) {
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.share > b.share; });
    spans.resize(std::min(spans.size(), most));
    return spans;
}

Result<ModelFindings> find_in_model(const piece::PlacedModel& model, const slice::SliceOptions& options) {
    auto hidden = hidden_places(model, options);
    if (!hidden) return hidden.error();
    return ModelFindings{model::parts_of(model.mesh->triangles), std::move(*hidden)};
}

}  // namespace psicarve::report
