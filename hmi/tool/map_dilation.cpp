// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/map_dilation.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <system_error>
#include <thread>

#include "hmi/tool/dilation_gaps.hpp"
#include "hmi/tool/dilation_kernel.hpp"
#include "hmi/tool/surface_tiles.hpp"
#include "shared/units.hpp"

namespace psicarve::tool {
namespace {

using namespace dilation;

class DilationWork {
public:
    DilationWork(const SampledRadii& surface, const Tool& tool, Stride stride, std::vector<float>& tips,
                 unsigned thread_count, const slice::Progress& progress)
        : surface_(surface),
          tool_{tool.shape, static_cast<float>(tool.radius), static_cast<float>(flank_slope(tool))},
          fine_(surface, kFineSide, thread_count),
          coarse_(surface, kCoarseSide, thread_count),
          stride_(stride),
          table_(surface.column_count, stride.columns),
          tips_(tips),
          progress_(progress),
          row_count_((surface.row_count - 1 + stride.rows - 1) / stride.rows + 1),
          block_count_((row_count_ + kGroupRows - 1) / kGroupRows) {}

    std::size_t block_count() const noexcept { return block_count_; }
    bool is_cancelled() const noexcept { return is_cancelled_; }

    template <Shape kShape>
    void run(bool tells);
    void run_shape(bool tells) {
        if (tool_.shape == Shape::ball) return run<Shape::ball>(tells);
        if (tool_.shape == Shape::vee) return run<Shape::vee>(tells);
        run<Shape::flat>(tells);
    }

private:
    struct Seat {
        std::size_t row;
        std::size_t column;
        float excess = 0.0F;
    };
    /// Places that are done together, and what is known of them.
    struct Group {
        std::array<std::size_t, kGroupRows> rows{};
        std::size_t row_count = 0;
        std::size_t first_column = 0;
        std::array<Lanes, kGroupRows> tips{};
        std::array<Seat, kRemembered> raised{};  ///< fine tiles that raised a tip, the latest ones
        std::size_t raised_count = 0;
        std::vector<float> excess;
        std::vector<Seat> coarse;
    };

    void tell() {
        const double share = static_cast<double>(blocks_done_) / static_cast<double>(block_count_);
        if (progress_ && !progress_(share)) is_cancelled_ = true;
    }
    void begin(Group& group, std::size_t first_column) const;
    void store(const Group& group);
    View<float> view_of(const Group& group) const;
    template <Shape kShape>
    void fill(Group& group) const;
    template <Shape kShape>
    void touch(Group& group, Seat seat) const;
    template <Shape kShape>
    void seek(Group& group) const;
    template <Shape kShape>
    void seek_fine(Group& group, const View<float>& view, Seat coarse) const;

    const SampledRadii& surface_;
    DilationTool tool_;
    SurfaceTiles fine_;
    SurfaceTiles coarse_;
    Stride stride_;
    TurnTable table_;
    std::vector<float>& tips_;
    const slice::Progress& progress_;
    std::size_t row_count_;  ///< that are searched; the last one is among them
    std::size_t block_count_;
    std::atomic<std::size_t> next_block_{0};
    std::atomic<std::size_t> blocks_done_{0};
    std::atomic<bool> is_cancelled_{false};
};

template <Shape kShape>
void DilationWork::run(bool tells) {
    Group group;
    group.excess.resize(coarse_.column_count);
    for (;;) {
        if (tells) tell();
        const std::size_t block = next_block_.fetch_add(1);
        if (block >= block_count_ || is_cancelled_) return;
        group.row_count = std::min(kGroupRows, row_count_ - block * kGroupRows);
        for (std::size_t i = 0; i < group.row_count; ++i)
            group.rows[i] = std::min(surface_.row_count - 1, (block * kGroupRows + i) * stride_.rows);
        group.raised_count = 0;
        for (std::size_t column = 0; column < surface_.column_count; column += kLanes * stride_.columns) {
            begin(group, column);
            fill<kShape>(group);
            store(group);
        }
        blocks_done_.fetch_add(1);
    }
}

/// At its own place a tool stands on the sample. Lanes past the seam go on at the turn's begin.
void DilationWork::begin(Group& group, std::size_t first_column) const {
    group.first_column = first_column;
    for (std::size_t row = 0; row < group.row_count; ++row) {
        const float* radius = surface_.radius.data() + group.rows[row] * surface_.column_count;
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            group.tips[row][lane] =
                std::max(0.0F, radius[(first_column + lane * stride_.columns) % surface_.column_count]);
    }
}

void DilationWork::store(const Group& group) {
    for (std::size_t row = 0; row < group.row_count; ++row) {
        float* out = tips_.data() + group.rows[row] * surface_.column_count;
        std::size_t column = group.first_column;
        for (std::size_t lane = 0; lane < kLanes && column < surface_.column_count; ++lane) {
            out[column] = group.tips[row][lane];
            column += stride_.columns;
        }
    }
}

View<float> DilationWork::view_of(const Group& group) const {
    float least = group.tips[0][0];
    float most = least;
    for (std::size_t row = 0; row < group.row_count; ++row) {
        for (const float tip : group.tips[row]) {
            least = std::min(least, tip);
            most = std::max(most, tip);
        }
    }
    const auto pitch = static_cast<float>(surface_.row_pitch);
    const double half_rad = kPi * static_cast<double>((kLanes - 1) * stride_.columns) /
                            static_cast<double>(surface_.column_count);
    const double middle_rad =
        2.0 * kPi * static_cast<double>(group.first_column) / static_cast<double>(surface_.column_count) +
        half_rad;
    View<float> view;
    view.cosine = static_cast<float>(std::cos(middle_rad));
    view.sine = static_cast<float>(std::sin(middle_rad));
    const std::size_t last_row = group.rows[group.row_count - 1];
    view.above = 0.5F * pitch * static_cast<float>(last_row - group.rows[0]);
    view.z = pitch * static_cast<float>(group.rows[0]) + view.above;
    view.aside = static_cast<float>(half_rad < 0.5 * kPi ? std::sin(half_rad) : 1.0) + 1e-6F;
    view.least_tip = least;
    view.centre = tool_.radius + 0.5F * (least + most);
    const float round = (tool_.radius + most) * static_cast<float>(half_rad);
    view.spread =
        std::sqrt(0.25F * (most - least) * (most - least) + round * round + view.above * view.above);
    return view;
}

/// What raised the tips of the neighbours before mostly raises these, too, or what is beside it: with good
/// tips to begin with nearly all else is left out.
template <Shape kShape>
void DilationWork::fill(Group& group) const {
    touch<kShape>(group, {group.rows[0] / kFineSide, group.first_column / kFineSide});
    const auto raised = group.raised;
    const std::size_t count = group.raised_count;
    group.raised_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t further = 0; further <= kLanes * stride_.columns / kFineSide; ++further)
            touch<kShape>(group, {raised[i].row, (raised[i].column + further) % fine_.column_count});
    }
    seek<kShape>(group);
}

template <Shape kShape>
void DilationWork::touch(Group& group, Seat seat) const {
    const std::size_t columns = surface_.column_count;
    const std::size_t tile = seat.row * fine_.column_count + seat.column;
    const std::size_t first_row = seat.row * kFineSide;
    const std::size_t row_end = std::min(surface_.row_count, first_row + kFineSide);
    const std::size_t first_column = seat.column * kFineSide;
    const std::size_t count = std::min(kFineSide, columns - first_column);
    bool has_raised = false;
    for (std::size_t row = 0; row < group.row_count; ++row) {
        Lanes& tips = group.tips[row];
        const float z = static_cast<float>(surface_.row_pitch) * static_cast<float>(group.rows[row]);
        const float* cosine = table_.cosine(group.first_column);
        const float* sine = table_.sine(group.first_column);
        bool is_near = false;
        for (std::size_t lane = 0; lane < kLanes; lane += kQuad) {
            const Quad tip = quad_at(tips.data() + lane);
            const View<Quad> view{quad_at(cosine + lane), quad_at(sine + lane), z, 0.0F, 0.0F, tip, 0.0F,
                                  tip + tool_.radius};
            const Quad excess = excess_of<kShape>(tool_, view, fine_, tile);
            is_near =
                is_near || excess[0] <= 0.0F || excess[1] <= 0.0F || excess[2] <= 0.0F || excess[3] <= 0.0F;
        }
        if (!is_near) continue;
        for (std::size_t from = first_row; from < row_end; ++from) {
            const float up = static_cast<float>(surface_.row_pitch) *
                             (static_cast<float>(from) - static_cast<float>(group.rows[row]));
            if (std::abs(up) > tool_.radius * kRimSlack) continue;
            const Run run{surface_.radius.data() + from * columns + first_column, count,
                          columns + group.first_column - first_column, up * up};
            if (!may_raise<kShape>(tool_, run, table_, tips)) continue;
            raise<kShape>(tool_, run, table_, tips);
            has_raised = true;
        }
    }
    if (!has_raised) return;
    for (std::size_t i = 0; i < group.raised_count; ++i) {
        if (group.raised[i].row == seat.row && group.raised[i].column == seat.column) return;
    }
    group.raised[group.raised_count < kRemembered ? group.raised_count++ : kRemembered - 1] = seat;
}

/// All tiles that are not out of reach: coarse ones first.
template <Shape kShape>
void DilationWork::seek(Group& group) const {
    const View<float> view = view_of(group);
    const double pitch = surface_.row_pitch;
    const double low = view.z - view.above - tool_.radius;
    const double high = view.z + view.above + tool_.radius;
    const double tile_mm = pitch * static_cast<double>(kCoarseSide);
    const auto first_row = static_cast<std::size_t>(std::max(0.0, std::floor(low / tile_mm)));
    const std::size_t row_end = std::min(
        coarse_.row_count, static_cast<std::size_t>(std::max(0.0, std::floor(high / tile_mm)) + 1.0));
    group.coarse.clear();
    for (std::size_t row = first_row; row < row_end; ++row) {
        const double least = coarse_.least_radius[row];
        if (!(least > 0.0)) continue;
        const double reach_rad = least > tool_.radius ? std::asin(tool_.radius / least) : 0.5 * kPi;
        const double columns = static_cast<double>(surface_.column_count);
        const double reach = reach_rad / (2.0 * kPi) * columns + 1.0;
        const double side = static_cast<double>(kCoarseSide);
        const double from = static_cast<double>(group.first_column) - reach;
        const double to = static_cast<double>(group.first_column + kLanes * stride_.columns) + reach;
        const auto count = static_cast<std::int64_t>(coarse_.column_count);
        auto first = static_cast<std::int64_t>(std::floor(from / side)) - (from < 0.0 ? 1 : 0);
        auto last = static_cast<std::int64_t>(std::floor(to / side)) + (to >= columns ? 1 : 0);
        if (last - first + 1 >= count) {
            first = 0;
            last = count - 1;
        }
        const std::size_t base = row * coarse_.column_count;
        for (std::int64_t begin = first; begin <= last;) {
            const std::int64_t wrapped = (begin % count + count) % count;
            const std::int64_t run = std::min(last - begin + 1, count - wrapped);
            for (std::int64_t k = 0; k < run; ++k)
                group.excess[static_cast<std::size_t>(k)] =
                    excess_of<kShape>(tool_, view, coarse_, base + static_cast<std::size_t>(wrapped + k));
            for (std::int64_t k = 0; k < run; ++k) {
                if (group.excess[static_cast<std::size_t>(k)] <= 0.0F)
                    group.coarse.push_back({row, static_cast<std::size_t>(wrapped + k),
                                            group.excess[static_cast<std::size_t>(k)]});
            }
            begin += run;
        }
    }
    std::sort(group.coarse.begin(), group.coarse.end(),
              [](const Seat& a, const Seat& b) { return a.excess < b.excess; });
    for (const Seat seat : group.coarse) seek_fine<kShape>(group, view, seat);
}

template <Shape kShape>
void DilationWork::seek_fine(Group& group, const View<float>& view, Seat coarse) const {
    constexpr std::size_t kPerSide = kCoarseSide / kFineSide;
    const std::size_t row_end = std::min(fine_.row_count, (coarse.row + 1) * kPerSide);
    const std::size_t first = coarse.column * kPerSide;
    const std::size_t count = std::min(kPerSide, fine_.column_count - first);
    for (std::size_t row = coarse.row * kPerSide; row < row_end; ++row) {
        std::array<float, kPerSide> excess{};
        for (std::size_t k = 0; k < count; ++k)
            excess[k] = excess_of<kShape>(tool_, view, fine_, row * fine_.column_count + first + k);
        for (std::size_t k = 0; k < count; ++k) {
            if (excess[k] <= 0.0F) touch<kShape>(group, {row, first + k});
        }
    }
}

void run_dilation(DilationWork& work, unsigned thread_count) {
    std::vector<std::thread> threads;
    try {
        for (std::size_t i = 1; i < std::min<std::size_t>(thread_count, work.block_count()); ++i)
            threads.emplace_back([&work] { work.run_shape(false); });
    } catch (const std::system_error&) {
        // A thread that the system does not give: this one does its work.
    }
    work.run_shape(true);
    for (std::thread& thread : threads) thread.join();
}

}  // namespace

Result<std::vector<float>> dilated(const SampledRadii& surface, const Tool& tool, Stride stride,
                                   double allowance, const slice::SliceOptions& options) {
    try {
        std::vector<float> tips(surface.radius.size(), 0.0F);
        if (tool.shape == Shape::vee) stride = {1, 1};
        const Tool searched = widened(surface, tool, stride);
        const unsigned threads = std::max(1U, options.thread_count);
        DilationWork work(surface, searched, stride, tips, threads, options.progress);
        run_dilation(work, threads);
        if (work.is_cancelled())
            return Error{ErrorCode::cancelled, "the tool's way over the samples was cancelled"};
        fill_gaps(surface, searched, stride, tips);
        for (float& tip : tips) tip += static_cast<float>(allowance);
        return tips;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory for the tool's way over so many samples"};
    }
}

}  // namespace psicarve::tool
