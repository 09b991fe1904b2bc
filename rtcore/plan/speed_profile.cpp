// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

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

using SpeedRow = SpeedProfile::SpeedRow;
using AccelRows = SpeedProfile::AccelRows;

/// Everything that a cell asks of the squared speeds x and z at its begin and end, for one timing.
class CellRows {
public:
    CellRows(const AccelRows& accel, const InnerSpeeds2& inner_speed2)
        : accel_(accel),
          inner_{{{inner_speed2[0] / 0.75, 1.0 / 3.0},
                  {inner_speed2[1] / 0.5, 1.0},
                  {inner_speed2[2] / 0.25, 3.0}}} {}

    /// The greatest end speed from this begin speed, at most `limit`.
    double greatest_end(double begin, double limit) const {
        double end = limit;
        // Of the two sides of an acceleration the one that limits the end from above.
        for (std::size_t i = 0; i < accel_.count; ++i) {
            const SpeedRow& row = accel_.rows[i];
            const double tilt = std::fabs(row.tilt);
            const double left = row.tilt < 0.0 ? row.most + begin : row.most - begin;
            if (tilt * end > left) end = left / tilt;
        }
        for (const SpeedRow& row : inner_) end = std::min(end, (row.most - begin) / row.tilt);
        return std::max(end, 0.0);
    }

    /// The greatest begin speed, at most `limit`, from which an end speed of at most `end_limit` is possible.
    double greatest_begin(double limit, double end_limit) const {
        double end = end_limit;
        if (allows(limit, end_limit)) return limit;
        // The set of possible pairs is convex and holds (0, 0): walk down from end_limit along its upper edge
        // as long as the begin speed rises.
        for (std::size_t walked = 0; walked <= accel_.count + inner_.size(); ++walked) {
            const Edge edge = upper_edge(end, limit);
            if (edge.lower <= edge.upper && edge.tilt <= 0.0) return edge.upper;
            const double next = next_corner(end, limit, edge);
            if (next >= end) return std::max(0.0, edge.upper);
            end = next;
        }
        return std::max(0.0, upper_edge(end, limit).upper);
    }

private:
    struct Edge {
        double upper;  ///< greatest begin speed at this end speed
        double tilt;   ///< and by how much it falls as the end speed rises, downwards from here
        double lower;  ///< least begin speed
        double lower_tilt;
    };

    bool allows(double begin, double end) const {
        bool is_within = true;
        for (std::size_t i = 0; i < accel_.count; ++i) {
            is_within = is_within && std::fabs(begin + accel_.rows[i].tilt * end) <= accel_.rows[i].most;
        }
        for (const SpeedRow& row : inner_) is_within = is_within && begin + row.tilt * end <= row.most;
        return is_within;
    }

    Edge upper_edge(double end, double limit) const {
        Edge edge{limit, 0.0, 0.0, 0.0};
        const auto from_above = [&](const SpeedRow& row) {
            const double upper = row.most - row.tilt * end;
            const double same = kSame * std::fabs(edge.upper);
            // Of two that meet here the one that matters further down.
            if (upper < edge.upper - same || (upper <= edge.upper + same && row.tilt < edge.tilt)) {
                edge.upper = upper;
                edge.tilt = row.tilt;
            }
        };
        for (std::size_t i = 0; i < accel_.count; ++i) {
            const SpeedRow& row = accel_.rows[i];
            from_above(row);
            const double lower = -row.most - row.tilt * end;
            if (lower > edge.lower) {
                edge.lower = lower;
                edge.lower_tilt = row.tilt;
            }
        }
        for (const SpeedRow& row : inner_) from_above(row);
        return edge;
    }

    // Where, going down, another row takes over: from above, or the gap between lower and upper closes up.
    double next_corner(double end, double limit, const Edge& edge) const {
        if (edge.lower > edge.upper) {
            const double closing = edge.tilt - edge.lower_tilt;
            return closing > 0.0 ? std::max(0.0, end - (edge.lower - edge.upper) / closing) : 0.0;
        }
        double next = 0.0;
        const auto consider = [&](double upper, double tilt) {
            if (tilt >= edge.tilt) return;
            const double at = end - (upper - edge.upper) / (edge.tilt - tilt);
            if (at < end) next = std::max(next, at);
        };
        consider(limit, 0.0);
        const auto consider_row = [&](const SpeedRow& row) { consider(row.most - row.tilt * end, row.tilt); };
        for (std::size_t i = 0; i < accel_.count; ++i) consider_row(accel_.rows[i]);
        for (const SpeedRow& row : inner_) consider_row(row);
        return next;
    }

    const AccelRows& accel_;
    std::array<SpeedRow, std::tuple_size_v<InnerSpeeds2>> inner_;
};

}  // namespace

SpeedProfile::SpeedProfile(const Lanes& accel) {
    for (std::size_t k = 0; k < kAxisCount; ++k) inverse_accel_[k] = 1.0 / accel[k];
}

void SpeedProfile::set_path(std::span<const PathCell> cells) {
    rows_.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) rows_[i] = accel_rows(cells[i]);
}

SpeedProfile::AccelRows SpeedProfile::accel_rows(const PathCell& cell) const {
    AccelRows rows;
    rows.count = 0;
    // |begin * x + end * z| <= 1
    const auto add = [&rows](double begin, double end) {
        const double least = kLeastShare * std::fabs(end) + std::numeric_limits<double>::min();
        const double most = 1.0 / std::max(std::fabs(begin), least);
        rows.rows[rows.count++] = {most, (begin < 0.0 ? -end : end) * most};
    };
    const double half_inverse = 0.5 / cell.length;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double inverse = inverse_accel_[k];
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
    return rows;
}

void SpeedProfile::solve(std::span<const double> bound_speed2, std::span<const InnerSpeeds2> inner_speed2,
                         std::vector<double>& speed2) {
    const std::size_t count = rows_.size();
    reachable2_.resize(count + 1);
    reachable2_[count] = bound_speed2[count];
    for (std::size_t i = count; i-- > 0;) {
        const CellRows rows(rows_[i], inner_speed2[i]);
        reachable2_[i] = std::max(kLeastSpeed2, rows.greatest_begin(bound_speed2[i], reachable2_[i + 1]));
    }
    speed2.resize(count + 1);
    speed2[0] = reachable2_[0];
    for (std::size_t i = 0; i < count; ++i) {
        const CellRows rows(rows_[i], inner_speed2[i]);
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
