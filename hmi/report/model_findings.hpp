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

/// What a tool leaves beyond this it does not reach: more than steps between layers and points leave, and
/// than a file takes off in passing.
inline constexpr double kUnreached_mm = 0.1;

enum class MeshFlaw : std::uint8_t {
    holes,         ///< connected rims of open edges
    turned_edges,  ///< between flipped facets
    inside_out,    ///< bodies
    degenerate,    ///< facets without area
    duplicate,     ///< facets that stood there once more
    dropped,       ///< facets that were left out
};
struct FlawCount {
    MeshFlaw flaw;
    std::uint64_t count = 0;  ///< 0: nobody has counted, but there are some

    bool operator==(const FlawCount&) const = default;
};
/// What is wrong with a mesh, in the order in which it is told. `parts`: null as long as nobody has counted
/// them.
std::vector<FlawCount> flaws_of(const model::MeshFacts& facts, const model::MeshParts* parts);

/// "mm", "inch", "m" or "um", by the size of the numbers alone: nobody turns a millimetre on a table, or two
/// metres.
const char* probable_unit(const model::MeshFacts& facts) noexcept;

/// From where to where, degrees or mm above the table, and how much of what lies there is meant.
struct Span {
    double from = 0.0;
    double to = 0.0;
    double share = 0.0;
};
/// Directions of a span as they are told: 350 to 10, through 0, instead of 350 to 370.
struct Directions {
    double from_deg = 0.0;
    double to_deg = 0.0;
    bool passes_zero = false;

    bool operator==(const Directions&) const = default;
};
Directions directions_of(const Span& span_deg) noexcept;
/// The largest shares, the largest first.
std::vector<Span> worst_of(std::vector<Span> spans, std::size_t most);

/// In which directions and at which heights a model hides parts of itself, more than a hundredth, or is open.
struct HiddenPlaces {
    slice::HiddenParts parts;
    std::vector<Span> hidden_deg;
    std::vector<Span> hidden_mm;
    std::vector<Span> open_deg;
    std::vector<Span> open_mm;
};

/// What a model is made of and what no tool reaches.
struct ModelFindings {
    model::MeshParts parts;
    HiddenPlaces hidden;
};
/// ErrorCode::cancelled.
Result<ModelFindings> find_in_model(const piece::PlacedModel& model, const slice::SliceOptions& options);

}  // namespace psicarve::report
