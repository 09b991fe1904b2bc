// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/piece/tool_way.hpp"
#include "hmi/replay/trace_index.hpp"

namespace psicarve::replay {

/// The places and times at which a tool that has a size cut, and the stock at some of these times: the piece
/// at any time is one of these with the places behind it cut. Made once, on a thread of its own.
class ToolTimeline {
public:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;
    /// With more places, every other one is left out, as often as needed: the way between two is cut
    /// straight. Each stretch keeps its ends, unless there are so many stretches that these alone are too
    /// many.
    static constexpr std::size_t kMostPlaces = 1'500'000;

    /// The axes' places while the spindle was on.
    static Result<std::shared_ptr<const ToolTimeline>> of_trace(const JobPointer& job,
                                                                std::shared_ptr<const TraceIndex> index,
                                                                const Progress& progress,
                                                                std::size_t most_places = kMostPlaces);
    /// The job's plan: its layer n, of any pass, is there from time n + 1 on.
    static Result<std::shared_ptr<const ToolTimeline>> of_job(const JobPointer& job, const Progress& progress,
                                                              std::size_t most_places = kMostPlaces);

    std::size_t place_count() const noexcept { return places_.size(); }
    /// How many places there are up to and with this time.
    std::size_t places_until(std::int64_t time) const noexcept;
    const piece::StockMap& blank() const noexcept { return kept_.front(); }

private:
    friend class PieceInTime;
    struct Place {
        std::int64_t time;
        std::int64_t psi_pulses;
        std::int64_t y_pulses;
        std::int32_t r1_pulses;
        std::int32_t r2_pulses;
    };

    ToolTimeline(JobPointer job, const verify::JobGeometry& geometry, std::size_t most_places);
    static Result<std::shared_ptr<ToolTimeline>> empty(const JobPointer& job, std::size_t most_places);
    void add(std::int64_t time, const verify::Positions& at);
    void push(Place place);
    void thin();
    void drop_every_other(bool keeps_ends);
    /// Ends a stretch: the next place is not joined to the last one, which is kept.
    void end_stretch();
    void lift();
    Result<void> keep_pieces(const Progress& progress);
    verify::Positions positions(std::size_t place) const noexcept;

    JobPointer job_;
    verify::JobGeometry geometry_;
    std::size_t most_places_;
    std::vector<Place> places_;
    std::vector<std::uint8_t> is_joined_;  ///< by place: straight from the one before
    bool is_lifted_ = true;
    std::size_t stride_ = 1;
    std::size_t left_out_ = 0;           ///< since the last place
    std::optional<Place> skipped_;       ///< the last place left out
    verify::Positions last_{};           ///< the last place, kept or left out
    std::size_t kept_every_ = 1;         ///< one stock for this many places
    std::vector<piece::StockMap> kept_;  ///< the piece behind 0, kept_every_, 2 * kept_every_ .. places
    piece::ToolWay way_;
};

/// A piece that moves along a timeline, either way. Its state at a time depends on that time alone.
class PieceInTime {
public:
    explicit PieceInTime(std::shared_ptr<const ToolTimeline> timeline);

    /// Moves towards a time by `most` places at most, and asks `goes_on` before each. True when it is there.
    bool go(std::int64_t time, std::size_t most, const std::function<bool()>& goes_on = {});
    /// The number of places that are cut.
    std::size_t place_count() const noexcept { return places_; }
    const piece::StockMap& stock() const noexcept { return stock_; }

private:
    friend class ToolTimeline;
    explicit PieceInTime(const ToolTimeline& timeline);
    void put(std::size_t kept);
    void cut(std::size_t place);
    void settle(const verify::Positions& at);

    std::shared_ptr<const ToolTimeline> owner_;
    const ToolTimeline& timeline_;
    piece::StockMap stock_;
    std::optional<piece::PieceCarver> carver_;
    std::size_t places_ = 0;  ///< the number that are cut
};

}  // namespace psicarve::replay
