// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/live_piece.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::session {
namespace {

// No machine turns or rises that far from one increment to the next: some are missing between them.
constexpr double kMostCells = 8.0;
constexpr std::size_t kEntriesToAsk = 512;  // whether to go on

verify::Positions positions_of(const IncrementEntry& entry) noexcept {
    verify::Positions at{};
    at[index_of(Axis::r1)] = entry.r1_pulses;
    at[index_of(Axis::r2)] = entry.r2_pulses;
    at[index_of(Axis::psi)] = entry.psi_pulses;
    at[index_of(Axis::y)] = entry.y_pulses;
    return at;
}

}  // namespace

LivePiece::LivePiece(std::shared_ptr<const cam::PreparedJob> job, const verify::JobGeometry& geometry,
                     std::size_t columns)
    : job_(std::move(job)),
      layer_count_(job_->view.layer_count()),
      point_count_(job_->view.point_count()),
      layers_(layer_count_, Seen::yes),
      stock_(piece::view_blank_of(geometry, job_->profile, columns)),
      carver_(geometry, job_->profile, stock_),
      way_(geometry, stock_),
      front_(stock_) {}

LivePiece::~LivePiece() {
    is_dropped_.store(true);
}

void LivePiece::look(const Look& now) {
    queue_.deliver();
    const auto layer =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(now.points_done / point_count_, layer_count_));
    if (!has_looked_) {
        // Earlier motion is not among the increments, or only its end is.
        has_looked_ = true;
        const auto steps = static_cast<std::uint32_t>(now.points_done % point_count_);
        if (layer > 0) mark_unseen(0, layer - 1);
        if (steps > 0) mark_unseen(layer, layer);
        post_unseen(layer);
        if (steps > 0) post_layer(layer, steps);
        layer_before_ = layer;
    }
    const bool is_too_much = waiting_.load() + told_.size() > kMostWaiting;
    if (is_too_much) {
        told_.clear();
        for (std::uint32_t i = layer_before_; i < layer; ++i) skipped_layers_ += layers_[i] == Seen::yes;
    }
    if (now.has_lost || is_too_much || has_gap_) mark_unseen(std::min(layer_before_, layer), layer);
    // The next look says how far the machine was when the last of the lost ones was reported.
    has_gap_ = now.has_lost || is_too_much;
    layer_before_ = layer;
    hand_over();
    post_unseen(layer);
}

void LivePiece::hand_over() {
    if (told_.empty()) return;
    waiting_ += told_.size();
    queue_.post([this, entries = std::exchange(told_, {})]() -> BackgroundQueue::Finish {
        cut(entries);
        waiting_ -= entries.size();
        show();
        return {};
    });
}

void LivePiece::mark_unseen(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t layer = first; layer <= last && layer < layer_count_; ++layer) {
        if (layers_[layer] == Seen::yes) layers_[layer] = Seen::no;
    }
}

void LivePiece::post_unseen(std::uint32_t end) {
    for (std::uint32_t layer = 0; layer < end; ++layer) {
        if (layers_[layer] != Seen::no) continue;
        layers_[layer] = Seen::cut;
        post_layer(layer, point_count_);
    }
}

void LivePiece::post_layer(std::uint32_t layer, std::uint32_t end_step) {
    ++layers_to_come_;
    queue_.post([this, layer, end_step]() -> BackgroundQueue::Finish {
        way_.go_layer(layer, end_step, [this](const verify::Positions& at) { settle(at); });
        last_.reset();
        --layers_to_come_;
        show();
        return {};
    });
}

void LivePiece::cut(const std::vector<IncrementEntry>& entries) {
    std::size_t count = 0;
    for (const IncrementEntry& entry : entries) {
        if (++count % kEntriesToAsk == 0 && is_dropped_.load()) return;
        const verify::Positions at = positions_of(entry);
        if (!last_ || way_.cells_between(*last_, at) > kMostCells) way_.lift();
        last_ = at;
        way_.go(at, [this](const verify::Positions& place) { settle(place); });
    }
}

/// Following the way to the remaining places is cheap; cutting them is not.
void LivePiece::settle(const verify::Positions& at) {
    if (is_dropped_.load()) return;
    carver_.settle(at, true);
    ++*places_cut_;
}

/// As often as a view may look, or when nothing is left to do.
void LivePiece::show() {
    constexpr std::chrono::milliseconds kPauseBetweenLooks{40};
    if (is_dropped_.load()) return;
    const auto now = std::chrono::steady_clock::now();
    const bool is_last = waiting_.load() == 0 && layers_to_come_.load() == 0;
    if (!is_last && now - shown_ < kPauseBetweenLooks) return;
    shown_ = now;
    carver_.finish();
    front_.publish(stock_);
}

void LivePiece::finish() {
    queue_.finish();
    queue_.deliver();
}

}  // namespace psicarve::session
