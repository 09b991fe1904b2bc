// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor/state_set.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::verify {

namespace {

using Side = ReachBoundary::Side;

constexpr std::size_t kThinAbove = 28;  ///< corners of both boundaries
constexpr double kThinPulses = 5e-4;
constexpr int kRestCorners = 12;

/// Reads a boundary at rising speeds.
class BoundaryWalk {
public:
    explicit BoundaryWalk(const ReachBoundary& boundary) : flank_(boundary) {}
    bool covers(double speed) const { return speed >= flank_.slowest() && speed <= flank_.fastest(); }
    double reach_at(double speed) {
        while (next_ + 1 < flank_.size() && flank_.speed(next_) < speed) ++next_;
        if (next_ == 0 || speed >= flank_.speed(next_)) return flank_.reach(next_);
        const double share =
            (speed - flank_.speed(next_ - 1)) / (flank_.speed(next_) - flank_.speed(next_ - 1));
        return flank_.reach(next_ - 1) + share * (flank_.reach(next_) - flank_.reach(next_ - 1));
    }

private:
    const ReachBoundary& flank_;
    std::size_t next_ = 0;
};

/// Whether the hull's boundary is nowhere further than `tolerance` beyond the two that it was made of. Looks
/// at all corners and half-way between them.
bool is_tight(const ReachBoundary& hull, const ReachBoundary& a, const ReachBoundary& b, double tolerance) {
    BoundaryWalk walk(hull);
    BoundaryWalk walk_a(a);
    BoundaryWalk walk_b(b);
    const auto fits = [&](double speed) {
        const double level = walk.reach_at(speed) - tolerance;
        return (walk_a.covers(speed) && walk_a.reach_at(speed) >= level) ||
               (walk_b.covers(speed) && walk_b.reach_at(speed) >= level);
    };
    double before = hull.slowest();
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        const bool is_of_a = j == b.size() || (i < a.size() && a.speed(i) <= b.speed(j));
        const double speed = is_of_a ? a.speed(i++) : b.speed(j++);
        if (!fits(0.5 * (before + speed)) || !fits(speed)) return false;
        before = speed;
    }
    return true;
}

/// A cheap test at the place where hulls usually stand out: half-way to the second slowest corner. True only
/// if `is_tight` would return false: the hull reaches at least as far as the straight line from its slowest
/// corner to any other.
bool is_loose_above_slowest(const ReachBoundary& a, const ReachBoundary& b, double tolerance) {
    constexpr double kLookMargin_pulses = 1e-6;
    if (a.slowest() != b.slowest() || a.size() < 2 || b.size() < 2) return false;
    if (std::max(a.size(), b.size()) > ReachBoundary::kMostExactlyJoined) return false;
    // After a run too short to change a speed two corners may have the same one: no line leads from one to
    // the other.
    if (a.speed(1) <= a.slowest() || b.speed(1) <= b.slowest()) return false;
    const double slowest = a.slowest();
    const double reach = std::max(a.reach(0), b.reach(0));
    const double way = 0.5 * (slowest + std::min(a.speed(1), b.speed(1))) - slowest;
    const auto rise_of = [&](const ReachBoundary& boundary) {
        const double rise = (boundary.reach(1) - boundary.reach(0)) / (boundary.speed(1) - slowest);
        return boundary.reach(0) + rise * way - reach;
    };
    const double rise =
        std::max(rise_of(a), rise_of(b)) + tolerance + kThinPulses + kLookMargin_pulses;  // that may be
    const auto stands_out = [&](const ReachBoundary& boundary) {
        for (std::size_t i = 1; i < boundary.size(); ++i) {
            if ((boundary.reach(i) - reach) * way > rise * (boundary.speed(i) - slowest)) return true;
        }
        return false;
    };
    return stands_out(a) || stands_out(b);
}

}  // namespace

StateSet StateSet::box(Range positions, Range speeds) {
    StateSet set;
    if (positions.is_empty() || speeds.is_empty()) return set;
    set.right_ = ReachBoundary(Side::right, speeds, positions.high);
    set.left_ = ReachBoundary(Side::left, speeds, -positions.low);
    return set;
}

// v^2 <= slowest^2 + 2a * (way from the room's low end)
StateSet StateSet::rest(Range room, double slowest, double fastest, double accel) {
    const double width = room.high - room.low;
    const double top = std::min(fastest, std::sqrt(slowest * slowest + 2.0 * accel * width));
    if (top <= slowest) return {};
    StateSet set = box(room, {slowest, top});
    ReachBoundary left(Side::left, {slowest, slowest}, -room.low);
    for (int i = 1; i <= kRestCorners; ++i) {
        const double speed = slowest + (top - slowest) * i / kRestCorners;
        const double way = (speed * speed - slowest * slowest) / (2.0 * accel);
        const ReachBoundary slower = left;
        left.join(slower, ReachBoundary(Side::left, {speed, speed}, -(room.low + std::min(way, width))));
    }
    set.left_ = left;
    set.left_.keep_speeds({slowest, top});
    set.right_.keep_speeds({slowest, top});
    return set;
}

void StateSet::run(double time_s, double accel, double ceiling) noexcept {
    right_.run(time_s, accel, ceiling);
    left_.run(time_s, accel, ceiling);
    thin();
}

void StateSet::jump(double jump) noexcept {
    right_.jump(jump);
    left_.jump(jump);
}

void StateSet::thin() noexcept {
    if (right_.size() + left_.size() <= kThinAbove) return;
    right_.thin(kThinPulses);
    left_.thin(kThinPulses);
}

void StateSet::keep(ReachBoundary& capped, ReachBoundary& opposite, double level) noexcept {
    if (is_empty() || !capped.reaches_beyond(level)) return;
    const Range speeds = opposite.speeds_reaching(-level);
    if (speeds.is_empty()) {
        *this = {};
        return;
    }
    keep_speeds(speeds);
    capped.cap(level);
}

void StateSet::keep_speeds(Range speeds) noexcept {
    if (is_empty()) return;
    if (speeds.low > fastest() || speeds.high < slowest()) {
        *this = {};
        return;
    }
    right_.keep_speeds(speeds);
    left_.keep_speeds(speeds);
}

bool StateSet::extend_slowest(Range row, double exact_from, double tolerance) noexcept {
    // Each boundary by itself adds only true states, so one may succeed without the other.
    return right_.extend_slowest(row.high, exact_from, tolerance) &&
           left_.extend_slowest(-row.low, exact_from, tolerance);
}

void StateSet::join(const StateSet& other) noexcept {
    if (other.is_empty()) return;
    if (is_empty()) {
        *this = other;
        return;
    }
    const StateSet mine = *this;
    right_.join(mine.right_, other.right_);
    left_.join(mine.left_, other.left_);
    thin();
}

bool StateSet::try_join(const StateSet& other, double tolerance) noexcept {
    if (is_empty() || other.is_empty()) {
        join(other);
        return true;
    }
    if (is_loose_above_slowest(left_, other.left_, tolerance) ||
        is_loose_above_slowest(right_, other.right_, tolerance))
        return false;
    StateSet hull;
    hull.right_.join(right_, other.right_);
    hull.left_.join(left_, other.left_);
    hull.thin();
    if (!is_tight(hull.left_, left_, other.left_, tolerance) ||
        !is_tight(hull.right_, right_, other.right_, tolerance))
        return false;
    *this = hull;
    return true;
}

}  // namespace psicarve::verify
