// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "hmi/tool/dilation_lanes.hpp"
#include "hmi/tool/surface_tiles.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"

/// The inner loops of dilated(): which tiles of samples are out of reach of a block of places, and what is
/// left, sample by sample.
namespace psicarve::tool::dilation {

// The size of a block in places: neighbours in a row, and rows.
inline constexpr std::size_t kLanes = 8;
inline constexpr std::size_t kBlockRows = 8;
// Margins for the rounding of a squared length in single precision.
inline constexpr float kRimSlack = 1.0F + 1e-6F;
inline constexpr float kPruneSlack = 1.0F + 1e-4F;

using Lanes = std::array<float, kLanes>;
using Columns = std::array<std::int32_t, kLanes>;

struct DilationTool {
    Shape shape;
    float radius;
    float slope;
};

/// Several places as one, for bounds that hold for each of them.
struct BlockView {
    float cosine = 0.0F;  ///< of the middle direction
    float sine = 0.0F;
    float aside = 0.0F;  ///< sine of the angle from there to the outermost
    float z = 0.0F;      ///< of the middle height
    float above = 0.0F;  ///< from there to the highest
    float least_tip = 0.0F;
    // Of a ball: a disc that holds all centres, which stand within `reach` of the middle along the disc and
    // within `bulge` to either side of it; none is further than `distance` from the middle.
    std::array<float, 3> middle{};
    std::array<float, 3> normal{};
    float reach = 0.0F;
    float bulge = 0.0F;
    float distance = 0.0F;
};

/// Above 0: nothing in the tile raises any tip of the block, for each of four tiles from `first` on.
///
/// A sample raises a tip if it stands within the tool's radius of its axis and further out than the tool's
/// surface there. `outermost` is as far out as any sample may stand in any place's direction, and `s` as near
/// to its axis: in a direction d beside the middle one, |across| gets less by no more than
/// |across| (1 - cos d) + |out| sin d, and 1 - cos d <= sin d up to a right angle.
///
/// A ball is raised by what is within its radius of its centre, or, further out than that, of its axis. Of
/// the way between a place of the disc and one of the tile the part along a normal is that between the
/// middles less what each of both may be off in that direction: the one whose normal it is by its bulge, the
/// other by its bulge times the cosine and its reach times the sine of the angle between the normals. The
/// part across is that between the middles less the reach of the one whose normal it is and the distance of
/// the other, whose bulge may be across it.
template <Shape kShape>
inline Quad block_excess(const DilationTool& tool, const BlockView& view, const SurfaceTiles& tiles,
                         std::size_t first) {
    const Quad none{};
    const Quad x = quad_at(&tiles.x[first]);
    const Quad y = quad_at(&tiles.y[first]);
    const Quad z = quad_at(&tiles.z[first]);
    const Quad reach = quad_at(&tiles.reach[first]);
    const Quad most_radius = quad_at(&tiles.most_radius[first]);
    const auto beside_or_behind = [&] {
        const Quad out = x * view.cosine + y * view.sine;
        const Quad across = y * view.cosine - x * view.sine;
        const Quad up = z - view.z;
        const Quad across_size = size_of(across);
        const Quad turn = (size_of(out) + across_size) * view.aside;
        const Quad s = root(across * across + up * up) - reach - turn - view.above;
        // Beyond a right angle a place of the block may see parts of a tile that are behind the block's
        // middle.
        const Quad forward = view.aside >= 1.0F ? size_of(out) : larger(out, none);
        const Quad outermost = smaller(most_radius, forward + reach + across_size * view.aside);
        const Quad behind = kShape == Shape::ball ? view.least_tip + tool.radius - outermost
                                                  : view.least_tip - outermost + tool.slope * larger(none, s);
        return larger(s - tool.radius, behind);
    };
    if constexpr (kShape != Shape::ball) return beside_or_behind();
    const Quad normal_x = quad_at(&tiles.normal_x[first]);
    const Quad normal_y = quad_at(&tiles.normal_y[first]);
    const Quad normal_z = quad_at(&tiles.normal_z[first]);
    const Quad bulge = quad_at(&tiles.bulge[first]);
    const Quad way_x = x - view.middle[0];
    const Quad way_y = y - view.middle[1];
    const Quad way_z = z - view.middle[2];
    const Quad way2 = way_x * way_x + way_y * way_y + way_z * way_z;
    const Quad cosine =
        size_of(normal_x * view.normal[0] + normal_y * view.normal[1] + normal_z * view.normal[2]);
    const Quad sine = root(larger(none, 1.0F - cosine * cosine)) + 1e-3F;
    const auto apart2 = [&](const Quad& along, const Quad& off, float places_reach) {
        const Quad across2 = larger(none, way2 - along * along);
        const Quad straight = larger(none, size_of(along) - off);
        const Quad aside = larger(none, root(across2) - reach - places_reach);
        return straight * straight + aside * aside;
    };
    const Quad from_disc = apart2(way_x * view.normal[0] + way_y * view.normal[1] + way_z * view.normal[2],
                                  view.bulge + bulge * cosine + reach * sine, view.reach);
    const float radius2 = tool.radius * tool.radius * kPruneSlack;
    Quad apart = from_disc - radius2;
    // Usually none of the four is near the disc.
    if (negative_bits(apart) != 0) {
        const Quad off = bulge + view.bulge * cosine + view.reach * sine;
        const Quad from_tile =
            apart2(way_x * normal_x + way_y * normal_y + way_z * normal_z, off, view.distance);
        apart = larger(from_disc, from_tile) - radius2;
    }
    if (negative_bits(view.least_tip + tool.radius - most_radius) == 0) return apart;
    return smaller(apart, beside_or_behind());
}

/// The turn's cosines, sines and squared sines by column, twice over and a little more.
class TurnTable {
public:
    explicit TurnTable(std::size_t column_count) {
        for (std::size_t i = 0; i < 2 * column_count + kLanes; ++i) {
            const double angle_rad =
                2.0 * kPi * static_cast<double>(i % column_count) / static_cast<double>(column_count);
            cosine_.push_back(static_cast<float>(std::cos(angle_rad)));
            sine_.push_back(static_cast<float>(std::sin(angle_rad)));
            sine2_.push_back(static_cast<float>(std::sin(angle_rad) * std::sin(angle_rad)));
        }
    }
    const float* cosine(std::size_t column) const noexcept { return cosine_.data() + column; }
    const float* sine(std::size_t column) const noexcept { return sine_.data() + column; }
    const float* sine2(std::size_t column) const noexcept { return sine2_.data() + column; }

private:
    std::vector<float> cosine_;
    std::vector<float> sine_;
    std::vector<float> sine2_;
};

/// Neighbouring samples of one row, seen by four places.
struct Run {
    const float* radius = nullptr;
    std::size_t count = 0;
    /// Angle between the first sample and the first place, as index of the table; falls from one to the next.
    std::size_t turn = 0;
    float up2 = 0.0F;
    std::int32_t row = 0;
    std::int32_t column = 0;  ///< of the first one
};

/// Four tips, and the sample that holds each.
struct HeldQuad {
    Quad tips{};
    QuadMask row{};
    QuadMask column{};

    void take(const Quad& tip, const QuadMask& tip_row, const QuadMask& tip_column) noexcept {
        const QuadMask is_higher = tip > tips;
        tips = larger(tips, tip);
        row = is_higher ? tip_row : row;
        column = is_higher ? tip_column : column;
    }
};

struct TipRow {
    Lanes tips{};
    Columns contact_row{};
    Columns contact_column{};

    HeldQuad held(std::size_t lane) const noexcept {
        return {quad_at(tips.data() + lane), mask_at(contact_row.data() + lane),
                mask_at(contact_column.data() + lane)};
    }
    void set(std::size_t lane, const HeldQuad& held) noexcept {
        std::memcpy(tips.data() + lane, &held.tips, sizeof held.tips);
        std::memcpy(contact_row.data() + lane, &held.row, sizeof held.row);
        std::memcpy(contact_column.data() + lane, &held.column, sizeof held.column);
    }
};

/// The places of a block, by row and lane.
struct PlaceBlock {
    const float* cosine = nullptr;  ///< by lane
    const float* sine = nullptr;
    std::array<float, kBlockRows> z{};
    std::array<TipRow, kBlockRows> rows{};
    std::array<Lanes, kBlockRows> centre_x{};  ///< of a ball
    std::array<Lanes, kBlockRows> centre_y{};
};

inline constexpr std::size_t kRowQuads = kLanes / kQuad;
inline constexpr std::size_t kBlockQuads = kBlockRows * kRowQuads;
static_assert(kBlockQuads <= 32, "a bit each");

/// As block_excess(), with one place instead of a disc, for the four places of the block's quad `i` and one
/// tile.
template <Shape kShape>
inline Quad place_excess(const DilationTool& tool, const PlaceBlock& places, const SurfaceTiles& tiles,
                         std::size_t tile, std::size_t i) {
    const Quad none{};
    const std::size_t lane = i % kRowQuads * kQuad;
    const float up = tiles.z[tile] - places.z[i / kRowQuads];
    const Quad tip = quad_at(places.rows[i / kRowQuads].tips.data() + lane);
    const Quad cosine = quad_at(places.cosine + lane);
    const Quad sine = quad_at(places.sine + lane);
    const Quad out = tiles.x[tile] * cosine + tiles.y[tile] * sine;
    const Quad across = tiles.y[tile] * cosine - tiles.x[tile] * sine;
    const Quad s = larger(none, root(across * across + up * up) - tiles.reach[tile]);
    const Quad outermost = smaller(all_of(tiles.most_radius[tile]), larger(out, none) + tiles.reach[tile]);
    const Quad behind = kShape == Shape::ball ? tip + tool.radius : tip + tool.slope * s;
    return larger(s - tool.radius, behind - outermost);
}

/// The quads of the block of which a tile may raise a tip, as bits, row after row. No branch for a ball: the
/// processor waits long for a square root, and several run side by side.
template <Shape kShape>
inline unsigned near_quads(const DilationTool& tool, const PlaceBlock& places, const SurfaceTiles& tiles,
                           std::size_t tile) {
    unsigned near = 0;
    const auto is_near = [&near](std::size_t i, const Quad& excess) {
        near |= static_cast<unsigned>(negative_bits(excess) != 0) << i;
    };
    if constexpr (kShape != Shape::ball) {
        for (std::size_t i = 0; i < kBlockQuads; ++i)
            is_near(i, place_excess<kShape>(tool, places, tiles, tile, i));
        return near;
    }
    const Quad none{};
    const float x = tiles.x[tile];
    const float y = tiles.y[tile];
    const float normal_x = tiles.normal_x[tile];
    const float normal_y = tiles.normal_y[tile];
    const float normal_z = tiles.normal_z[tile];
    const float bulge = tiles.bulge[tile];
    const float reach = tiles.reach[tile];
    const float most_radius = tiles.most_radius[tile];
    const float radius2 = tool.radius * tool.radius * kPruneSlack;
    unsigned below = 0;  // quads of which some tip's centre is nearer to the axis than some sample
    for (std::size_t i = 0; i < kBlockQuads; ++i) {
        const std::size_t row = i / kRowQuads;
        const std::size_t lane = i % kRowQuads * kQuad;
        const float up = tiles.z[tile] - places.z[row];
        const Quad way_x = x - quad_at(places.centre_x[row].data() + lane);
        const Quad way_y = y - quad_at(places.centre_y[row].data() + lane);
        const Quad along = way_x * normal_x + way_y * normal_y + up * normal_z;
        const Quad way2 = way_x * way_x + way_y * way_y + up * up;
        const Quad straight = larger(none, size_of(along) - bulge);
        const Quad aside = larger(none, root(larger(none, way2 - along * along)) - reach);
        is_near(i, straight * straight + aside * aside - radius2);
        const Quad inwards = quad_at(places.rows[row].tips.data() + lane) + tool.radius - most_radius;
        below |= static_cast<unsigned>(negative_bits(inwards) != 0) << i;
    }
    for (unsigned left = below & ~near; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        is_near(i, place_excess<kShape>(tool, places, tiles, tile, i));
    }
    return near;
}

/// Radii of four tips that one sample allows; 0 where it is not below the tool.
template <Shape kShape>
inline Quad tips_by(const DilationTool& tool, const Quad& out, const Quad& s2) {
    const Quad none{};
    const float radius2 = tool.radius * tool.radius;
    Quad tip = out;
    if constexpr (kShape == Shape::ball) tip += root(larger(none, radius2 - s2)) - tool.radius;
    if constexpr (kShape == Shape::vee) tip -= tool.slope * root(s2);
    return s2 <= none + radius2 * kRimSlack ? tip : none;
}

/// Below 0: a sample may raise a tip.
template <Shape kShape>
inline Quad sample_excess(const DilationTool& tool, const Quad& tips, const Quad& out, const Quad& s2) {
    const float rim2 = tool.radius * tool.radius * kRimSlack;
    if constexpr (kShape == Shape::ball) {
        const Quad in = larger(Quad{}, tips + tool.radius - out);
        return s2 + in * in - rim2;
    }
    const Quad behind = tips - out;
    return larger(s2 - rim2, tool.slope * tool.slope * s2 + behind * size_of(behind));
}

/// Whether the samples may raise any of four tips.
template <Shape kShape>
inline bool may_raise(const DilationTool& tool, const Run& run, const TurnTable& table, const Quad& tips) {
    Quad lowest = all_of(1.0F);
    for (std::size_t k = 0; k < run.count; ++k) {
        const float radius = run.radius[k];
        const Quad out = radius * quad_at(table.cosine(run.turn - k));
        const Quad s2 = radius * radius * quad_at(table.sine2(run.turn - k)) + run.up2;
        lowest = smaller(lowest, sample_excess<kShape>(tool, tips, out, s2));
    }
    return negative_bits(lowest) != 0;
}

/// may_raise() for the rows of a whole tile, as bits; `stride` leads to the next row's samples. `run` is the
/// first one, `up2` holds one value for each.
template <Shape kShape>
inline unsigned may_raise_rows(const DilationTool& tool, const Run& run, std::size_t stride,
                               const std::array<float, kQuad>& up2, const TurnTable& table,
                               const Quad& tips) {
    std::array<Quad, kQuad> lowest{all_of(1.0F), all_of(1.0F), all_of(1.0F), all_of(1.0F)};
    for (std::size_t k = 0; k < kQuad; ++k) {
        const Quad cosine = quad_at(table.cosine(run.turn - k));
        const Quad sine2 = quad_at(table.sine2(run.turn - k));
        for (std::size_t row = 0; row < kQuad; ++row) {
            const float radius = run.radius[row * stride + k];
            const Quad s2 = radius * radius * sine2 + up2[row];
            lowest[row] = smaller(lowest[row], sample_excess<kShape>(tool, tips, radius * cosine, s2));
        }
    }
    unsigned bits = 0;
    for (unsigned row = 0; row < kQuad; ++row)
        bits |= static_cast<unsigned>(negative_bits(lowest[row]) != 0) << row;
    return bits;
}

template <Shape kShape>
inline void raise(const DilationTool& tool, const Run& run, const TurnTable& table, HeldQuad& held) {
    for (std::size_t k = 0; k < run.count; ++k) {
        const float radius = run.radius[k];
        const Quad tip = tips_by<kShape>(tool, radius * quad_at(table.cosine(run.turn - k)),
                                         radius * radius * quad_at(table.sine2(run.turn - k)) + run.up2);
        held.take(tip, run.row - QuadMask{}, run.column + static_cast<std::int32_t>(k) - QuadMask{});
    }
}

}  // namespace psicarve::tool::dilation
