// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/dilation_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "shared/base/units.hpp"

namespace psicarve::tool::dilation {
namespace {

constexpr std::size_t kFineSide = 4;
constexpr std::size_t kCoarseSide = 16;
constexpr std::size_t kTilesPerSide = kCoarseSide / kFineSide;
// Of the lengths: what single precision may take from a bound.
constexpr float kDiscSlack_ratio = 2e-6F;

using Spot = std::array<float, 3>;

Spot difference(const Spot& a, const Spot& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

DilationScene::DilationScene(const SampledRadii& sampled, const Tool& moved, unsigned thread_count)
    : surface(sampled),
      tool{moved.shape, static_cast<float>(moved.radius), static_cast<float>(flank_slope(moved))},
      fine(sampled, kFineSide, thread_count),
      coarse(sampled, kCoarseSide, thread_count),
      table(sampled.column_count) {
    for (const float least : coarse.least_radius) {
        const double reach_rad = least > moved.radius ? std::asin(moved.radius / double{least}) : 0.5 * kPi;
        reach_columns.push_back(reach_rad / (2.0 * kPi) * static_cast<double>(sampled.column_count) + 1.0);
    }
}

DilationBlock::DilationBlock(const DilationScene& scene, std::size_t first_row) : scene_(scene) {
    for (std::size_t i = 0; i < kBlockRows; ++i) {
        rows_[i] = std::min(scene.surface.row_count - 1, first_row + i);
        places_.z[i] = static_cast<float>(scene.surface.row_pitch) * static_cast<float>(rows_[i]);
    }
}

PSICARVE_WHOLE_FOR_WIDE_REGISTERS
void DilationBlock::fill_rows(std::vector<float>& tips) {
    if (scene_.tool.shape == Shape::ball) return fill_rows_of<Shape::ball>(tips);
    if (scene_.tool.shape == Shape::vee) return fill_rows_of<Shape::vee>(tips);
    fill_rows_of<Shape::flat>(tips);
}

template <Shape kShape>
void DilationBlock::fill_rows_of(std::vector<float>& tips) {
    const std::size_t columns = scene_.surface.column_count;
    for (std::size_t column = 0; column < columns; column += kLanes) {
        begin<kShape>(column);
        set_view();
        if constexpr (kShape == Shape::ball) set_disc();
        seek_coarse<kShape>();
        for (std::size_t row = 0; row < kBlockRows; ++row)
            std::memcpy(tips.data() + rows_[row] * columns + column, places_.rows[row].tips.data(),
                        std::min(kLanes, columns - column) * sizeof(float));
    }
}

/// At its own place a tool stands at least on the sample. Usually the sample that held the tip in the same
/// lane of the block before shows which one holds this tip: one as far on as the block, or one a few columns
/// or a row beside it: with good tips to begin with nearly all else is left out. Lanes past the seam go on at
/// the turn's begin.
template <Shape kShape>
void DilationBlock::begin(std::size_t first_column) {
    first_column_ = first_column;
    places_.cosine = scene_.table.cosine(first_column);
    places_.sine = scene_.table.sine(first_column);
    const SampledRadii& surface = scene_.surface;
    for (std::size_t row = 0; row < kBlockRows; ++row) {
        TipRow& at = places_.rows[row];
        if (first_column > 0) {
            at.tips.fill(0.0F);
            try_contacts<kShape>(row, 0, static_cast<std::int32_t>(kLanes));
        }
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::size_t own = (first_column + lane) % surface.column_count;
            const float radius = surface.radius[rows_[row] * surface.column_count + own];
            if (first_column > 0 && !(radius > at.tips[lane])) continue;
            at.tips[lane] = std::max(0.0F, radius);
            at.contact_row[lane] = static_cast<std::int32_t>(rows_[row]);
            at.contact_column[lane] = static_cast<std::int32_t>(own);
        }
        for (const std::int32_t way : {-5, 5, -2, 2, -1, 1}) try_contacts<kShape>(row, 0, way);
        for (const std::int32_t way : {-1, 1}) try_contacts<kShape>(row, way, 0);
        set_centres(row);
    }
}

/// Tries the samples at this distance from the contacts.
template <Shape kShape>
void DilationBlock::try_contacts(std::size_t row, std::int32_t rows_on, std::int32_t columns_on) {
    const SampledRadii& surface = scene_.surface;
    const auto columns = static_cast<std::int32_t>(surface.column_count);
    const auto last_row = static_cast<std::int32_t>(surface.row_count) - 1;
    if (columns <= static_cast<std::int32_t>(kLanes)) columns_on %= columns;
    TipRow& at = places_.rows[row];
    for (std::size_t lane = 0; lane < kLanes; lane += kQuad) {
        const QuadMask contact_row = mask_at(at.contact_row.data() + lane) + rows_on;
        const QuadMask contact_column = mask_at(at.contact_column.data() + lane) + columns_on;
        const QuadMask least = contact_row < 0 ? QuadMask{} : contact_row;
        const QuadMask from = least > last_row ? QuadMask{} + last_row : least;
        const QuadMask past = contact_column < 0 ? contact_column + columns : contact_column;
        const QuadMask column = past >= columns ? past - columns : past;
        Quad radius;
        Quad cosine;
        Quad sine2;
        for (std::size_t k = 0; k < kQuad; ++k) {
            const auto left = static_cast<std::size_t>(column[k]);
            const std::size_t turn = surface.column_count + first_column_ + lane + k - left;
            radius[k] = surface.radius[static_cast<std::size_t>(from[k]) * surface.column_count + left];
            cosine[k] = *scene_.table.cosine(turn);
            sine2[k] = *scene_.table.sine2(turn);
        }
        const Quad up = static_cast<float>(surface.row_pitch) *
                        (__builtin_convertvector(from, Quad) - static_cast<float>(rows_[row]));
        HeldQuad held = at.held(lane);
        held.take(tips_by<kShape>(scene_.tool, radius * cosine, radius * radius * sine2 + up * up), from,
                  column);
        at.set(lane, held);
    }
}

void DilationBlock::set_centres(std::size_t row) {
    const float* cosine = scene_.table.cosine(first_column_);
    const float* sine = scene_.table.sine(first_column_);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const float centre = places_.rows[row].tips[lane] + scene_.tool.radius;
        places_.centre_x[row][lane] = centre * cosine[lane];
        places_.centre_y[row][lane] = centre * sine[lane];
    }
}

void DilationBlock::set_view() {
    const auto columns = static_cast<double>(scene_.surface.column_count);
    const double half_rad = kPi * static_cast<double>(kLanes - 1) / columns;
    const double middle_rad = 2.0 * kPi * static_cast<double>(first_column_) / columns + half_rad;
    view_.cosine = static_cast<float>(std::cos(middle_rad));
    view_.sine = static_cast<float>(std::sin(middle_rad));
    view_.aside = static_cast<float>(half_rad < 0.5 * kPi ? std::sin(half_rad) : 1.0) + 1e-6F;
    view_.above = 0.5F * (places_.z[kBlockRows - 1] - places_.z[0]);
    view_.z = places_.z[0] + view_.above;
    view_.least_tip = places_.rows[0].tips[0];
    for (const TipRow& row : places_.rows) {
        for (const float tip : row.tips) view_.least_tip = std::min(view_.least_tip, tip);
    }
}

/// Through the middle of the centres and across both diagonals of their corners, else outwards.
void DilationBlock::set_disc() {
    const auto centre = [this](std::size_t row, std::size_t lane) {
        return Spot{places_.centre_x[row][lane], places_.centre_y[row][lane], places_.z[row]};
    };
    const Spot one = difference(centre(kBlockRows - 1, kLanes - 1), centre(0, 0));
    const Spot other = difference(centre(kBlockRows - 1, 0), centre(0, kLanes - 1));
    Spot normal{one[1] * other[2] - one[2] * other[1], one[2] * other[0] - one[0] * other[2],
                one[0] * other[1] - one[1] * other[0]};
    float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > 1e-12F)) {
        normal = {view_.cosine, view_.sine, 0.0F};
        length = 1.0F;
    }
    Spot middle{0.0F, 0.0F, view_.z};
    for (std::size_t row = 0; row < kBlockRows; ++row) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            middle[0] += places_.centre_x[row][lane] / static_cast<float>(kLanes * kBlockRows);
            middle[1] += places_.centre_y[row][lane] / static_cast<float>(kLanes * kBlockRows);
        }
    }
    for (float& part : normal) part /= length;
    Quad low{};
    Quad high{};
    Quad reach2{};
    for (std::size_t row = 0; row < kBlockRows; ++row) {
        const float up = places_.z[row] - middle[2];
        for (std::size_t lane = 0; lane < kLanes; lane += kQuad) {
            const Quad x = quad_at(places_.centre_x[row].data() + lane) - middle[0];
            const Quad y = quad_at(places_.centre_y[row].data() + lane) - middle[1];
            const Quad along = x * normal[0] + y * normal[1] + up * normal[2];
            low = smaller(low, along);
            high = larger(high, along);
            reach2 = larger(reach2, x * x + y * y + up * up);
        }
    }
    const float most = std::max({high[0], high[1], high[2], high[3]});
    const float least = std::min({low[0], low[1], low[2], low[3]});
    const float slack = kDiscSlack_ratio * (std::abs(middle[0]) + std::abs(middle[1]) + std::abs(middle[2]));
    view_.middle = middle;
    view_.normal = normal;
    for (std::size_t k = 0; k < 3; ++k) view_.middle[k] += 0.5F * (least + most) * normal[k];
    view_.bulge = 0.5F * (most - least) + slack;
    view_.reach = std::sqrt(std::max({reach2[0], reach2[1], reach2[2], reach2[3]})) + slack;
    view_.distance = view_.reach + 0.5F * std::abs(least + most);
}

/// Searches all tiles that are not out of reach: coarse ones first.
template <Shape kShape>
void DilationBlock::seek_coarse() {
    const double tile = scene_.surface.row_pitch * static_cast<double>(kCoarseSide);
    const double low = double{view_.z} - double{view_.above} - double{scene_.tool.radius};
    const double high = double{view_.z} + double{view_.above} + double{scene_.tool.radius};
    const auto first_row = static_cast<std::size_t>(std::max(0.0, std::floor(low / tile)));
    const auto past_row = static_cast<std::size_t>(std::max(0.0, std::floor(high / tile)) + 1.0);
    coarse_.clear();
    for (std::size_t row = first_row; row < std::min(scene_.coarse.row_count, past_row); ++row)
        seek_coarse_row<kShape>(row);
    std::sort(coarse_.begin(), coarse_.end(),
              [](const Seat& a, const Seat& b) { return a.excess < b.excess; });
    for (const Seat seat : coarse_) seek_fine<kShape>(seat);
}

/// Its columns that stand within the tool's radius of the places' axes, round the seam.
template <Shape kShape>
void DilationBlock::seek_coarse_row(std::size_t row) {
    if (!(scene_.coarse.least_radius[row] > 0.0F)) return;
    const double reach = scene_.reach_columns[row];
    const auto columns = static_cast<double>(scene_.surface.column_count);
    const auto side = static_cast<double>(kCoarseSide);
    const double from = static_cast<double>(first_column_) - reach;
    const double to = static_cast<double>(first_column_ + kLanes) + reach;
    const auto count = static_cast<std::int64_t>(scene_.coarse.column_count);
    // The last tile before the seam may be narrower than others: one more where that is crossed.
    auto first = static_cast<std::int64_t>(std::floor(from / side)) - (from < 0.0 ? 1 : 0);
    auto last = static_cast<std::int64_t>(std::floor(to / side)) + (to >= columns ? 1 : 0);
    if (last - first + 1 >= count) {
        first = 0;
        last = count - 1;
    }
    for (std::int64_t begin = first; begin <= last;) {
        const auto wrapped = static_cast<std::size_t>((begin % count + count) % count);
        const auto run =
            std::min(static_cast<std::size_t>(last - begin + 1), scene_.coarse.column_count - wrapped);
        for (std::size_t k = 0; k < run; k += kQuad) {
            const Quad excess = block_excess<kShape>(scene_.tool, view_, scene_.coarse,
                                                     row * scene_.coarse.column_count + wrapped + k);
            const unsigned bits = negative_bits(excess);
            for (std::size_t i = 0; bits != 0 && i < std::min(kQuad, run - k); ++i) {
                if ((bits >> i & 1U) != 0) coarse_.push_back({row, wrapped + k + i, excess[i]});
            }
        }
        begin += static_cast<std::int64_t>(run);
    }
}

template <Shape kShape>
void DilationBlock::seek_fine(Seat coarse) {
    static_assert(kTilesPerSide == kQuad);
    const SurfaceTiles& fine = scene_.fine;
    const std::size_t row_end = std::min(fine.row_count, (coarse.row + 1) * kTilesPerSide);
    const std::size_t first = coarse.column * kTilesPerSide;
    const std::size_t count = std::min(kTilesPerSide, fine.column_count - first);
    const unsigned within = (1U << count) - 1;
    for (std::size_t row = coarse.row * kTilesPerSide; row < row_end; ++row) {
        unsigned bits =
            negative_bits(block_excess<kShape>(scene_.tool, view_, fine, row * fine.column_count + first));
        for (bits &= within; bits != 0; bits &= bits - 1)
            touch<kShape>(row, first + static_cast<std::size_t>(std::countr_zero(bits)));
    }
}

template <Shape kShape>
void DilationBlock::touch(std::size_t tile_row, std::size_t tile_column) {
    const std::size_t tile = tile_row * scene_.fine.column_count + tile_column;
    unsigned raised = 0;
    for (unsigned near = near_quads<kShape>(scene_.tool, places_, scene_.fine, tile); near != 0;
         near &= near - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(near));
        if (try_tile<kShape>(i / kRowQuads, i % kRowQuads * kQuad, tile_row, tile_column))
            raised |= 1U << i / kRowQuads;
    }
    if constexpr (kShape != Shape::ball) return;
    for (; raised != 0; raised &= raised - 1) set_centres(static_cast<std::size_t>(std::countr_zero(raised)));
}

/// Whether it raised any of the four tips from `lane` on.
template <Shape kShape>
bool DilationBlock::try_tile(std::size_t row, std::size_t lane, std::size_t tile_row,
                             std::size_t tile_column) {
    const SampledRadii& surface = scene_.surface;
    const std::size_t columns = surface.column_count;
    const std::size_t first_row = tile_row * kFineSide;
    const std::size_t row_end = std::min(surface.row_count, first_row + kFineSide);
    const std::size_t first_column = tile_column * kFineSide;
    Run run;
    run.count = std::min(kFineSide, columns - first_column);
    run.turn = columns + first_column_ + lane - first_column;
    run.column = static_cast<std::int32_t>(first_column);
    run.radius = surface.radius.data() + first_row * columns + first_column;
    std::array<float, kFineSide> up2{};
    for (std::size_t i = 0; i < kFineSide; ++i) {
        const float up = static_cast<float>(surface.row_pitch) *
                         (static_cast<float>(first_row + i) - static_cast<float>(rows_[row]));
        up2[i] = up * up;
    }
    HeldQuad held = places_.rows[row].held(lane);
    const bool is_whole = run.count == kFineSide && first_row + kFineSide <= surface.row_count;
    unsigned left = (1U << (row_end - first_row)) - 1;
    if (is_whole) left = may_raise_rows<kShape>(scene_.tool, run, columns, up2, scene_.table, held.tips);
    bool has_raised = false;
    for (; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        Run at = run;
        at.radius += i * columns;
        at.row = static_cast<std::int32_t>(first_row + i);
        at.up2 = up2[i];
        // Tips that an earlier row has raised may be out of this one's reach.
        const bool is_tested = is_whole && !has_raised;
        if (!is_tested && !may_raise<kShape>(scene_.tool, at, scene_.table, held.tips)) continue;
        raise<kShape>(scene_.tool, at, scene_.table, held);
        has_raised = true;
    }
    if (has_raised) places_.rows[row].set(lane, held);
    return has_raised;
}

}  // namespace psicarve::tool::dilation
