// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "hmi/tool/surface_tiles.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/units.hpp"

/// The inner loops of dilated(), several places at a time.
namespace psicarve::tool::dilation {

// So many places are done at once: neighbours in a row, and rows.
inline constexpr std::size_t kLanes = 8;
inline constexpr std::size_t kQuad = 4;
inline constexpr std::size_t kGroupRows = 4;
inline constexpr std::size_t kFineSide = 4;
inline constexpr std::size_t kCoarseSide = 16;
inline constexpr std::size_t kRemembered = 4;
// What single precision may take from a squared length.
inline constexpr float kRimSlack = 1.0F + 1e-6F;
inline constexpr float kPruneSlack = 1.0F + 1e-4F;

using Lanes = std::array<float, kLanes>;

/// As many places as the processor's simplest vectors hold.
using Quad = float __attribute__((vector_size(16)));

inline float root(float value) noexcept {
    return std::sqrt(value);
}
inline Quad root(const Quad& value) noexcept {
#ifdef __SSE__
    return _mm_sqrt_ps(value);
#else
    return Quad{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
#endif
}
inline float larger(float a, float b) noexcept {
    return a > b ? a : b;
}
inline Quad larger(const Quad& a, const Quad& b) noexcept {
    return a > b ? a : b;
}
inline float smaller(float a, float b) noexcept {
    return a < b ? a : b;
}
inline Quad smaller(const Quad& a, const Quad& b) noexcept {
    return a < b ? a : b;
}
inline Quad quad_at(const float* from) noexcept {
    Quad quad;
    std::memcpy(&quad, from, sizeof quad);
    return quad;
}

/// A tool above one place, or above several that are near each other; with quads, above four.
template <typename Value>
struct View {
    Value cosine{};
    Value sine{};
    float z = 0.0F;
    float aside = 0.0F;  ///< sine of the angle to the outermost of the places
    float above = 0.0F;  ///< to the highest of them
    Value least_tip{};
    float spread = 0.0F;  ///< of the ball's centres about the middle one
    Value centre{};       ///< its radius; of a ball
};

struct DilationTool {
    Shape shape;
    float radius;
    float slope;
};

/// Above 0: nothing of the tile raises a tip of the view. A tip is raised by what stands within the tool's
/// radius of its axis and further out than the tool's surface there: of a ball by what is inside of it, or
/// further out than its centre.
template <Shape kShape, typename Value>
inline Value excess_of(const DilationTool& tool, const View<Value>& view, const SurfaceTiles& tiles,
                       std::size_t i) {
    const Value none{};
    const Value out = tiles.x[i] * view.cosine + tiles.y[i] * view.sine;
    const Value across = tiles.y[i] * view.cosine - tiles.x[i] * view.sine;
    const Value across_size = larger(across, -across);
    const float up = tiles.z[i] - view.z;
    const float reach = tiles.reach[i];
    if (reach < 0.0F) return none + 1.0F;
    const Value turn = (larger(out, -out) + across_size) * view.aside;
    const Value s = root(across * across + up * up) - reach - turn - view.above;
    const Value outermost = larger(out, none) + reach + across_size * view.aside;
    const Value beside = s - tool.radius;
    if constexpr (kShape != Shape::ball)
        return larger(beside, view.least_tip - outermost + tool.slope * larger(none, s));
    const Value behind = view.least_tip + tool.radius - outermost;
    const Value in = view.centre - out;
    const Value normal_out = tiles.normal_x[i] * view.cosine + tiles.normal_y[i] * view.sine;
    const Value normal_across = tiles.normal_y[i] * view.cosine - tiles.normal_x[i] * view.sine;
    const Value along = in * normal_out - across * normal_across - up * tiles.normal_z[i];
    const Value way2 = in * in + across * across + up * up;
    const Value aside = root(larger(none, way2 - along * along));
    const Value off = larger(none, larger(along, -along) - tiles.bulge[i]);
    const Value apart = larger(none, aside - reach);
    const float most = tool.radius + view.spread;
    return smaller(off * off + apart * apart - most * most * kPruneSlack, larger(beside, behind));
}

/// The turn's cosines and squared sines by column, twice over and a little more; every `step`th stands beside
/// the next, so that places so far apart are read in lanes.
class TurnTable {
public:
    TurnTable(std::size_t column_count, std::size_t step)
        : step_(step), row_((2 * column_count + step * kLanes) / step + 1) {
        for (std::size_t i = 0; i < step * row_; ++i) {
            const std::size_t column = i % row_ * step + i / row_;
            const double angle_rad =
                2.0 * kPi * static_cast<double>(column) / static_cast<double>(column_count);
            cosine_.push_back(static_cast<float>(std::cos(angle_rad)));
            sine_.push_back(static_cast<float>(std::sin(angle_rad)));
            sine2_.push_back(static_cast<float>(std::sin(angle_rad) * std::sin(angle_rad)));
        }
    }
    const float* cosine(std::size_t column) const noexcept { return cosine_.data() + place(column); }
    const float* sine(std::size_t column) const noexcept { return sine_.data() + place(column); }
    const float* sine2(std::size_t column) const noexcept { return sine2_.data() + place(column); }

private:
    std::size_t place(std::size_t column) const noexcept { return column % step_ * row_ + column / step_; }

    std::size_t step_;
    std::size_t row_;
    std::vector<float> cosine_;
    std::vector<float> sine_;
    std::vector<float> sine2_;
};

/// The samples of one row that stand together, seen by a row of places.
struct Run {
    const float* radius = nullptr;
    std::size_t count = 0;
    std::size_t turn =
        0;  ///< of the first sample against the first place, in the table; falls from one to next
    float up2 = 0.0F;
};

/// Whether the samples may raise a tip.
template <Shape kShape>
inline bool may_raise(const DilationTool& tool, const Run& run, const TurnTable& table, const Lanes& tips) {
    const float rim2 = tool.radius * tool.radius * kRimSlack;
    const float slope2 = tool.slope * tool.slope;
    const Quad none{};
    Quad lowest{};
    for (std::size_t lane = 0; lane < kLanes; lane += kQuad) {
        const Quad tip = quad_at(tips.data() + lane);
        for (std::size_t k = 0; k < run.count; ++k) {
            const float radius = run.radius[k];
            const Quad out = radius * quad_at(table.cosine(run.turn - k) + lane);
            const Quad s2 = radius * radius * quad_at(table.sine2(run.turn - k) + lane) + run.up2;
            if constexpr (kShape == Shape::ball) {
                const Quad in = larger(none, tip + tool.radius - out);
                lowest = smaller(lowest, s2 + in * in - rim2);
            } else {
                const Quad behind = tip - out;
                lowest = smaller(lowest, larger(s2 - rim2, slope2 * s2 + behind * larger(behind, -behind)));
            }
        }
    }
    return lowest[0] < 0.0F || lowest[1] < 0.0F || lowest[2] < 0.0F || lowest[3] < 0.0F;
}

template <Shape kShape>
inline void raise(const DilationTool& tool, const Run& run, const TurnTable& table, Lanes& tips) {
    const float radius2 = tool.radius * tool.radius;
    const Quad none{};
    for (std::size_t lane = 0; lane < kLanes; lane += kQuad) {
        Quad most = quad_at(tips.data() + lane);
        for (std::size_t k = 0; k < run.count; ++k) {
            const float radius = run.radius[k];
            const Quad s2 = radius * radius * quad_at(table.sine2(run.turn - k) + lane) + run.up2;
            Quad tip = radius * quad_at(table.cosine(run.turn - k) + lane);
            if constexpr (kShape == Shape::ball) tip += root(larger(none, radius2 - s2)) - tool.radius;
            if constexpr (kShape == Shape::vee) tip -= tool.slope * root(s2);
            most = larger(most, s2 <= none + radius2 * kRimSlack ? tip : none);
        }
        std::memcpy(tips.data() + lane, &most, sizeof most);
    }
}

}  // namespace psicarve::tool::dilation
