// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_parts.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/slice/hidden_parts.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"

namespace psicarve::report {

/// A place counts as unreached when the tool leaves more than this: more than the steps between layers and
/// points leave, and more than a file removes in passing.
inline constexpr double kUnreached_mm = 0.1;

enum class MeshFlaw : std::uint8_t {
    holes,         ///< connected rims of open edges
    turned_edges,  ///< between flipped facets
    inside_out,    ///< bodies
    degenerate,    ///< facets without area
    duplicate,     ///< repeated facets
    dropped,       ///< facets left out
};
struct FlawCount {
    MeshFlaw flaw;
    std::uint64_t count = 0;  ///< 0: not counted, but there are some

    bool operator==(const FlawCount&) const = default;
};
/// The flaws of a mesh, in the order in which they are reported. `parts`: null until they are counted.
std::vector<FlawCount> flaws_of(const model::MeshFacts& facts, const model::MeshParts* parts);

/// "mm", "inch", "m" or "um", by the size of the numbers alone: no model on this machine measures a
/// millimetre, or two metres.
const char* probable_unit(const model::MeshFacts& facts) noexcept;

/// From where to where, degrees or mm above the table, and the share of the surface there that is meant.
struct Span {
    double from = 0.0;
    double to = 0.0;
    double share = 0.0;
};
/// The directions of a span as reported: 350 to 10, through 0, instead of 350 to 370.
struct Directions {
    double from_deg = 0.0;
    double to_deg = 0.0;
    bool passes_zero = false;

    bool operator==(const Directions&) const = default;
};
Directions directions_of(const Span& span_deg) noexcept;
/// The spans with the largest shares, the largest first.
std::vector<Span> worst_of(std::vector<Span> spans, std::size_t most);

/// The directions and heights in which a model hides parts of itself, more than a hundredth, or is open.
struct HiddenPlaces {
    slice::HiddenParts parts;
    std::vector<Span> hidden_deg;
    std::vector<Span> hidden_mm;
    std::vector<Span> open_deg;
    std::vector<Span> open_mm;
};

/// The parts of a model, and the places that no tool reaches.
struct ModelFindings {
    model::MeshParts parts;
    HiddenPlaces hidden;
};
/// ErrorCode::cancelled.
Result<ModelFindings> find_in_model(const piece::PlacedModel& model, const slice::SliceOptions& options);

}  // namespace psicarve::report
