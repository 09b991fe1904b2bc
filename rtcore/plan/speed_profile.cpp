// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace psicarve::plan {
namespace {

// Rounding may not make a cell's two ends contradict each other.
constexpr double kLeastSpeed2 = 1e-12;
// Rows that meet in a corner do so but for rounding.
constexpr double kSame = 1e-12;
// Of an axis' acceleration at a cell's ends over that in the middle, see the header.
constexpr double kMostExcess = 0.25;
// So far the swing from less to more than the mean may take the axis off, in a cell of the time t = length:
// excess * a * t^2 / 62.4.
constexpr double kExcessPulses = 0.02;
constexpr double kSwing = 62.4;
constexpr std::size_t kMostRows = 6 * kAxisCount + 3;

/// begin * x + end * z <= 1, for the speeds x and z at a cell's begin and end.
struct SpeedRow {
    double begin;
    double end;
};

/// Everything that one cell asks of the speeds at its ends.
class CellRows {
public:
    CellRows(const PathCell& cell, const Lanes& inverse_accel, const InnerSpeeds2& inner_speed2) {
        const double half_inverse = 0.5 / cell.length;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const double inverse = inverse_accel[k];
            const double bend = cell.bend[k] * inverse;
            const double first = cell.slope_begin[k] * half_inverse * inverse;
            const double last = cell.slope_end[k] * half_inverse * inverse;
            if (first == 0.0 && last == 0.0) continue;
            const double middle = 0.5 * (first + last);
            add(0.5 * bend - middle, 0.5 * bend + middle);
            const double weight = 1.0 / greatest_end_share(cell.length, inverse);
            add((bend - first) * weight, first * weight);
            add(-last * weight, (bend + last) * weight);
        }
        for (std::size_t i = 0; i < inner_speed2.size(); ++i) {
            const double at = 0.25 * static_cast<double>(i + 1);
            rows_[count_++] = {(1.0 - at) / inner_speed2[i], at / inner_speed2[i]};
        }
    }

    /// The greatest end speed from this begin speed, at most `limit`.
    double greatest_end(double begin, double limit) const {
        double end = limit;
        for (std::size_t i = 0; i < count_; ++i) {
            const SpeedRow& row = rows_[i];
            const double left = 1.0 - row.begin * begin;
            if (row.end > 0.0 && row.end * end > left) end = left / row.end;
        }
        return std::max(end, 0.0);
    }

    /// The greatest begin speed, at most `limit`, from which an end speed of at most `end_limit` is possible.
    double greatest_begin(double limit, double end_limit) const {
        double end = end_limit;
        if (allows(limit, end_limit)) return limit;
        // The set of possible pairs is convex and holds (0, 0): walk down from end_limit along its upper edge
        // as long as the begin speed rises.
        for (std::size_t walked = 0; walked <= count_; ++walked) {
            const Edge edge = upper_edge(end, limit);
            if (edge.lower <= edge.upper && edge.slope >= 0.0) return edge.upper;
            const double next = next_corner(end, limit, edge);
            if (next >= end) return std::max(0.0, edge.upper);
            end = next;
        }
        return std::max(0.0, upper_edge(end, limit).upper);
    }

private:
    struct Edge {
        double upper;  ///< greatest begin speed at this end speed
        double slope;  ///< and how it changes with the end speed, downwards from here
        double lower;  ///< least begin speed
        double lower_slope;
    };

    bool allows(double begin, double end) const {
        double most = 0.0;
        for (std::size_t i = 0; i < count_; ++i) {
            most = std::max(most, rows_[i].begin * begin + rows_[i].end * end);
        }
        return most <= 1.0;
    }

    void add(double begin, double end) {
        rows_[count_++] = {begin, end};
        rows_[count_++] = {-begin, -end};
    }

    // Fractions are compared by cross multiplication: one division at the end.
    Edge upper_edge(double end, double limit) const {
        Edge edge{limit, 0.0, 0.0, 0.0};
        double upper_left = limit;
        SpeedRow upper{1.0, 0.0};
        for (std::size_t i = 0; i < count_; ++i) {
            const SpeedRow& row = rows_[i];
            const double left = 1.0 - row.end * end;
            if (row.begin > 0.0) {
                const double margin = left * upper.begin - upper_left * row.begin;
                const double same = kSame * std::abs(upper_left * row.begin);
                // Of two that meet here the one that matters further down.
                const bool falls_faster = row.end * upper.begin < upper.end * row.begin;
                if (margin < -same || (margin <= same && falls_faster)) {
                    upper_left = left;
                    upper = row;
                }
            } else if (left < 0.0 && row.begin < 0.0 && left / row.begin > edge.lower) {
                edge.lower = left / row.begin;
                edge.lower_slope = -row.end / row.begin;
            }
        }
        edge.upper = upper_left / upper.begin;
        edge.slope = -upper.end / upper.begin;
        return edge;
    }

    // Where, going down, another row takes over: from above, or the gap between lower and upper closes up.
    double next_corner(double end, double limit, const Edge& edge) const {
        double next = 0.0;
        if (edge.lower > edge.upper) {
            const double closing = edge.lower_slope - edge.slope;
            if (closing > 0.0) return std::max(0.0, end - (edge.lower - edge.upper) / closing);
            return 0.0;
        }
        const auto consider = [&](double upper, double slope) {
            if (slope <= edge.slope) return;
            const double at = end - (upper - edge.upper) / (slope - edge.slope);
            if (at < end) next = std::max(next, at);
        };
        consider(limit, 0.0);
        for (std::size_t i = 0; i < count_; ++i) {
            const SpeedRow& row = rows_[i];
            if (row.begin > 0.0) consider((1.0 - row.end * end) / row.begin, -row.end / row.begin);
        }
        return next;
    }

    std::array<SpeedRow, kMostRows> rows_;
    std::size_t count_ = 0;
};

}  // namespace

SpeedProfile::SpeedProfile(const Lanes& accel) {
    for (std::size_t k = 0; k < kAxisCount; ++k) inverse_accel_[k] = 1.0 / accel[k];
}

void SpeedProfile::solve(std::span<const PathCell> cells, std::span<const double> bound_speed2,
                         std::span<const InnerSpeeds2> inner_speed2, std::vector<double>& speed2) {
    const std::size_t count = cells.size();
    reachable2_.resize(count + 1);
    reachable2_[count] = bound_speed2[count];
    for (std::size_t i = count; i-- > 0;) {
        const CellRows rows(cells[i], inverse_accel_, inner_speed2[i]);
        reachable2_[i] = std::max(kLeastSpeed2, rows.greatest_begin(bound_speed2[i], reachable2_[i + 1]));
    }
    speed2.resize(count + 1);
    speed2[0] = reachable2_[0];
    for (std::size_t i = 0; i < count; ++i) {
        const CellRows rows(cells[i], inverse_accel_, inner_speed2[i]);
        speed2[i + 1] = std::max(kLeastSpeed2, rows.greatest_end(speed2[i], reachable2_[i + 1]));
    }
}

double greatest_end_share(double length, double inverse_accel) {
    return 1.0 + std::min(kMostExcess, kSwing * kExcessPulses * inverse_accel / (length * length));
}

double cell_seconds(double length, double begin_speed2, double end_speed2) {
    return 2.0 * length / (std::sqrt(begin_speed2) + std::sqrt(end_speed2));
}

}  // namespace psicarve::plan
