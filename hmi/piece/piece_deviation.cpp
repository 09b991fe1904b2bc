// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/piece_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "hmi/piece/missing_parts.hpp"
#include "hmi/piece/surface_distance.hpp"
#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

using Json = nlohmann::ordered_json;

std::size_t bin_of(double distance_mm) {
    const auto bound = std::upper_bound(kDeviationBounds_mm.begin(), kDeviationBounds_mm.end(), distance_mm);
    return static_cast<std::size_t>(bound - kDeviationBounds_mm.begin());
}

void note(DeviationSide& side, double depth_mm, double direction_rad, double height_mm) {
    side.mean_mm += depth_mm;
    if (depth_mm <= side.max_mm) return;
    side.max_mm = depth_mm;
    side.direction_deg = direction_rad * kDegPerRev / (2.0 * kPi);
    side.height_mm = height_mm;
}

double share(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

Json side_json(const DeviationSide& side) {
    return {{"max_mm", side.max_mm},
            {"mean_mm", side.mean_mm},
            {"at", {{"direction_deg", side.direction_deg}, {"height_mm", side.height_mm}}}};
}

void take_ridges(const MissingParts& missing, const Ridges& ridges, std::span<const std::size_t> rows,
                 PieceDeviation& out) {
    for (std::size_t i = 0; i < ridges.all().size(); ++i) {
        const Ridge& ridge = ridges.all()[i];
        const auto row = std::lower_bound(rows.begin(), rows.end(), ridge.row);
        if (row == rows.end() || *row != ridge.row) continue;
        const auto place = static_cast<std::size_t>(row - rows.begin()) * out.column_count + ridge.column;
        const auto distance = static_cast<float>(-missing.at_ridge(ridges, i));
        if (distance < 0.0F) out.distance_mm[place] = std::min(out.distance_mm[place], distance);
    }
}

void sum_up(const StockMap& carved, std::span<const std::size_t> rows, PieceDeviation& out) {
    out.place_count = out.distance_mm.size();
    for (std::size_t i = 0; i < out.place_count; ++i) {
        const double distance_mm = out.distance_mm[i];
        note(distance_mm < 0.0 ? out.gouge : out.leftover, std::abs(distance_mm),
             carved.direction_rad(i % out.column_count), carved.height_mm(rows[i / out.column_count]));
        ++out.histogram[bin_of(distance_mm)];
    }
    out.gouge.mean_mm /= static_cast<double>(out.place_count);
    out.leftover.mean_mm /= static_cast<double>(out.place_count);
}

}  // namespace

std::vector<std::size_t> carved_rows(const verify::JobGeometry& geometry, const StockMap& stock,
                                     bool is_point) {
    const double scale = 1.0 / geometry.y_pulses_per_mm();
    std::vector<char> holds_layer(stock.row_count(), 0);
    std::size_t first = stock.row_count();
    std::size_t last = 0;
    for (std::uint32_t layer = 0; layer < geometry.row_count(); ++layer) {
        const double height_mm = static_cast<double>(geometry.height(layer)) * scale;
        const double row = std::floor((height_mm - stock.bottom_mm()) / stock.row_mm());
        if (row < 0.0 || row >= static_cast<double>(stock.row_count())) continue;
        const auto at = static_cast<std::size_t>(row);
        holds_layer[at] = 1;
        first = std::min(first, at);
        last = std::max(last, at);
    }
    std::vector<std::size_t> rows;
    for (std::size_t row = first; row <= last && row < stock.row_count(); ++row) {
        if (!is_point || holds_layer[row] != 0) rows.push_back(row);
    }
    return rows;
}

PieceDeviation deviation_of(const StockMap& carved, std::span<const float> wanted_mm,
                            std::span<const std::size_t> rows) {
    return deviation_of(carved, wanted_mm, rows, {}).value();
}

Result<PieceDeviation> deviation_of(const StockMap& carved, std::span<const float> wanted_mm,
                                    std::span<const std::size_t> rows, const slice::Progress& progress) {
    return deviation_of(carved, wanted_mm, rows, nullptr, progress);
}

Result<PieceDeviation> deviation_of(const StockMap& carved, std::span<const float> wanted_mm,
                                    std::span<const std::size_t> rows, const Ridges* ridges,
                                    const slice::Progress& progress) {
    PieceDeviation out;
    out.column_count = carved.column_count();
    out.cell_mm = std::max(carved.row_mm(), carved.blank_radius_mm() * carved.direction_rad(1));
    out.removed_mm3 = carved.removed_mm3();
    if (rows.empty()) return out;
    out.bottom_mm = carved.height_mm(rows.front());
    out.top_mm = carved.height_mm(rows.back());
    const SurfaceDistance model(carved, wanted_mm);
    const MissingParts missing(carved, wanted_mm, rows);
    for (const std::size_t row : rows) {
        const std::size_t done = out.distance_mm.size() / carved.column_count();
        if (progress && !progress(static_cast<double>(done) / static_cast<double>(rows.size())))
            return Error{ErrorCode::cancelled, "the comparison was cancelled"};
        for (std::size_t column = 0; column < carved.column_count(); ++column) {
            const double radius_mm = carved.row(row)[column];
            const double distance_mm = model.of(row, column, radius_mm);
            const bool is_gouge = radius_mm < double{wanted_mm[row * carved.column_count() + column]};
            const double sided_mm =
                is_gouge ? -std::max(distance_mm, missing.at_cell(row, column)) : distance_mm;
            out.distance_mm.push_back(static_cast<float>(sided_mm));
        }
    }
    if (ridges != nullptr) take_ridges(missing, *ridges, rows, out);
    sum_up(carved, rows, out);
    return out;
}

double leftover_share(const PieceDeviation& deviation, double over_mm) {
    std::uint64_t places = 0;
    for (std::size_t bin = bin_of(over_mm); bin < deviation.histogram.size(); ++bin)
        places += deviation.histogram[bin];
    return share(places, deviation.place_count);
}

std::uint64_t places_within(const PieceDeviation& deviation, double distance_mm) {
    const auto is_near = [distance_mm](float distance) { return std::abs(double{distance}) <= distance_mm; };
    return static_cast<std::uint64_t>(
        std::count_if(deviation.distance_mm.begin(), deviation.distance_mm.end(), is_near));
}

double colour_reach_mm(const PieceDeviation& deviation, double least_mm) {
    std::vector<float> sizes;
    for (const float distance : deviation.distance_mm) sizes.push_back(std::abs(distance));
    if (sizes.empty()) return least_mm;
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() - 1 - sizes.size() / 200);
    std::nth_element(sizes.begin(), at, sizes.end());
    return std::max(least_mm, static_cast<double>(*at));
}

std::string deviation_text(const PieceDeviation& deviation) {
    std::array<char, 320> text{};
    const std::uint64_t near = deviation.histogram[bin_of(0.0)];
    std::snprintf(text.data(), text.size(),
                  "gouge at most %.3f mm (mean %.4f, worst at %.1f deg, %.2f mm), left over at most %.3f mm "
                  "(mean %.4f, worst at %.1f deg, %.2f mm); %.1f %% within 0.01 mm",
                  deviation.gouge.max_mm, deviation.gouge.mean_mm, deviation.gouge.direction_deg,
                  deviation.gouge.height_mm, deviation.leftover.max_mm, deviation.leftover.mean_mm,
                  deviation.leftover.direction_deg, deviation.leftover.height_mm,
                  100.0 * share(near, deviation.place_count));
    return text.data();
}

std::string deviation_json(const PieceDeviation& deviation) {
    Json histogram = Json::array();
    for (std::size_t bin = 0; bin < deviation.histogram.size(); ++bin) {
        const bool is_last = bin == kDeviationBounds_mm.size();
        histogram.push_back({{"from_mm", bin == 0 ? Json(nullptr) : Json(kDeviationBounds_mm[bin - 1])},
                             {"to_mm", is_last ? Json(nullptr) : Json(kDeviationBounds_mm[bin])},
                             {"share", share(deviation.histogram[bin], deviation.place_count)}});
    }
    const Json object{{"gouge", side_json(deviation.gouge)},
                      {"leftover", side_json(deviation.leftover)},
                      {"histogram", histogram},
                      {"places", deviation.place_count},
                      {"cell_mm", deviation.cell_mm},
                      {"removed_mm3", deviation.removed_mm3}};
    return object.dump();
}

}  // namespace psicarve::piece
