// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/expected_piece.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "hmi/piece/piece_carver.hpp"

namespace psicarve::piece {
namespace {

constexpr std::int64_t kFineSteps = 6400;  // of a turn

}  // namespace

StockMap expected_piece(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns) {
    return expected_piece(geometry, profile, columns, {}).value();
}

Result<StockMap> expected_piece(const verify::JobGeometry& geometry, const Profile& profile,
                                std::size_t columns, const slice::Progress& progress) {
    return expected_piece(geometry, profile, blank_of(geometry, profile, columns), nullptr, progress);
}

Result<StockMap> expected_piece(const verify::JobGeometry& geometry, const Profile& profile, StockMap blank,
                                Ridges* ridges, const slice::Progress& progress) {
    StockMap stock = std::move(blank);
    PieceCarver carver(geometry, profile, stock, ridges);
    const bool is_point = profile.tool.shape == ToolShape::point;
    const auto column_count = static_cast<std::int64_t>(stock.column_count());
    const std::int64_t stride =
        is_point ? 1 : std::max<std::int64_t>(1, geometry.rev_pulses() / (2 * column_count));
    // Ridges are thinner than the cells: cut at every pulse, except with a drive of very many pulses.
    const bool has_ridges = ridges != nullptr && !ridges->all().empty() && !is_point;
    const std::int64_t fine_stride = std::max<std::int64_t>(1, geometry.rev_pulses() / kFineSteps);
    for (std::uint32_t layer = 0; layer < geometry.layer_count(); ++layer) {
        if (progress && !progress(static_cast<double>(layer) / geometry.layer_count()))
            return Error{ErrorCode::cancelled, "the expected piece was cancelled"};
        for (std::uint32_t step = 0; step + 1 < geometry.point_count(); ++step) {
            const verify::Positions from = geometry.target(layer, step);
            const verify::Positions to = geometry.target(layer, step + 1);
            const std::int64_t turn = std::abs(to[index_of(Axis::psi)] - from[index_of(Axis::psi)]);
            const std::int64_t parts = std::max<std::int64_t>(1, (turn + stride - 1) / stride);
            const auto part_of_way = [&](std::int64_t k, std::int64_t of) {
                verify::Positions at{};
                const double part = static_cast<double>(k) / static_cast<double>(of);
                for (std::size_t axis = 0; axis < kAxisCount; ++axis)
                    at[axis] = from[axis] + std::llround(part * static_cast<double>(to[axis] - from[axis]));
                return at;
            };
            for (std::int64_t k = 0; k <= parts; ++k) carver.settle(part_of_way(k, parts), true);
            if (!has_ridges) continue;
            const std::int64_t fine = std::max<std::int64_t>(1, (turn + fine_stride - 1) / fine_stride);
            for (std::int64_t k = 1; k < fine; ++k) carver.settle_ridges(part_of_way(k, fine));
        }
        carver.settle({}, false);
    }
    carver.finish();
    return stock;
}

}  // namespace psicarve::piece
