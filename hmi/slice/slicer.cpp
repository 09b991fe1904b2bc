// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/slicer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <system_error>
#include <thread>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/layer_buckets.hpp"
#include "hmi/slice/layer_scan.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/spiral_scan.hpp"
#include "shared/base/result.hpp"

namespace psicarve::slice {
namespace {

/// Heights at which rows begin and end, in stored coordinates; the same twice where a row is a flat layer.
struct Rows {
    std::vector<double> bottoms;
    std::vector<double> tops;

    std::size_t count() const noexcept { return tops.size(); }
};

/// The data that the threads share. Layers are split into one range a thread; a layer's cells belong to one
/// thread.
struct Work {
    const model::TriangleList& triangles;
    const LayerBuckets& buckets;
    const Rows& rows;
    FacetCutter cutter;
    const LayerSink& sink;
    std::vector<LayerTotals>& totals;
    std::atomic<std::size_t> layers_done{0};
    std::atomic<bool> cancelled{false};
};

/// One thread's range of layers, everything it needs allocated before the thread starts.
class RangeWorker {
public:
    RangeWorker(Work& work, const Directions& directions, std::size_t first, std::size_t end)
        : work_(work), scan_(directions), first_(first), end_(end) {
        if (work.rows.tops != work.rows.bottoms) spiral_.emplace(directions);
        const auto& counts = work.buckets.cut_counts();
        const auto begin = counts.begin() + static_cast<std::ptrdiff_t>(first);
        const auto stop = counts.begin() + static_cast<std::ptrdiff_t>(end);
        carried_.reserve(first == end ? 0 : *std::max_element(begin, stop));
    }

    void run(const Progress* progress) noexcept {
        // Facets that begin below the range and reach into it, in the order a walk from below would have.
        for (std::size_t layer = 0; layer < first_; ++layer) carry(layer, first_);
        for (std::size_t layer = first_; layer < end_; ++layer) {
            if (work_.cancelled.load(std::memory_order_relaxed)) return;
            cut(layer);
            const std::size_t done = 1 + work_.layers_done.fetch_add(1, std::memory_order_relaxed);
            if (progress != nullptr && *progress &&
                !(*progress)(static_cast<double>(done) / static_cast<double>(work_.rows.count()))) {
                work_.cancelled.store(true, std::memory_order_relaxed);
            }
        }
    }

private:
    void carry(std::size_t layer, std::size_t into) noexcept {
        for (const CutFacet& t : work_.buckets.starting_in(layer)) {
            if (t.end_layer > into) carried_.push_back(t);
        }
    }

    template <typename Draw>
    void for_each(std::span<const CutFacet> facets, const Draw& draw) noexcept {
        constexpr std::size_t kAhead = 8;  // facets of a layer lie anywhere in the mesh's memory
        for (std::size_t i = 0; i < facets.size(); ++i) {
            if (i + kAhead < facets.size()) __builtin_prefetch(&work_.triangles[facets[i + kAhead].facet]);
            draw(work_.triangles[facets[i].facet]);
        }
    }
    template <typename Draw>
    void for_each_in(std::size_t layer, const Draw& draw) noexcept {
        for_each(carried_, draw);
        for_each(work_.buckets.starting_in(layer), draw);
    }

    void cut(std::size_t layer) noexcept {
        const double bottom = work_.rows.bottoms[layer];
        const double top = work_.rows.tops[layer];
        const bool rises = spiral_ && bottom != top;
        if (!rises) {
            std::array<SectionSegment, LayerScan::kMostAtOnce> cuts;
            std::size_t count = 0;
            for_each_in(layer, [&](const model::Triangle& t) {
                cuts[count++] = work_.cutter.cut(t, top);
                if (count < cuts.size()) return;
                scan_.add_segments(cuts);
                count = 0;
            });
            scan_.add_segments(std::span(cuts).first(count));
        } else {
            spiral_->begin_row(layer, bottom, top);
            for_each_in(layer, [&](const model::Triangle& t) { spiral_->add(work_.cutter, t, scan_); });
        }
        const std::uint32_t open_cells = rises ? spiral_->open_cells(scan_) : 0;
        work_.totals[layer] = scan_.finish();
        if (rises) work_.totals[layer].open_cells = open_cells;
        work_.sink(LayerSection{layer, scan_.radius(), scan_.wall_counts(), &work_.totals[layer]});
        std::erase_if(carried_, [layer](const CutFacet& t) { return t.end_layer <= layer + 1; });
        carry(layer, layer + 1);
    }

    Work& work_;
    LayerScan scan_;
    std::optional<SpiralScan> spiral_;  ///< where rows rise
    std::size_t first_;
    std::size_t end_;
    std::vector<CutFacet> carried_;
};

/// Ends of one range of layers for each thread, about the same number of cuts in each.
std::vector<std::size_t> split_layers(const std::vector<std::uint32_t>& cut_counts, std::size_t parts,
                                      std::size_t direction_count) {
    const std::uint64_t fixed = direction_count / 8;  // clearing and reading a layer's cells
    std::uint64_t total = fixed * cut_counts.size();
    total = std::accumulate(cut_counts.begin(), cut_counts.end(), total);
    std::vector<std::size_t> ends;
    std::uint64_t sum = 0;
    for (std::size_t layer = 0; layer < cut_counts.size(); ++layer) {
        sum += cut_counts[layer] + fixed;
        while (ends.size() + 1 < parts && sum * parts >= total * (ends.size() + 1)) ends.push_back(layer + 1);
    }
    ends.resize(parts, cut_counts.size());
    return ends;
}

void run_workers(std::vector<RangeWorker>& workers, const Progress& progress) {
    std::vector<std::thread> threads;
    std::vector<RangeWorker*> left;  // this thread does the work of one that the system does not give
    for (std::size_t i = 1; i < workers.size(); ++i) {
        try {
            threads.emplace_back([worker = &workers[i]] { worker->run(nullptr); });
        } catch (const std::system_error&) {
            left.push_back(&workers[i]);
        }
    }
    workers.front().run(&progress);
    for (RangeWorker* worker : left) worker->run(&progress);
    for (std::thread& thread : threads) thread.join();
}

Result<std::vector<LayerTotals>> slice_rows(const model::Mesh& mesh, const Placement& placement, Rows rows,
                                            const Directions& directions, const LayerSink& sink,
                                            const SliceOptions& options) {
    const auto origin = placed(placement.up, mesh.origin);
    for (double& height : rows.bottoms) height -= origin[2];
    for (double& height : rows.tops) height -= origin[2];
    const LayerBuckets buckets(mesh.triangles, placement.up, rows.bottoms, rows.tops);
    std::vector<LayerTotals> totals(rows.count());
    const FacetCutter cutter(placement.up, placement.axis_x - origin[0], placement.axis_y - origin[1]);
    Work work{mesh.triangles, buckets, rows, cutter, sink, totals, {}, {}};
    const std::size_t parts =
        std::clamp<std::size_t>(options.thread_count, 1, std::max<std::size_t>(1, rows.count()));
    std::vector<RangeWorker> workers;
    workers.reserve(parts);
    std::size_t first = 0;
    for (const std::size_t end : split_layers(buckets.cut_counts(), parts, directions.count())) {
        workers.emplace_back(work, directions, first, end);
        first = end;
    }
    run_workers(workers, options.progress);
    if (work.cancelled) return Error{ErrorCode::cancelled, "slicing was cancelled"};
    return totals;
}

/// Rows of a spiral: a ring, one row from each layer's height to the next, a ring.
Rows spiral_rows(std::span<const double> heights) {
    Rows rows;
    if (heights.empty()) return rows;
    rows.bottoms.push_back(heights.front());
    rows.bottoms.insert(rows.bottoms.end(), heights.begin(), heights.end());
    rows.tops.assign(heights.begin(), heights.end());
    rows.tops.push_back(heights.back());
    if (heights.size() > 1) return rows;
    rows.bottoms.pop_back();
    rows.tops.pop_back();
    return rows;
}

}  // namespace

Result<std::vector<LayerTotals>> slice_layers(const model::Mesh& mesh, const Placement& placement,
                                              std::span<const double> heights, const Directions& directions,
                                              const LayerSink& sink, const SliceOptions& options) {
    try {
        const std::vector<double> flat(heights.begin(), heights.end());
        return slice_rows(mesh, placement, Rows{flat, flat}, directions, sink, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory to slice " + mesh.source_name};
    }
}

Result<std::vector<LayerTotals>> slice_spiral(const model::Mesh& mesh, const Placement& placement,
                                              std::span<const double> heights, const Directions& directions,
                                              const LayerSink& sink, const SliceOptions& options) {
    try {
        return slice_rows(mesh, placement, spiral_rows(heights), directions, sink, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory to slice " + mesh.source_name};
    }
}

Result<RadialMap> radial_map(const model::Mesh& mesh, const Placement& placement,
                             std::span<const double> heights, const Directions& directions,
                             const SliceOptions& options) {
    RadialMap map;
    map.direction_count = directions.count();
    try {
        map.radius.resize(heights.size() * directions.count());
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory for so many layers and points"};
    }
    const auto store = [&map](const LayerSection& section) {
        std::copy(section.radius.begin(), section.radius.end(),
                  map.radius.begin() + static_cast<std::ptrdiff_t>(section.layer * map.direction_count));
    };
    auto totals = slice_layers(mesh, placement, heights, directions, store, options);
    if (!totals) return totals.error();
    map.layers = std::move(*totals);
    return map;
}

double undercut_share(std::span<const LayerTotals> layers) {
    double all = 0.0;
    double outer = 0.0;
    bool is_any_hidden = false;
    for (const LayerTotals& layer : layers) {
        all += layer.radius_sum;
        outer += layer.outer_sum;
        is_any_hidden = is_any_hidden || layer.hidden_walls > 0;
    }
    return is_any_hidden && all > 0.0 ? std::clamp((all - outer) / all, 0.0, 1.0) : 0.0;
}

std::vector<double> layer_heights(double bottom, double height, std::size_t count) {
    std::vector<double> heights(count);
    for (std::size_t i = 0; i < count; ++i) {
        heights[i] = bottom + (static_cast<double>(i) + 0.5) * height / static_cast<double>(count);
    }
    return heights;
}

}  // namespace psicarve::slice
