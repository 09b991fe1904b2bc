// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor/reach_boundary.hpp"

#include <algorithm>
#include <cstring>

namespace psicarve::verify {

namespace {
constexpr double kCoarse_pulses = 1e-2;  ///< what a boundary with too many corners may lose
}

ReachBoundary::ReachBoundary(Side side, Range speeds, double reach) : side_(side) {
    push(speeds.low, reach);
    if (speeds.high > speeds.low) push(speeds.high, reach);
}

// Only the corners that there are: a boundary is copied for every step.
ReachBoundary& ReachBoundary::operator=(const ReachBoundary& other) noexcept {
    side_ = other.side_;
    size_ = other.size_;
    std::copy_n(other.speed_.begin(), size_, speed_.begin());
    std::copy_n(other.reach_.begin(), size_, reach_.begin());
    return *this;
}

// What a motor can add within a time T is a lens between two parabolas, from (-aT^2/2, -aT) to (aT^2/2, aT).
// Its boundary is taken as two straight pieces that meet on the parabola half-way, at (aT^2/4, 0): steepness
// 3T/4 and T/4 on the right, -T/4 and -3T/4 on the left. The sum of two convex sets has the edges of both, by
// steepness; the time itself shears the set by T, which is taken off the steepness here instead. Between the
// two pieces a motor is faster half-way than at both ends: near the ceiling the lens shrinks to its diagonal,
// a constant acceleration.
void ReachBoundary::run(double time_s, double accel, double ceiling) noexcept {
    const double gain = accel * time_s;
    widen(time_s, gain, 0.5 * gain * time_s, fastest() + gain > ceiling ? 0.0 : 0.25 * gain * time_s);
}

void ReachBoundary::widen(double time_s, double speed_change, double reach_change, double bulge) noexcept {
    const bool is_right = side_ == Side::right;
    const double shear_s = is_right ? time_s : -time_s;
    const double end = is_right ? reach_change : -reach_change;
    make_room(2);
    const auto corner_below = [this](std::size_t i, double steepness) {
        while (i + 1 < size_ && reach_[i + 1] - reach_[i] > steepness * (speed_[i + 1] - speed_[i])) ++i;
        return i;
    };
    const double first = is_right ? -0.25 * time_s : 0.75 * time_s;
    const std::size_t lower = corner_below(0, first);
    const std::size_t upper = corner_below(lower, first - 0.5 * time_s);
    const auto move = [&](std::size_t i, std::size_t to, double speed, double reach) {
        reach_[to] = reach_[i] + shear_s * speed_[i] + reach;
        speed_[to] = speed_[i] + speed;
    };
    // From the far end, so that nothing is overwritten before it was read.
    for (std::size_t i = size_; i-- > upper;) move(i, i + 2, speed_change, end);
    for (std::size_t i = upper + 1; i-- > lower;) move(i, i + 1, 0.0, bulge);
    for (std::size_t i = lower + 1; i-- > 0;) move(i, i, -speed_change, -end);
    size_ += 2;
}

double ReachBoundary::furthest() const noexcept {
    return *std::max_element(reach_.begin(), reach_.begin() + static_cast<std::ptrdiff_t>(size_));
}

Range ReachBoundary::speeds_reaching(double level) const noexcept {
    std::size_t first = 0;
    while (first < size_ && reach_[first] < level) ++first;
    if (first == size_) return Range::none();
    std::size_t last = size_ - 1;
    while (reach_[last] < level) --last;
    return {first == 0 ? speed_[0] : crossing(first, level),
            last + 1 == size_ ? speed_[last] : crossing(last + 1, level)};
}

void ReachBoundary::keep_slower(double speed) noexcept {
    while (size_ > 1 && speed_[size_ - 2] >= speed) --size_;
    if (size_ > 1) reach_[size_ - 1] = reach_below(size_ - 1, speed);
    speed_[size_ - 1] = speed;
}

void ReachBoundary::keep_faster(double speed) noexcept {
    std::size_t next = 1;
    while (next < size_ && speed_[next] < speed) ++next;
    const double reach = next < size_ ? reach_below(next, speed) : reach_[size_ - 1];
    while (next < size_ && speed_[next] <= speed) ++next;
    if (next > 1) replace(0, next, 1);
    speed_[0] = speed;
    reach_[0] = reach;
}

void ReachBoundary::make_room(std::size_t corners) noexcept {
    for (double tolerance = kCoarse_pulses; size_ + corners > kMostCorners; tolerance *= 2.0) thin(tolerance);
}

/// Makes room for `wanted` corners where corners from..end-1 were.
void ReachBoundary::replace(std::size_t from, std::size_t end, std::size_t wanted) noexcept {
    std::memmove(&speed_[from + wanted], &speed_[end], (size_ - end) * sizeof(double));
    std::memmove(&reach_[from + wanted], &reach_[end], (size_ - end) * sizeof(double));
    size_ = size_ - (end - from) + wanted;
}

void ReachBoundary::cap(double level) noexcept {
    make_room(1);
    std::size_t first = 0;
    while (first < size_ && reach_[first] < level) ++first;
    if (first == size_) return;
    std::size_t last = size_ - 1;
    while (reach_[last] < level) --last;
    const double low = first == 0 ? speed_[0] : crossing(first, level);
    const double high = last + 1 == size_ ? speed_[last] : crossing(last + 1, level);
    const std::size_t wanted = high > low ? 2 : 1;
    replace(first, last + 1, wanted);
    speed_[first] = low;
    speed_[first + wanted - 1] = high;
    reach_[first] = reach_[first + wanted - 1] = level;
}

bool ReachBoundary::extend_slowest(double reach, double exact_from, double tolerance) noexcept {
    if (reach <= reach_[0]) return true;
    std::size_t next = 1;
    const auto line_at = [&](std::size_t corner, double speed) {
        const double share = (speed - speed_[0]) / (speed_[corner] - speed_[0]);
        return reach + share * (reach_[corner] - reach);
    };
    while (next + 1 < size_ && line_at(next + 1, speed_[next]) >= reach_[next]) ++next;
    for (std::size_t i = 1; i < next; ++i) {
        if (speed_[i] >= exact_from && line_at(next, speed_[i]) > reach_[i] + tolerance) return false;
    }
    if (next > 1) replace(1, next, 0);
    reach_[0] = reach;
    return true;
}

/// A further corner of the hull: those before it that it puts inside are dropped.
void ReachBoundary::push_outermost(double speed, double reach) noexcept {
    if (size_ > 0 && speed_[size_ - 1] == speed) {
        if (reach_[size_ - 1] >= reach) return;
        --size_;
    }
    while (size_ >= 2) {
        const double rise = reach_[size_ - 1] - reach_[size_ - 2];
        const double way = speed_[size_ - 1] - speed_[size_ - 2];
        if (rise * (speed - speed_[size_ - 2]) > (reach - reach_[size_ - 2]) * way) break;
        --size_;
    }
    push(speed, reach);
}

void ReachBoundary::join(const ReachBoundary& a, const ReachBoundary& b) noexcept {
    if (std::max(a.size_, b.size_) > kMostExactlyJoined) {
        ReachBoundary thin_a = a;
        ReachBoundary thin_b = b;
        thin_a.make_room(kMostCorners - kMostExactlyJoined);
        thin_b.make_room(kMostCorners - kMostExactlyJoined);
        join(thin_a, thin_b);
        return;
    }
    side_ = a.side_;
    size_ = 0;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size_ || j < b.size_) {
        const bool is_of_a = j == b.size_ || (i < a.size_ && a.speed_[i] <= b.speed_[j]);
        if (is_of_a) {
            push_outermost(a.speed_[i], a.reach_[i]);
            ++i;
        } else {
            push_outermost(b.speed_[j], b.reach_[j]);
            ++j;
        }
    }
}

void ReachBoundary::thin(double tolerance) noexcept {
    if (size_ < 3) return;
    std::size_t kept = 1;
    bool dropped = false;  // never two in a row: the second was judged against the first
    for (std::size_t i = 1; i < size_; ++i) {
        if (i + 1 < size_ && !dropped) {
            const double way = speed_[i + 1] - speed_[kept - 1];
            const double level = (reach_[i + 1] - reach_[kept - 1]) * (speed_[i] - speed_[kept - 1]);
            dropped = (reach_[i] - reach_[kept - 1]) * way - level < tolerance * way;
            if (dropped) continue;
        }
        dropped = false;
        speed_[kept] = speed_[i];
        reach_[kept++] = reach_[i];
    }
    size_ = kept;
}

}  // namespace psicarve::verify
