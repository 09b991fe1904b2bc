// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/tool_timeline.hpp"

#include <algorithm>
#include <utility>

#include "hmi/replay/trace_cursor.hpp"

namespace psicarve::replay {
namespace {

constexpr std::size_t kKeptCells = 16'000'000;  // of all pieces that are kept: 64 MB
constexpr std::size_t kMostKept = 48;
constexpr std::size_t kLeastBetween = 2'000;  // places: cut in a few milliseconds
constexpr int kReadParts = 200;
constexpr double kReadShare = 0.3;
// Places on a way inside the blank are nearer to each other.
constexpr double kMostApart_cells = 1.0;

Error was_cancelled() {
    return Error{ErrorCode::cancelled, "the carving view was cancelled"};
}

bool goes_on(const Progress& progress, double done) {
    return !progress || progress(done);
}

}  // namespace

ToolTimeline::ToolTimeline(JobPointer job, const verify::JobGeometry& geometry, std::size_t most_places)
    : job_(std::move(job)),
      geometry_(geometry),
      most_places_(std::max<std::size_t>(most_places, 2)),
      kept_{piece::view_blank_of(geometry, job_->profile, piece::kViewColumns)},
      way_(geometry, kept_.front()) {}

Result<std::shared_ptr<ToolTimeline>> ToolTimeline::empty(const JobPointer& job, std::size_t most_places) {
    const auto geometry = verify::JobGeometry::make(job->view, job->profile);
    if (!geometry) return geometry.error();
    return std::shared_ptr<ToolTimeline>{new ToolTimeline{job, *geometry, most_places}};
}

Result<std::shared_ptr<const ToolTimeline>> ToolTimeline::of_trace(const JobPointer& job,
                                                                   std::shared_ptr<const TraceIndex> index,
                                                                   const Progress& progress,
                                                                   std::size_t most_places) {
    auto made = empty(job, most_places);
    if (!made) return made.error();
    ToolTimeline& timeline = **made;
    const std::int64_t end_ns = index->end_ns();
    TraceCursor cursor{std::move(index)};
    // All pulses of an instant belong together: a place counts when time goes on from it.
    const auto visit = [&](const PinMoment& before, const PinMoment& after) {
        if ((before.levels & bit_of(Signal::spindle)) == 0) return timeline.lift();
        if (after.time_ns == before.time_ns) return;
        timeline.way_.go(before.position_pulses,
                         [&](const verify::Positions& at) { timeline.add(before.time_ns, at); });
    };
    for (int part = 1; part <= kReadParts; ++part) {
        const auto moment =
            cursor.go_on(end_ns / kReadParts * part + (part == kReadParts ? end_ns % kReadParts : 0), visit);
        if (!moment) return moment.error();
        if (!goes_on(progress, kReadShare * part / kReadParts)) return was_cancelled();
    }
    if (const auto kept = timeline.keep_pieces(progress); !kept) return kept.error();
    return std::shared_ptr<const ToolTimeline>{std::move(*made)};
}

Result<std::shared_ptr<const ToolTimeline>> ToolTimeline::of_job(const JobPointer& job,
                                                                 const Progress& progress,
                                                                 std::size_t most_places) {
    auto made = empty(job, most_places);
    if (!made) return made.error();
    ToolTimeline& timeline = **made;
    const std::uint32_t layers = timeline.geometry_.layer_count();
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        timeline.lift();
        timeline.way_.go_layer(layer, timeline.geometry_.point_count(), [&](const verify::Positions& at) {
            timeline.add(std::int64_t{layer} + 1, at);
        });
        if (!goes_on(progress, kReadShare * (layer + 1) / layers)) return was_cancelled();
    }
    if (const auto kept = timeline.keep_pieces(progress); !kept) return kept.error();
    return std::shared_ptr<const ToolTimeline>{std::move(*made)};
}

void ToolTimeline::add(std::int64_t time, const verify::Positions& at) {
    // Ways outside the blank are not reported, and nothing was cut on them.
    if (!is_lifted_ && way_.cells_between(last_, at) > kMostApart_cells) end_stretch();
    last_ = at;
    const Place place{time, at[index_of(Axis::psi)], at[index_of(Axis::y)],
                      static_cast<std::int32_t>(at[index_of(Axis::r1)]),
                      static_cast<std::int32_t>(at[index_of(Axis::r2)])};
    if (!is_lifted_ && ++left_out_ < stride_) {
        skipped_ = place;
    } else {
        push(place);
    }
}

void ToolTimeline::push(Place place) {
    if (places_.size() >= most_places_) thin();
    left_out_ = 0;
    skipped_.reset();
    places_.push_back(place);
    is_joined_.push_back(std::exchange(is_lifted_, false) ? 0 : 1);
}

void ToolTimeline::thin() {
    drop_every_other(true);
    if (places_.size() > most_places_ / 4 * 3) drop_every_other(false);
    stride_ = std::min(2 * stride_, most_places_);
}

/// The place behind a dropped begin of a stretch becomes its begin: the place before is never joined to the
/// next stretch.
void ToolTimeline::drop_every_other(bool keeps_ends) {
    std::size_t kept = 0;
    bool is_begin_dropped = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const bool is_begin = is_joined_[i] == 0;
        const bool is_end = i + 1 == places_.size() || is_joined_[i + 1] == 0;
        if (i % 2 == 1 && !(keeps_ends && (is_begin || is_end))) {
            is_begin_dropped = is_begin;
            continue;
        }
        places_[kept] = places_[i];
        is_joined_[kept++] = is_begin || is_begin_dropped ? 0 : 1;
        is_begin_dropped = false;
    }
    places_.resize(kept);
    is_joined_.resize(kept);
}

void ToolTimeline::end_stretch() {
    if (skipped_) push(*skipped_);
    is_lifted_ = true;
}

void ToolTimeline::lift() {
    end_stretch();
    way_.lift();
}

verify::Positions ToolTimeline::positions(std::size_t place) const noexcept {
    verify::Positions at{};
    at[index_of(Axis::r1)] = places_[place].r1_pulses;
    at[index_of(Axis::r2)] = places_[place].r2_pulses;
    at[index_of(Axis::psi)] = places_[place].psi_pulses;
    at[index_of(Axis::y)] = places_[place].y_pulses;
    return at;
}

std::size_t ToolTimeline::places_until(std::int64_t time) const noexcept {
    const auto end = std::upper_bound(places_.begin(), places_.end(), time,
                                      [](std::int64_t t, const Place& place) { return t < place.time; });
    return static_cast<std::size_t>(end - places_.begin());
}

Result<void> ToolTimeline::keep_pieces(const Progress& progress) {
    end_stretch();
    const std::size_t cells = blank().row_count() * blank().column_count();
    const std::size_t most = std::clamp<std::size_t>(kKeptCells / cells, 2, kMostKept);
    kept_every_ = std::max(kLeastBetween, places_.size() / most + 1);
    kept_.reserve(places_.size() / kept_every_ + 1);
    PieceInTime piece{*this};
    for (std::size_t end = kept_every_; end <= places_.size(); end += kept_every_) {
        while (piece.places_ < end) piece.cut(piece.places_);
        piece.carver_->finish();
        kept_.push_back(piece.stock_);
        const double done = static_cast<double>(end) / static_cast<double>(places_.size());
        if (!goes_on(progress, kReadShare + (1.0 - kReadShare) * done)) return was_cancelled();
    }
    return {};
}

PieceInTime::PieceInTime(const ToolTimeline& timeline) : timeline_(timeline), stock_(timeline.blank()) {
    put(0);
}

PieceInTime::PieceInTime(std::shared_ptr<const ToolTimeline> timeline)
    : owner_(std::move(timeline)), timeline_(*owner_), stock_(timeline_.blank()) {
    put(0);
}

void PieceInTime::put(std::size_t kept) {
    stock_ = timeline_.kept_[kept];
    places_ = kept * timeline_.kept_every_;
    // A carver keeps the greatest radius of its cells.
    carver_.emplace(timeline_.geometry_, timeline_.job_->profile, stock_);
}

/// Each place by itself, so that the result does not depend on where an earlier call stopped.
void PieceInTime::settle(const verify::Positions& at) {
    carver_->settle(at, true);
    carver_->settle({}, false);
}

void PieceInTime::cut(std::size_t place) {
    const verify::Positions to = timeline_.positions(place);
    if (timeline_.is_joined_[place] == 0) {
        settle(to);
    } else {
        timeline_.way_.between(timeline_.positions(place - 1), to,
                               [this](const verify::Positions& at) { settle(at); });
    }
    places_ = place + 1;
}

bool PieceInTime::go(std::int64_t time, std::size_t most, const std::function<bool()>& goes_on) {
    const std::size_t wanted = timeline_.places_until(time);
    const std::size_t nearest = std::min(wanted / timeline_.kept_every_, timeline_.kept_.size() - 1);
    if (wanted < places_ || nearest * timeline_.kept_every_ > places_) put(nearest);
    const std::size_t end = wanted - places_ > most ? places_ + most : wanted;
    while (places_ < end && (!goes_on || goes_on())) cut(places_);
    carver_->finish();
    return places_ == wanted;
}

}  // namespace psicarve::replay
