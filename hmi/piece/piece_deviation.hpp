// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hmi/piece/ridges.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/slice/slicer.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/base/result.hpp"

namespace psicarve::piece {

/// Upper bounds of the histogram's bins [mm]; the last bin has none; gouges are negative.
inline constexpr std::array<double, 10> kDeviationBounds_mm{-1.0, -0.3, -0.1, -0.03, -0.01,
                                                            0.01, 0.03, 0.1,  0.3,   1.0};

/// One side of the deviation: cut too deep, or left over.
struct DeviationSide {
    double max_mm = 0.0;
    double mean_mm = 0.0;  ///< over all places; places of the other side count 0
    double direction_deg = 0.0;
    double height_mm = 0.0;  ///< of the largest, above the table
};

/// How far the carved piece is from the model, place by place: the shortest way from the piece's surface to
/// the model's outermost one; where that is less, the way to the piece from the part that the model has and
/// the piece lacks, which may be a ridge thinner than a place.
struct PieceDeviation {
    DeviationSide gouge;
    DeviationSide leftover;
    std::array<std::uint64_t, kDeviationBounds_mm.size() + 1> histogram{};  ///< places by bin
    std::uint64_t place_count = 0;
    double cell_mm = 0.0;  ///< the larger side of a place, at the blank's surface
    double removed_mm3 = 0.0;

    std::size_t column_count = 0;
    double bottom_mm = 0.0;          ///< of the lowest row's middle
    double top_mm = 0.0;             ///< of the highest
    std::vector<float> distance_mm;  ///< row by row, gouges negative
};

/// The rows of a stock map that the job's layers should carve: all from the first layer to the last; for a
/// point tool, whose cuts have no width, those that hold a layer.
std::vector<std::size_t> carved_rows(const verify::JobGeometry& geometry, const StockMap& stock,
                                     bool is_point);

/// `wanted_mm`: the model's radii in all cells of the map, row by row. Without rows it compares nothing.
PieceDeviation deviation_of(const StockMap& carved, std::span<const float> wanted_mm,
                            std::span<const std::size_t> rows);
/// Calls the progress at every row. ErrorCode::cancelled.
Result<PieceDeviation> deviation_of(const StockMap& carved, std::span<const float> wanted_mm,
                                    std::span<const std::size_t> rows, const slice::Progress& progress);
/// With the model's ridges, cut together with the map.
Result<PieceDeviation> deviation_of(const StockMap& carved, std::span<const float> wanted_mm,
                                    std::span<const std::size_t> rows, const Ridges* ridges,
                                    const slice::Progress& progress);

/// Share of the places where more than this is left over; one of kDeviationBounds_mm.
double leftover_share(const PieceDeviation& deviation, double over_mm);

/// How many places are at most this far from the model.
std::uint64_t places_within(const PieceDeviation& deviation, double distance_mm);
/// The distance that 99.5 % of the places keep within [mm], at least `least_mm`: full colour there, so that a
/// single place does not make all others pale.
double colour_reach_mm(const PieceDeviation& deviation, double least_mm);

/// "gouge at most 0.012 mm (mean ...), left over at most ...".
std::string deviation_text(const PieceDeviation& deviation);
/// One JSON object.
std::string deviation_json(const PieceDeviation& deviation);

}  // namespace psicarve::piece
