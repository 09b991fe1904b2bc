// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/mesh_text.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "hmi/session/display_text.hpp"

namespace psicarve::session {
namespace {

constexpr double kMm3PerCm3OfMesh = 1000.0;
constexpr double kPercentOfMesh = 100.0;
constexpr std::size_t kMostPlaces = 3;

Phrase holes_phrase(std::uint64_t holes, std::uint64_t open_edges) {
    if (holes > 0) return phrase("holes: %1, open edges: %2", counted(holes), counted(open_edges));
    return open_edges > 0 ? phrase("open edges: %1", counted(open_edges)) : phrase("open edges");
}

Phrase flaw_phrase(const report::FlawCount& found, const model::MeshFacts& facts) {
    const std::string count = counted(found.count);
    switch (found.flaw) {
        case report::MeshFlaw::holes:
            return holes_phrase(found.count, facts.open_edge_count);
        case report::MeshFlaw::turned_edges:
            return phrase("edges between flipped facets: %1", count);
        case report::MeshFlaw::inside_out:
            return found.count > 0 ? phrase("bodies inside out: %1", count) : phrase("inside out");
        case report::MeshFlaw::degenerate:
            return phrase("without area: %1", count);
        case report::MeshFlaw::duplicate:
            return phrase("doubled: %1", count);
        case report::MeshFlaw::dropped:
            return phrase("left out: %1", count);
    }
    return {};
}

Phrase flaws_phrase(const model::MeshFacts& facts, const model::MeshParts* parts, Phrase none) {
    std::vector<Phrase> flaws;
    for (const report::FlawCount& found : report::flaws_of(facts, parts))
        flaws.push_back(flaw_phrase(found, facts));
    return flaws.empty() ? std::move(none) : listed(std::move(flaws));
}

Phrase unit_phrase(const model::MeshFacts& facts) {
    const std::string_view unit = report::probable_unit(facts);
    if (unit == "inch") return phrase("inches");
    return phrase("%1", std::string{unit == "um" ? "µm" : unit});
}

/// An open surface has no volume.
bool has_volume(const model::MeshFacts& facts) {
    return facts.closed && facts.same_orientation;
}

Phrase size_phrase(const ModelKnowledge& known) {
    const ReachReport* view = known.reach;
    if (view == nullptr) return phrase("…");
    const auto mm = [view](std::size_t k) { return number_text(view->size[k] * view->mm_per_unit, 2); };
    return phrase("%1 × %2 × %3 mm, scale %4", mm(0), mm(1), mm(2), number_text(view->mm_per_unit, 4));
}

Phrase volume_phrase(const ModelKnowledge& known) {
    if (!has_volume(known.mesh.facts))
        return phrase("not known: the surface is not closed, or turned both ways");
    if (known.reach == nullptr) return phrase("…");
    const double mm3 = std::abs(known.mesh.facts.signed_volume) * std::pow(known.reach->mm_per_unit, 3.0);
    return phrase("%1 cm³", number_text(mm3 / kMm3PerCm3OfMesh, 2));
}

enum class PlaceUnit { degrees, mm };

Phrase directions_phrase(const report::Span& span, const std::string& share) {
    const report::Directions told = report::directions_of(span);
    const std::string from = number_text(told.from_deg, 0);
    const std::string to = number_text(told.to_deg, 0);
    return told.passes_zero ? phrase("%1–%2°, through 0° (%3 %)", from, to, share)
                            : phrase("%1–%2° (%3 %)", from, to, share);
}

Phrase heights_phrase(const report::Span& span, const std::string& share) {
    return phrase("%1–%2 mm high (%3 %)", number_text(span.from, 1), number_text(span.to, 1), share);
}

/// "40–70° (12.0 %), 350–10°, through 0° (5.0 %) …"
Phrase places_phrase(const std::vector<report::Span>& spans, PlaceUnit unit) {
    std::vector<Phrase> places;
    for (const report::Span& span : report::worst_of(spans, kMostPlaces)) {
        const std::string share = number_text(kPercentOfMesh * span.share, 1);
        places.push_back(unit == PlaceUnit::degrees ? directions_phrase(span, share)
                                                    : heights_phrase(span, share));
    }
    if (spans.size() > kMostPlaces) places.push_back(phrase("…"));
    return listed(std::move(places));
}

void add_places(std::vector<ReportRow>& rows, const std::vector<report::Span>& spans, PlaceUnit unit) {
    if (!spans.empty()) rows.push_back({{}, places_phrase(spans, unit)});
}

Phrase undercut_phrase(const ModelKnowledge& known) {
    if (known.sliced_undercut_share)
        return phrase("%1 % of the surface", number_text(kPercentOfMesh * *known.sliced_undercut_share, 2));
    if (known.reach == nullptr) return phrase("…");
    return phrase("about %1 % of the surface", number_text(kPercentOfMesh * known.reach->undercut_share, 1));
}

void add_reach(const ModelKnowledge& known, std::vector<ReportRow>& rows) {
    rows.push_back({phrase("Undercut"), undercut_phrase(known)});
    const report::ModelFindings* found = known.findings;
    if (found != nullptr) {
        add_places(rows, found->hidden.hidden_deg, PlaceUnit::degrees);
        add_places(rows, found->hidden.hidden_mm, PlaceUnit::mm);
    }
    if (found == nullptr) return rows.push_back({phrase("Open in directions"), phrase("…")});
    const bool is_open = !found->hidden.open_deg.empty();
    rows.push_back({phrase("Open in directions"),
                    is_open ? places_phrase(found->hidden.open_deg, PlaceUnit::degrees) : phrase("none")});
    add_places(rows, found->hidden.open_mm, PlaceUnit::mm);
}

void add_tool(const ModelKnowledge& known, std::vector<ReportRow>& rows) {
    const PieceView* piece = known.piece;
    const Phrase name = piece != nullptr && piece->draft_allowance_mm ? phrase("The tool leaves (draft)")
                                                                      : phrase("The tool leaves");
    if (piece == nullptr || !piece->deviation) {
        const bool is_told = !known.no_piece.is_empty();
        return rows.push_back({name, is_told ? known.no_piece : phrase("…")});
    }
    const Phrase unreached = phrase(
        "More than %1 mm on %2 % of the surface", number_text(report::kUnreached_mm, 1),
        number_text(kPercentOfMesh * piece::leftover_share(*piece->deviation, report::kUnreached_mm), 2));
    rows.push_back({name, unreached});
    for (const Phrase& line : piece_lines(*piece)) rows.push_back({{}, line});
}

}  // namespace

std::vector<Phrase> mesh_lines(const model::Mesh& mesh, const std::array<double, 3>& size) {
    const model::MeshFacts& facts = mesh.facts;
    const std::string facets = counted(mesh.triangles.size());
    std::vector<Phrase> lines{
        phrase("%1 × %2 × %3", number_text(size[0], 1), number_text(size[1], 1), number_text(size[2], 1)),
        has_volume(facts) ? phrase("%1 facets, %2 cm³", facets,
                                   number_text(std::abs(facts.signed_volume) / kMm3PerCm3OfMesh, 1))
                          : phrase("%1 facets", facets),
        flaws_phrase(facts, nullptr, phrase("Surface closed, all facets turned alike"))};
    const bool is_mm = std::string_view{report::probable_unit(facts)} == "mm";
    if (!is_mm) lines.push_back(joined(phrase("Probable unit"), unit_phrase(facts)));
    return lines;
}

std::vector<ReportRow> model_rows(const ModelKnowledge& known) {
    const model::Mesh& mesh = known.mesh;
    const model::MeshParts* parts = known.findings != nullptr ? &known.findings->parts : nullptr;
    std::vector<ReportRow> rows{
        {phrase("Mesh"), phrase("%1, facets: %2", mesh.format, counted(mesh.triangles.size()))},
        {phrase("Bodies"), parts != nullptr ? phrase("%1", counted(parts->components)) : phrase("…")},
        {phrase("Surface"), flaws_phrase(mesh.facts, parts, phrase("closed, all facets turned alike"))},
        {phrase("Probable unit"), unit_phrase(mesh.facts)},
        {phrase("Size"), size_phrase(known)},
        {phrase("Volume"), volume_phrase(known)}};
    add_reach(known, rows);
    add_tool(known, rows);
    return rows;
}

}  // namespace psicarve::session
