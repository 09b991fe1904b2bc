// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/replay_piece.hpp"

#include <utility>

namespace psicarve::replay {
namespace {

/// A few milliseconds' worth.
constexpr std::size_t kPlacesAtOnce = 1'000;

}  // namespace

ReplayPiece::ReplayPiece(std::shared_ptr<const ToolTimeline> timeline)
    : front_(timeline->blank()), piece_(std::move(timeline)) {}

ReplayPiece::~ReplayPiece() {
    is_dropped_.store(true);
}

void ReplayPiece::want(std::int64_t time) {
    queue_.deliver();
    if (has_wanted_ && wanted_.load() == time) return;
    has_wanted_ = true;
    wanted_.store(time);
    // The task under way sees the new request, but may just have come to its end.
    queue_.drop_waiting();
    queue_.post([this]() -> session::BackgroundQueue::Finish {
        follow();
        return {};
    });
}

void ReplayPiece::follow() {
    const auto goes_on = [this] { return !is_dropped_.load(); };
    while (goes_on()) {
        const bool is_there = piece_.go(wanted_.load(), kPlacesAtOnce, goes_on);
        if (!goes_on()) return;
        front_.publish(piece_.stock());
        if (is_there) return;
    }
}

}  // namespace psicarve::replay
