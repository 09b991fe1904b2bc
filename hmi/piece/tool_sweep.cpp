// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/tool_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psicarve::piece {
namespace {

constexpr float kNowhere = 1e30F;
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// Each shape splits ToolCut's formula, operation for operation, into terms of a place and a column and the
// row's contribution. `entry` grows with ahead, aside and sine2, and falls with its divisor.

struct Seen {
    float ahead;
    float aside;
    float spread;
};

struct BallShape {
    float radius;

    Seen seen(float tip, float cosine, float sine2) const noexcept {
        const float centre = tip + radius;
        const float centre2 = centre * centre;
        return {centre * cosine, centre2 * sine2, 1.0F};
    }
    float entry(float ahead, float aside, float /*spread*/, float /*divisor*/, float /*sine2*/, float across2,
                float /*height2*/) const noexcept {
        const float rest = across2 - aside;
        const float inner = ahead - std::sqrt(std::max(rest, 0.0F));
        return rest >= 0.0F ? inner : kNowhere;
    }
};

struct FlatShape {
    static Seen seen(float tip, float cosine, float sine2) noexcept {
        const float inner = tip / cosine;
        return {inner, inner * inner * sine2, 1.0F};
    }
    static float entry(float ahead, float aside, float /*spread*/, float /*divisor*/, float /*sine2*/,
                       float across2, float /*height2*/) noexcept {
        return aside <= across2 ? ahead : kNowhere;
    }
};

struct VeeShape {
    float slope;

    Seen seen(float tip, float cosine, float sine2) const noexcept {
        return {tip * cosine, tip * tip * sine2, cosine * cosine - slope * slope * sine2};
    }
    float entry(float ahead, float aside, float spread, float divisor, float sine2, float across2,
                float height2) const noexcept {
        const float root = std::sqrt(std::max(0.0F, aside + spread * height2));
        const float inner = (ahead + slope * root) / divisor;
        return inner * inner * sine2 <= across2 ? inner : kNowhere;
    }
};

/// By halves, which the compiler does several at a time.
template <std::size_t kCount, typename Better>
float best_of(const std::array<float, kCount>& values, const Better& better) {
    if constexpr (kCount == 1) {
        return values[0];
    } else {
        std::array<float, kCount / 2> half;
        for (std::size_t i = 0; i < kCount / 2; ++i) half[i] = better(values[i], values[i + kCount / 2]);
        return best_of(half, better);
    }
}
constexpr auto kLeast = [](float a, float b) { return a < b ? a : b; };
constexpr auto kMost = [](float a, float b) { return a < b ? b : a; };

/// Bounds of entries: no bounded entry is further in.
template <typename Shape, template <typename> typename Bounds, std::size_t kCount>
std::array<float, kCount> bounds_of(const Shape& shape, const Bounds<std::array<float, kCount>>& of,
                                    float across2, float height2) {
    std::array<float, kCount> bound;
    for (std::size_t i = 0; i < kCount; ++i) {
        bound[i] = shape.entry(of.least.ahead[i], of.least.aside[i], of.least.spread[i], of.most_spread[i],
                               of.least.sine2[i], across2, height2);
    }
    return bound;
}

std::size_t wrapped(std::int64_t column, std::size_t column_count) {
    const auto around = static_cast<std::int64_t>(column_count);
    return static_cast<std::size_t>((column % around + around) % around);
}

}  // namespace

ToolSweep::ToolSweep(const tool::Tool& tool, StockMap& stock, double point_reach_rad, double point_reach_mm)
    : tool_(tool),
      plain_(tool, stock, point_reach_rad, point_reach_mm),
      stock_(stock),
      blocks_in_row_((stock.column_count() + kColumns - 1) / kColumns),
      cosine_(blocks_in_row_ * kColumns),
      sine_(blocks_in_row_ * kColumns),
      top_mm_(stock.row_count() * blocks_in_row_) {
    for (std::size_t column = 0; column < stock.column_count(); ++column) {
        cosine_[column] = static_cast<float>(std::cos(stock.direction_rad(column)));
        sine_[column] = static_cast<float>(std::sin(stock.direction_rad(column)));
    }
    for (std::size_t row = 0; row < stock.row_count(); ++row) {
        for (std::size_t column = 0; column < stock.column_count(); ++column) {
            float& top = top_mm_[row * blocks_in_row_ + column / kColumns];
            top = std::max(top, stock.row(row)[column]);
        }
    }
    places_.reserve(kPlaces);
}

void ToolSweep::at(double direction_rad, double height_mm, double tip_mm) {
    if (tool_.shape == tool::Shape::point) return plain_.at(direction_rad, height_mm, tip_mm);
    if (!places_.empty() && (height_mm != height_mm_ || places_.size() == kPlaces ||
                             std::abs(direction_rad - places_.front().direction_rad) > kMostTurn_rad))
        flush();
    height_mm_ = height_mm;
    places_.push_back(
        {direction_rad, tip_mm, ReachedColumns(tool_, stock_.column_count(), direction_rad, tip_mm)});
}

void ToolSweep::flush() {
    if (places_.empty()) return;
    if (tool_.shape == tool::Shape::ball) {
        sweep(BallShape{static_cast<float>(tool_.radius)});
    } else if (tool_.shape == tool::Shape::vee) {
        sweep(VeeShape{static_cast<float>(tool::flank_slope(tool_))});
    } else {
        sweep(FlatShape{});
    }
    places_.clear();
}

std::size_t ToolSweep::block_in_row(std::size_t block) const noexcept {
    const std::size_t index = first_block_ + block;
    return index < blocks_in_row_ ? index : index - blocks_in_row_;
}

/// Chooses the blocks that any place reaches.
void ToolSweep::choose_blocks() {
    std::int64_t first = places_.front().columns.first;
    std::int64_t last = first;
    for (const Place& place : places_) {
        first = std::min(first, place.columns.first);
        last = std::max(last, place.columns.first + static_cast<std::int64_t>(place.columns.count) - 1);
    }
    const std::size_t from = wrapped(first, stock_.column_count());
    const std::size_t to = wrapped(last, stock_.column_count());
    first_block_ = from / kColumns;
    const std::size_t last_block = to / kColumns + (to < from ? blocks_in_row_ : 0);
    blocks_.resize(std::min(blocks_in_row_, last_block - first_block_ + 1));
    stretches_.resize((blocks_.size() + kBlocks - 1) / kBlocks);
}

template <typename Shape>
void ToolSweep::look_from(const Shape& shape, std::size_t place) {
    const Place& from = places_[place];
    const auto tip = static_cast<float>(from.tip_mm);
    const auto cosine = static_cast<float>(std::cos(from.direction_rad));
    const auto sine = static_cast<float>(std::sin(from.direction_rad));
    const auto around = static_cast<std::int32_t>(stock_.column_count());
    const auto first = static_cast<std::int32_t>(wrapped(from.columns.first, stock_.column_count()));
    const auto count = static_cast<std::int32_t>(from.columns.count);
    float unseen = kInfinite;  // no constant: clang-tidy takes infinity for one that a float cannot hold
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const std::size_t begin = block_in_row(b) * kColumns;
        const float* cosines = cosine_.data() + begin;
        const float* sines = sine_.data() + begin;
        Terms<PerColumn>& terms = blocks_[b].at[place];
        PerColumn most_spread;
        PerColumn most_sine2;
        for (std::size_t i = 0; i < kColumns; ++i) {
            const auto column = static_cast<std::int32_t>(begin + i);
            const std::int32_t on = column - first < 0 ? column - first + around : column - first;
            const float across = sines[i] * cosine - cosines[i] * sine;
            const float ahead = cosines[i] * cosine + sines[i] * sine;
            const float sine2 = across * across;
            const Seen seen = shape.seen(tip, ahead, sine2);
            const bool is_seen = column < around && on < count && seen.spread > 0.0F;
            terms.ahead[i] = is_seen ? seen.ahead : unseen;
            terms.aside[i] = is_seen ? seen.aside : unseen;
            terms.spread[i] = is_seen ? seen.spread : unseen;
            terms.sine2[i] = is_seen ? sine2 : unseen;
            most_spread[i] = is_seen ? seen.spread : 0.0F;
            most_sine2[i] = is_seen ? sine2 : 0.0F;
        }
        Bounds<PerPlace>& bounds = blocks_[b].bounds;
        bounds.least.ahead[place] = best_of(terms.ahead, kLeast);
        bounds.least.aside[place] = best_of(terms.aside, kLeast);
        bounds.least.spread[place] = best_of(terms.spread, kLeast);
        bounds.least.sine2[place] = best_of(terms.sine2, kLeast);
        bounds.most_spread[place] = best_of(most_spread, kMost);
        const float sine2 = best_of(most_sine2, kMost);
        blocks_[b].most_sine2 = place == 0 ? sine2 : std::max(blocks_[b].most_sine2, sine2);
    }
}

void ToolSweep::bound_blocks() {
    for (std::size_t b = 0; b < stretches_.size() * kBlocks; ++b) {
        Bounds<PerBlock>& stretch = stretches_[b / kBlocks];
        const std::size_t i = b % kBlocks;
        if (b >= blocks_.size()) {
            stretch.least.ahead[i] = stretch.least.aside[i] = stretch.least.sine2[i] = kInfinite;
            stretch.least.spread[i] = stretch.most_spread[i] = 1.0F;
            continue;
        }
        Bounds<PerPlace>& bounds = blocks_[b].bounds;
        for (std::size_t place = places_.size(); place < kPlaces; ++place) {
            bounds.least.ahead[place] = bounds.least.aside[place] = bounds.least.sine2[place] = kInfinite;
            bounds.least.spread[place] = kInfinite;
            bounds.most_spread[place] = 0.0F;
        }
        stretch.least.ahead[i] = best_of(bounds.least.ahead, kLeast);
        stretch.least.aside[i] = best_of(bounds.least.aside, kLeast);
        stretch.least.spread[i] = best_of(bounds.least.spread, kLeast);
        stretch.least.sine2[i] = best_of(bounds.least.sine2, kLeast);
        stretch.most_spread[i] = best_of(bounds.most_spread, kMost);
    }
}

template <typename Shape>
void ToolSweep::sweep(const Shape& shape) {
    const ReachedRows rows(tool_, stock_, height_mm_);
    if (rows.begin >= rows.end) return;
    choose_blocks();
    for (std::size_t place = 0; place < places_.size(); ++place) look_from(shape, place);
    bound_blocks();
    for (std::size_t index = rows.begin; index < rows.end; ++index) {
        const double up = stock_.height_mm(index) - height_mm_;
        const auto height2 = static_cast<float>(up * up);
        const float across2 = static_cast<float>(tool_.radius * tool_.radius) - height2;
        if (across2 >= 0.0F) cut_row(shape, {index, across2, height2});
    }
}

template <typename Shape>
void ToolSweep::cut_row(const Shape& shape, const Row& row) {
    float* tops = top_mm_.data() + row.index * blocks_in_row_;
    for (std::size_t s = 0; s < stretches_.size(); ++s) {
        const std::size_t begin = block_in_row(s * kBlocks);
        PerBlock above;
        if (begin + kBlocks <= blocks_in_row_) {
            std::copy_n(tops + begin, kBlocks, above.begin());
        } else {
            for (std::size_t i = 0; i < kBlocks; ++i) above[i] = tops[(begin + i) % blocks_in_row_];
        }
        const PerBlock bound = bounds_of(shape, stretches_[s], row.across2, row.height2);
        for (std::size_t i = 0; i < kBlocks; ++i) above[i] -= bound[i];
        if (!(best_of(above, kMost) > 0.0F)) continue;
        for (std::size_t i = 0; i < kBlocks; ++i) {
            if (above[i] > 0.0F) cut_block(shape, s * kBlocks + i, row);
        }
    }
}

template <typename Shape>
void ToolSweep::cut_block(const Shape& shape, std::size_t index, const Row& row) {
    const Block& block = blocks_[index];
    const std::size_t in_row = block_in_row(index);
    const std::size_t begin = in_row * kColumns;
    const std::size_t count = std::min(kColumns, stock_.column_count() - begin);
    float* cells = stock_.row(row.index).data() + begin;
    float& top = top_mm_[row.index * blocks_in_row_ + in_row];
    PerColumn radii{};
    if (count == kColumns) {
        std::copy_n(cells, kColumns, radii.begin());
    } else {
        std::copy_n(cells, count, radii.begin());
    }
    top = best_of(radii, kMost);
    PerPlace bound = bounds_of(shape, block.bounds, row.across2, row.height2);
    const float lowest = best_of(bound, kLeast);
    if (!(lowest < top)) return;
    const auto cut_from = [&](std::size_t place) {
        const Terms<PerColumn>& terms = block.at[place];
        for (std::size_t i = 0; i < kColumns; ++i) {
            const float radius = radii[i];
            const float inner = shape.entry(terms.ahead[i], terms.aside[i], terms.spread[i], terms.spread[i],
                                            terms.sine2[i], row.across2, row.height2);
            const bool is_inside = radius * radius * terms.sine2[i] <= row.across2;
            radii[i] = is_inside && inner < radius ? inner : radius;
        }
        top = best_of(radii, kMost);
    };
    if (top * top * block.most_sine2 <= row.across2) {
        std::size_t deepest = 0;
        while (bound[deepest] > lowest) ++deepest;
        cut_from(deepest);
        bound[deepest] = kInfinite;
    }
    for (std::size_t place = 0; place < places_.size(); ++place) {
        if (bound[place] < top) cut_from(place);
    }
    if (count == kColumns) {
        std::copy_n(radii.begin(), kColumns, cells);
    } else {
        std::copy_n(radii.begin(), count, cells);
    }
}

}  // namespace psicarve::piece
