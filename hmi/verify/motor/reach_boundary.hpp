// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace psicarve::verify {

/// Two ends of a range; empty when `low` is above `high`.
struct Range {
    double low;
    double high;
    bool is_empty() const noexcept { return low > high; }
    static constexpr Range none() noexcept { return {1.0, 0.0}; }
};
constexpr Range mirrored(Range range) noexcept {
    return {-range.high, -range.low};
}
constexpr Range common(Range a, Range b) noexcept {
    return {a.low > b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}

/// One boundary of a convex set of motor states (position, speed): how far the set reaches at each speed.
///
///     speed                     The boundary is a chain of corners by rising speed; between two of them it
///     is
///       |      x..              straight. `reach` is the position on the right boundary and minus the
///       position |     /   ..            on the left one, so that both are concave and share their code. |
///       x     x   right |    |    /             Corners lie on the true boundary; what is cut off between
///       them is bounded by |    x---x              `thin`.
///       +------------ position
class ReachBoundary {
public:
    enum class Side { left, right };
    static constexpr std::size_t kMostCorners = 64;

    ReachBoundary() noexcept {}  // NOLINT(modernize-use-equals-default): corners beyond size_ stay unset
    ReachBoundary(const ReachBoundary& other) noexcept { *this = other; }
    ReachBoundary& operator=(const ReachBoundary& other) noexcept;
    ~ReachBoundary() = default;
    /// Straight from `speeds.low` to `speeds.high` at one reach.
    ReachBoundary(Side side, Range speeds, double reach);

    std::size_t size() const noexcept { return size_; }
    double speed(std::size_t i) const noexcept { return speed_[i]; }
    double reach(std::size_t i) const noexcept { return reach_[i]; }
    double slowest() const noexcept { return speed_[0]; }
    double fastest() const noexcept { return speed_[size_ - 1]; }

    /// Lets time pass under any acceleration up to `accel`. No speed on the way is above `ceiling`, if none
    /// is now.
    void run(double time_s, double accel, double ceiling) noexcept;
    /// Any speed changes by up to `jump`.
    void jump(double jump) noexcept { widen(0.0, jump, 0.0, 0.0); }

    double furthest() const noexcept;
    /// Whether `furthest` is above `level`.
    bool reaches_beyond(double level) const noexcept {
        for (std::size_t i = 0; i < size_; ++i) {
            if (reach_[i] > level) return true;
        }
        return false;
    }
    /// Speeds at which it reaches `level`; empty when none does.
    Range speeds_reaching(double level) const noexcept;
    /// Keeps only these speeds, some of which it has.
    void keep_speeds(Range speeds) noexcept {
        if (speeds.high < fastest()) keep_slower(speeds.high);
        if (speeds.low > slowest()) keep_faster(speeds.low);
    }
    /// Cuts off what reaches further than `level`.
    void cap(double level) noexcept;
    /// Extends the reach at its slowest speed. False, and unchanged, when the convex hull would then reach
    /// further than the boundary by more than `tolerance` at a speed above `exact_from`.
    bool extend_slowest(double reach, double exact_from, double tolerance) noexcept;
    /// Becomes the boundary of the convex hull of two others.
    void join(const ReachBoundary& a, const ReachBoundary& b) noexcept;
    static constexpr std::size_t kMostExactlyJoined = kMostCorners / 2;  ///< a boundary with more corners is
                                                                         ///< thinned first
    /// Drops corners that stand out by less than `tolerance`.
    void thin(double tolerance) noexcept;

private:
    void widen(double time_s, double speed_change, double reach_change, double bulge) noexcept;
    void keep_slower(double speed) noexcept;
    void keep_faster(double speed) noexcept;
    void make_room(std::size_t corners) noexcept;
    void replace(std::size_t from, std::size_t end, std::size_t wanted) noexcept;
    void push(double speed, double reach) noexcept {
        speed_[size_] = speed;
        reach_[size_] = reach;
        ++size_;
    }
    void push_outermost(double speed, double reach) noexcept;
    /// Between corners i - 1 and i.
    double reach_below(std::size_t i, double speed) const noexcept {
        const double share = (speed - speed_[i - 1]) / (speed_[i] - speed_[i - 1]);
        return reach_[i - 1] + share * (reach_[i] - reach_[i - 1]);
    }
    /// Where the chain between corners i - 1 and i crosses a level.
    double crossing(std::size_t i, double level) const noexcept {
        const double share = (level - reach_[i - 1]) / (reach_[i] - reach_[i - 1]);
        return speed_[i - 1] + share * (speed_[i] - speed_[i - 1]);
    }

    Side side_ = Side::right;
    std::size_t size_ = 0;
    std::array<double, kMostCorners> speed_;
    std::array<double, kMostCorners> reach_;
};

}  // namespace psicarve::verify
