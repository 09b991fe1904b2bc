// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace psicarve::plan {
namespace {

// Rounding may not make a cell's two ends contradict each other.
constexpr double kLeastSpeed2 = 1e-12;
// A row that does not depend on the speed at the begin is given this share of a dependence.
constexpr double kLeastShare = 1e-9;
// Rows that meet in a corner do so but for rounding.
constexpr double kSame = 1e-12;
// Of an axis' acceleration at a cell's ends over that in the middle, see the header.
constexpr double kMostExcess = 0.25;
// So far the swing from less to more than the mean may take the axis off, in a cell of the time t = length:
// excess * a * t^2 / 62.4.
constexpr double kExcessPulses = 0.02;
constexpr double kSwing = 62.4;

// In three places between a cell's ends, and at its begin: x + kInnerTilt * z <= kInnerMost * limit.
constexpr Vec kInnerMost{1.0 / 0.75, 1.0 / 0.5, 1.0 / 0.25, 1.0};
constexpr Vec kInnerTilt{1.0 / 3.0, 1.0, 3.0, 0.0};
constexpr Vec kInnerInverseTilt{3.0, 1.0, 1.0 / 3.0, 0.0};
constexpr double kNone = std::numeric_limits<double>::max();
// By axis: in the middle of a cell and at both its ends.
constexpr std::size_t kRows = 3;
// More corners than a cell can have.
constexpr int kMostCorners = 16;

}  // namespace

/// Everything that a cell asks of the squared speeds x and z at its begin and end, for one timing.
class SpeedProfile::CellRows {
public:
    PSICARVE_INLINE CellRows(const AccelRows& accel, double begin_limit, const InnerSpeeds2& inner_speed2)
        : accel_(accel), inner_{inner_speed2[0], inner_speed2[1], inner_speed2[2], begin_limit} {
        inner_ *= kInnerMost;
    }

    /// The greatest end speed from this begin speed, at most `limit`.
    PSICARVE_INLINE double greatest_end(double begin, double limit) const {
        const Vec most = Vec{} + limit;
        Vec end = kInnerTilt > 0.0 ? (inner_ - begin) * kInnerInverseTilt : most;
        lower_to(end, most);
        // Of the two sides of an acceleration the one that limits the end from above.
        for (const AxisRows& rows : accel_.at) {
            const Vec left = rows.tilt < 0.0 ? rows.most + begin : rows.most - begin;
            lower_to(end, Vec(left * rows.inverse_tilt));
        }
        return std::max(least_of(end), 0.0);
    }

    /// The greatest begin speed from which an end speed of at most `end_limit` is possible.
    PSICARVE_INLINE double greatest_begin(double end_limit) const {
        // As a rule what limits the begin from above does so less, the faster the end, or not at all.
        Vec upper = inner_ - kInnerTilt * end_limit;
        Vec upper_rising = kInnerTilt > 0.0 ? Vec{} + kNone : upper;
        Vec lower{};
        for (const AxisRows& rows : accel_.at) {
            const Vec way = rows.tilt * end_limit;
            const Vec from_above = rows.most - way;
            lower_to(upper, from_above);
            lower_to(upper_rising, Vec(rows.tilt > 0.0 ? Vec{} + kNone : from_above));
            raise_to(lower, Vec(-rows.most - way));
        }
        const double greatest = least_of(upper);
        if (greatest_of(lower) > greatest) return walk_down(end_limit);
        if (least_of(upper_rising) <= greatest) return std::max(greatest, 0.0);
        return std::max(cut_down(end_limit), 0.0);
    }

private:
    /// What the rows make of the begin speed at one end speed.
    struct Edge {
        std::array<Four, kRows + 1> upper;  ///< row by row
        std::array<Four, kRows> lower;
        double greatest;  ///< begin speed
        double tilt;      ///< and by how much it falls as the end speed rises, downwards from here
        double least;     ///< begin speed
    };

    PSICARVE_INLINE const Vec& tilt_of(std::size_t row) const {
        return row < kRows ? accel_.at[row].tilt : kInnerTilt;
    }

    /// One row over d, by which the end speed is less than its limit.
    struct Line {
        double at_limit;
        double rise;
        PSICARVE_INLINE double at(double d) const { return at_limit + rise * d; }
    };

    // The greatest begin speed that all rows together leave, where they leave something at end_limit and so
    // everywhere below: as a function of d it is concave, and greatest where the first of the lines that fall
    // meets the last of those that rise.
    PSICARVE_INLINE double cut_down(double end_limit) const {
        std::array<Four, kRows + 1> at_limit;
        at_limit[kRows].axes = inner_ - kInnerTilt * end_limit;
        for (std::size_t i = 0; i < kRows; ++i)
            at_limit[i].axes = accel_.at[i].most - accel_.at[i].tilt * end_limit;
        Line falling = lowest_falling(at_limit, 0.0);
        for (int tried = 0;; ++tried) {
            const double d = std::min(end_limit, last_rising(at_limit, falling));
            const Line least = lowest_falling(at_limit, d);
            const bool is_first = least.at(d) >= falling.at(d) - kSame * std::fabs(falling.at(d));
            if (is_first && d < end_limit) return least.at(d);
            if (is_first || tried == kMostCorners) return lowest_at(at_limit, d);
            falling = least;
        }
    }

    /// The lowest line at d of those that do not rise; of several the one that is lower further on.
    PSICARVE_INLINE Line lowest_falling(const std::array<Four, kRows + 1>& at_limit, double d) const {
        const Vec none = Vec{} + kNone;
        std::array<Four, kRows + 1> at;
        Vec least = none;
        for (std::size_t i = 0; i < kRows + 1; ++i) {
            const Vec& tilt = tilt_of(i);
            at[i].axes = tilt > 0.0 ? none : at_limit[i].axes + tilt * d;
            lower_to(least, at[i].axes);
        }
        const double value = least_of(least);
        Vec rise = none;
        for (std::size_t i = 0; i < kRows + 1; ++i)
            lower_to(rise, Vec(at[i].axes <= value ? tilt_of(i) : none));
        const double least_rise = least_of(rise);
        return {value - least_rise * d, least_rise};
    }

    /// Where the last of the lines that rise meets `falling`.
    PSICARVE_INLINE double last_rising(const std::array<Four, kRows + 1>& at_limit,
                                       const Line& falling) const {
        Vec last{};
        for (std::size_t i = 0; i < kRows + 1; ++i) {
            const Vec& tilt = tilt_of(i);
            const Vec meets = (falling.at_limit - at_limit[i].axes) / (tilt - falling.rise);
            raise_to(last, Vec(tilt > 0.0 ? meets : Vec{}));
        }
        return greatest_of(last);
    }

    PSICARVE_INLINE double lowest_at(const std::array<Four, kRows + 1>& at_limit, double d) const {
        Vec least = at_limit[kRows].axes + kInnerTilt * d;
        for (std::size_t i = 0; i < kRows; ++i)
            lower_to(least, Vec(at_limit[i].axes + accel_.at[i].tilt * d));
        return least_of(least);
    }

    // The set of possible pairs is convex and holds (0, 0): walk down from end_limit along its upper edge
    // as long as the begin speed rises.
    PSICARVE_FOR_WIDE_REGISTERS
    double walk_down(double end) const {
        Edge edge;
        for (int walked = 0;; ++walked) {
            edge_at(end, edge);
            if (walked == kMostCorners || (edge.least <= edge.greatest && edge.tilt <= 0.0)) break;
            const double next = next_corner(end, edge);
            if (next >= end) break;
            end = next;
        }
        return std::max(0.0, edge.greatest);
    }

    PSICARVE_INLINE void edge_at(double end, Edge& edge) const {
        edge.upper[kRows].axes = inner_ - kInnerTilt * end;
        Vec upper = edge.upper[kRows].axes;
        Vec lower{};
        for (std::size_t i = 0; i < kRows; ++i) {
            const AxisRows& rows = accel_.at[i];
            edge.upper[i].axes = rows.most - rows.tilt * end;
            edge.lower[i].axes = -rows.most - rows.tilt * end;
            lower_to(upper, edge.upper[i].axes);
            raise_to(lower, edge.lower[i].axes);
        }
        edge.greatest = least_of(upper);
        edge.least = greatest_of(lower);
        // Of rows that meet here the one that matters further down.
        Vec least_tilt = Vec{} + kNone;
        for (std::size_t i = 0; i < kRows + 1; ++i) {
            const Vec& tilt = tilt_of(i);
            const Vec size = tilt < 0.0 ? -tilt : tilt;
            const Vec same = edge.greatest + kSame * (std::fabs(edge.greatest) + size * end);
            lower_to(least_tilt, Vec(edge.upper[i].axes <= same ? tilt : Vec{} + kNone));
        }
        edge.tilt = least_of(least_tilt);
        // Where a gap has just closed up, rounding may leave a little of it.
        const double rounding = kSame * (std::fabs(edge.greatest) + std::fabs(edge.tilt) * end);
        if (edge.least <= edge.greatest + rounding) edge.least = std::min(edge.least, edge.greatest);
    }

    // Where, going down, another row takes over: from above, or the gap between lower and upper closes up.
    PSICARVE_INLINE double next_corner(double end, const Edge& edge) const {
        if (edge.least > edge.greatest) {
            // Of rows that meet here the one that matters further down; 0 is the least of all speeds.
            const double none = edge.least > 0.0 ? -kNone : 0.0;
            Vec lower_tilt = Vec{} + none;
            for (std::size_t i = 0; i < kRows; ++i) {
                raise_to(lower_tilt, Vec(edge.lower[i].axes >= edge.least ? tilt_of(i) : Vec{} + none));
            }
            const double closing = edge.tilt - greatest_of(lower_tilt);
            return closing > 0.0 ? std::max(0.0, end - (edge.least - edge.greatest) / closing) : 0.0;
        }
        Vec next{};
        for (std::size_t i = 0; i < kRows + 1; ++i) {
            const Vec& tilt = tilt_of(i);
            const Vec at = end - (edge.upper[i].axes - edge.greatest) / (edge.tilt - tilt);
            raise_to(next, Vec(tilt < edge.tilt && at < end ? at : Vec{}));
        }
        return greatest_of(next);
    }

    const AccelRows& accel_;
    Vec inner_;
};

SpeedProfile::SpeedProfile(const Lanes& accel) {
    for (std::size_t k = 0; k < kAxisCount; ++k) inverse_accel_[k] = 1.0 / accel[k];
}

PSICARVE_FOR_WIDE_REGISTERS
void SpeedProfile::set_path(std::span<const PathCell> cells) {
    rows_.resize(cells.size());
    Vec inverse;
    load(inverse_accel_, inverse);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const PathCell& cell = cells[i];
        // |begin * x + end * z| <= 1
        const auto set = [](const Vec& begin, const Vec& end, AxisRows& rows) __attribute__((always_inline)) {
            const Vec least_begin =
                kLeastShare * (end < 0.0 ? -end : end) + std::numeric_limits<double>::min();
            Vec size = begin < 0.0 ? -begin : begin;
            raise_to(size, least_begin);
            rows.most = 1.0 / size;
            rows.tilt = (begin < 0.0 ? -end : end) * rows.most;
            Vec tilt_size = rows.tilt < 0.0 ? -rows.tilt : rows.tilt;
            raise_to(tilt_size, Vec(Vec{} + std::numeric_limits<double>::min()));
            rows.inverse_tilt = 1.0 / tilt_size;
        };
        Vec bend, first, last;
        load(cell.bend, bend);
        load(cell.slope_begin, first);
        load(cell.slope_end, last);
        const double half_inverse = 0.5 / cell.length;
        bend *= inverse;
        first *= half_inverse * inverse;
        last *= half_inverse * inverse;
        const Vec middle = 0.5 * (first + last);
        Vec excess = kSwing * kExcessPulses * inverse / (cell.length * cell.length);
        lower_to(excess, Vec(Vec{} + kMostExcess));
        const Vec weight = 1.0 / (1.0 + excess);
        AccelRows& rows = rows_[i];
        set(0.5 * bend - middle, 0.5 * bend + middle, rows.at[0]);
        set((bend - first) * weight, first * weight, rows.at[1]);
        set(-last * weight, (bend + last) * weight, rows.at[2]);
    }
}

/// One timing's way back through the cells and forth again. The results have cells + 1 values.
class SpeedProfile::Passes {
public:
    Passes(std::span<const AccelRows> rows, const SpeedLimits& limits, std::vector<double>& reachable2,
           std::vector<double>& speed2)
        : rows_(rows), limits_(limits) {
        reachable2.resize(rows.size() + 1);
        speed2.resize(rows.size() + 1);
        reachable2_ = reachable2;
        speed2_ = speed2;
        reachable2_.back() = limits.bound2.back();
    }
    PSICARVE_INLINE void go_back(std::size_t i) {
        reachable2_[i] = std::max(kLeastSpeed2, cell(i).greatest_begin(reachable2_[i + 1]));
    }
    void turn_round() { speed2_.front() = reachable2_.front(); }
    PSICARVE_INLINE void go_on(std::size_t i) {
        speed2_[i + 1] = std::max(kLeastSpeed2, cell(i).greatest_end(speed2_[i], reachable2_[i + 1]));
    }

private:
    PSICARVE_INLINE CellRows cell(std::size_t i) const {
        return CellRows(rows_[i], limits_.bound2[i], limits_.inner2[i]);
    }

    std::span<const AccelRows> rows_;
    const SpeedLimits& limits_;
    std::span<double> reachable2_;
    std::span<double> speed2_;
};

PSICARVE_FOR_WIDE_REGISTERS
void SpeedProfile::solve(const SpeedLimits& limits, std::vector<double>& speed2) {
    Passes passes(rows_, limits, reachable2_[0], speed2);
    for (std::size_t i = rows_.size(); i-- > 0;) passes.go_back(i);
    passes.turn_round();
    for (std::size_t i = 0; i < rows_.size(); ++i) passes.go_on(i);
}

PSICARVE_FOR_WIDE_REGISTERS
void SpeedProfile::solve_both(const std::array<SpeedLimits, 2>& limits,
                              std::array<std::vector<double>, 2>& speed2) {
    Passes first(rows_, limits[0], reachable2_[0], speed2[0]);
    Passes second(rows_, limits[1], reachable2_[1], speed2[1]);
    for (std::size_t i = rows_.size(); i-- > 0;) {
        first.go_back(i);
        second.go_back(i);
    }
    first.turn_round();
    second.turn_round();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        first.go_on(i);
        second.go_on(i);
    }
}

double greatest_end_share(double length, double inverse_accel) {
    return 1.0 + std::min(kMostExcess, kSwing * kExcessPulses * inverse_accel / (length * length));
}

double cell_seconds(double length, double begin_speed2, double end_speed2) {
    return 2.0 * length / (std::sqrt(begin_speed2) + std::sqrt(end_speed2));
}

}  // namespace psicarve::plan
