// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/tool_offset.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "hmi/tool/column_ranges.hpp"
#include "hmi/tool/contact.hpp"
#include "hmi/tool/contact_parts.hpp"

namespace psicarve::tool {
namespace {

// This many columns are filled at once: their tips stay in the cache while all parts go by.
constexpr std::size_t kColumnsAtOnce = 32;

template <typename Part>
struct Placed {
    std::vector<Part> parts;
    std::vector<ColumnRanges> columns;  ///< one entry a part

    Placed(std::vector<Part> all, const ColumnFinder& finder) : parts(std::move(all)) {
        columns.reserve(parts.size());
        for (const Part& part : parts) columns.push_back(finder.of(part));
    }
};

class OffsetWork {
public:
    OffsetWork(const ContactParts& parts, const Tool& tool, const TipPlaces& places,
               std::vector<double>& tips, const slice::Progress& progress)
        : places_(places),
          contact_(tool),
          facets_(parts.facets, ColumnFinder(places.direction_rad, tool.radius)),
          edges_(parts.edges, ColumnFinder(places.direction_rad, tool.radius)),
          tips_(tips),
          progress_(progress),
          block_count_((places.direction_rad.size() + kColumnsAtOnce - 1) / kColumnsAtOnce) {}

    std::size_t block_count() const noexcept { return block_count_; }
    bool is_cancelled() const noexcept { return is_cancelled_; }

    /// Takes block after block until none is left. Only one thread reports the progress: before each block,
    /// so that it asks at least once, whatever the others have done by then.
    void run(bool tells) {
        for (;;) {
            if (tells) tell();
            const std::size_t block = next_block_.fetch_add(1);
            if (block >= block_count_ || is_cancelled_) return;
            fill(block * kColumnsAtOnce,
                 std::min((block + 1) * kColumnsAtOnce, places_.direction_rad.size()));
            blocks_done_.fetch_add(1);
        }
    }

private:
    void tell() {
        const double share = static_cast<double>(blocks_done_) / static_cast<double>(block_count_);
        if (progress_ && !progress_(share)) is_cancelled_ = true;
    }

    Column column(std::size_t index) const {
        const bool is_shared = places_.heights.size() == places_.row_count;
        const std::size_t at = index * places_.row_count;
        return {std::cos(places_.direction_rad[index]), std::sin(places_.direction_rad[index]),
                places_.heights.subspan(is_shared ? 0 : at, places_.row_count),
                std::span(tips_).subspan(at, places_.row_count)};
    }

    void fill(std::size_t first, std::size_t end) {
        std::vector<Column> columns;
        for (std::size_t i = first; i < end; ++i) columns.push_back(column(i));
        touch(facets_, first, columns);
        touch(edges_, first, columns);
    }

    template <typename Part>
    void touch(const Placed<Part>& placed, std::size_t first, const std::vector<Column>& columns) const {
        const std::size_t end = first + columns.size();
        for (std::size_t i = 0; i < placed.parts.size(); ++i) {
            const ColumnRanges& ranges = placed.columns[i];
            for (std::size_t k = 0; k < 2; ++k) {
                const std::size_t stop = std::min<std::size_t>(end, ranges.end[k]);
                for (std::size_t c = std::max<std::size_t>(first, ranges.first[k]); c < stop; ++c) {
                    contact_.touch(placed.parts[i], columns[c - first]);
                }
            }
        }
    }

    const TipPlaces& places_;
    Contact contact_;
    Placed<Facet> facets_;
    Placed<Edge> edges_;
    std::vector<double>& tips_;
    const slice::Progress& progress_;
    std::size_t block_count_;
    std::atomic<std::size_t> next_block_{0};
    std::atomic<std::size_t> blocks_done_{0};
    std::atomic<bool> is_cancelled_{false};
};

void run_on_threads(OffsetWork& work, unsigned thread_count) {
    std::vector<std::thread> threads;
    try {
        for (std::size_t i = 1; i < std::min<std::size_t>(thread_count, work.block_count()); ++i) {
            threads.emplace_back([&work] { work.run(false); });
        }
    } catch (const std::system_error&) {
        // This thread does the work of one that the system does not give.
    }
    work.run(true);
    for (std::thread& thread : threads) thread.join();
}

}  // namespace

Result<std::vector<double>> tip_radii(const model::Mesh& mesh, const slice::Placement& placement,
                                      const Tool& tool, const TipPlaces& places,
                                      const slice::SliceOptions& options) {
    try {
        std::vector<double> tips(places.direction_rad.size() * places.row_count, 0.0);
        OffsetWork work(contact_parts(mesh, placement), tool, places, tips, options.progress);
        run_on_threads(work, std::max(1U, options.thread_count));
        if (work.is_cancelled())
            return Error{ErrorCode::cancelled, "the tool's way round the model was cancelled"};
        return tips;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room,
                     "not enough memory for the tool's way round " + mesh.source_name};
    }
}

}  // namespace psicarve::tool
