// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/replay/trace_index.hpp"
#include "hmi/scene/carving_record.hpp"

namespace psicarve::replay {

/// Which cell of the surface became how deep, and when: the piece at any time, forwards and backwards,
/// without the trace. Made once, on a thread of its own.
class CarvingTimeline {
public:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;
    static constexpr std::size_t kMostCuts = 8'000'000;

    /// What the pins carved while the spindle was on.
    static Result<std::shared_ptr<const CarvingTimeline>> of_trace(const JobPointer& job,
                                                                   std::shared_ptr<const TraceIndex> index,
                                                                   const Progress& progress);
    /// As planned: the job's layer n is there from time n + 1 on. For recordings that hold no pulses.
    static Result<std::shared_ptr<const CarvingTimeline>> of_job(const JobPointer& job,
                                                                 const Progress& progress);

    /// Takes the record, which stands behind the first `from` cuts, towards a time, by so many cuts at most.
    /// How many are in it now. A fresh record stands behind 0.
    std::size_t apply(session::CarvingRecord& record, std::size_t from, std::int64_t time,
                      std::size_t most) const;
    /// Nothing is left to be done to show that time.
    bool is_applied(std::size_t from, std::int64_t time) const noexcept {
        return (from == time_.size() || time_[from] > time) && (from == 0 || time_[from - 1] <= time);
    }
    /// When the layer's first cut was made; nothing when none was.
    std::optional<std::int64_t> begin_of_layer(std::int64_t layer) const noexcept;
    std::size_t cuts() const noexcept { return time_.size(); }
    /// False: there were more cuts than are kept, and the last are missing.
    bool is_whole() const noexcept { return is_whole_; }

private:
    friend class CutWriter;
    CarvingTimeline() = default;

    // One array each: 20 bytes a cut. Cells are layer * directions + direction.
    std::vector<std::int64_t> time_;
    std::vector<std::uint32_t> cell_;
    std::vector<float> before_mm_;
    std::vector<float> after_mm_;
    std::vector<std::int64_t> layer_begin_;  ///< by layer; -1: never cut
    std::uint32_t directions_ = 1;
    bool is_whole_ = true;
};

}  // namespace psicarve::replay
