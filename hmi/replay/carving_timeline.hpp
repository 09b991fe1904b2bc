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

/// The depth of each cell of the surface over time: gives the piece at any time, forwards and backwards,
/// without the trace. Made once, on a thread of its own.
class CarvingTimeline {
public:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;
    static constexpr std::size_t kMostCuts = 8'000'000;

    /// The cuts that the pins made while the spindle was on.
    static Result<std::shared_ptr<const CarvingTimeline>> of_trace(const JobPointer& job,
                                                                   std::shared_ptr<const TraceIndex> index,
                                                                   const Progress& progress);
    /// The job's plan: its layer n is there from time n + 1 on. For recordings that hold no pulses.
    static Result<std::shared_ptr<const CarvingTimeline>> of_job(const JobPointer& job,
                                                                 const Progress& progress);

    /// Moves the record, which contains the first `from` cuts, towards a time, by `most` cuts at most.
    /// Returns how many cuts it contains now. A fresh record contains 0.
    std::size_t apply(session::CarvingRecord& record, std::size_t from, std::int64_t time,
                      std::size_t most) const;
    /// Whether the record shows that time already.
    bool is_applied(std::size_t from, std::int64_t time) const noexcept {
        return (from == time_.size() || time_[from] > time) && (from == 0 || time_[from - 1] <= time);
    }
    /// The time of the layer's first cut; nothing when there was none.
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
