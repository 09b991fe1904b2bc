// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rtcore/cycle/timed_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "tests/rtcore/cycle/path_rig.hpp"

namespace psicarve::cycle {
namespace {

/// low <= at_start * x + at_end * y <= high, for the speeds squared x, y of a segment's start and end.
struct Bound {
    double at_start;
    double at_end;
    double low;
    double high;
    bool holds(double start, double end) const {
        const double value = at_start * start + at_end * end;
        const double slack = 1e-9 * (high - low);
        return value >= low - slack && value <= high + slack;
    }
};

struct Segment {
    double length;
    Axis4 slope_start;
    Axis4 slope_end;
    Axis4 bend;
};

/// |q'·a + q''·speed2| <= a_k at both ends, a being (end - start) / 2L.
std::vector<Bound> bounds_of(const Segment& segment, const Axis4& accel) {
    std::vector<Bound> bounds;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double first = segment.slope_start[k] / (2.0 * segment.length);
        const double last = segment.slope_end[k] / (2.0 * segment.length);
        bounds.push_back({segment.bend[k] - first, first, -accel[k], accel[k]});
        bounds.push_back({-last, last + segment.bend[k], -accel[k], accel[k]});
    }
    return bounds;
}

bool all_hold(const std::vector<Bound>& bounds, double start, double end) {
    return std::ranges::all_of(bounds, [&](const Bound& bound) { return bound.holds(start, end); });
}

/// The largest start speed squared from which some allowed end can be reached.
double largest_start(std::vector<Bound> bounds, double start_cap, double end_cap) {
    bounds.push_back({1.0, 0.0, 0.0, start_cap});
    bounds.push_back({0.0, 1.0, 0.0, end_cap});
    double best = 0.0;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Bound& p = bounds[i];
            const Bound& q = bounds[j];
            const double det = p.at_start * q.at_end - p.at_end * q.at_start;
            if (std::fabs(det) < 1e-300) continue;
            for (const double right_p : {p.low, p.high}) {
                for (const double right_q : {q.low, q.high}) {
                    const double start = (right_p * q.at_end - p.at_end * right_q) / det;
                    const double end = (p.at_start * right_q - right_p * q.at_start) / det;
                    if (start > best && all_hold(bounds, start, end)) best = start;
                }
            }
        }
    }
    return best;
}

/// The largest end speed squared that can be reached from this start.
double largest_end(const std::vector<Bound>& bounds, double start, double end_cap) {
    double most = end_cap;
    for (const Bound& bound : bounds) {
        if (bound.at_end == 0.0) continue;
        const double limit = bound.at_end > 0.0 ? bound.high : bound.low;
        most = std::min(most, (limit - bound.at_start * start) / bound.at_end);
    }
    return std::max(0.0, most);
}

}  // namespace

TimedCurve::TimedCurve(std::uint64_t seed, std::size_t segments, const CurveLimits& limits)
    : limits_(limits) {
    shape(seed, segments);
    speed2_[1] = timed(2.0 * limits_.feed);
    speed2_[0] = timed(limits_.feed);
    for (std::size_t i = 0; i < speed2_[0].size(); ++i)
        speed2_[0][i] = std::min(speed2_[0][i], speed2_[1][i]);
    fill_blocks();
}

void TimedCurve::shape(std::uint64_t seed, std::size_t segments) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    length_ = 8.0;
    const double each = length_;
    bend_.assign(segments, Axis4{});
    slope_.assign(segments + 1, Axis4{});
    place_.assign(segments + 1, Axis4{});
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double steepness = 2.5 * part(random);
        const double waves = 2.0 + 20.0 * part(random);
        const double phase = 2.0 * std::numbers::pi * part(random);
        const double finer = 1.0 + 4.0 * part(random);  // a second wave, of the same bend
        const double turn = 2.0 * std::numbers::pi * waves / static_cast<double>(segments);
        // Psi turns on and on; the others go to and fro.
        slope_[0][k] = k == 2 ? 1.0 : steepness * (std::cos(phase) + 1.0 / finer);
        for (std::size_t i = 0; i < segments; ++i) {
            const double angle = turn * (static_cast<double>(i) + 0.5);
            const double shape = std::sin(angle + phase) + std::sin(finer * angle);
            bend_[i][k] = k == 2 ? 0.0 : -steepness * turn * shape / each;
            slope_[i + 1][k] = slope_[i][k] + bend_[i][k] * each;
            place_[i + 1][k] = place_[i][k] + 0.5 * (slope_[i][k] + slope_[i + 1][k]) * each;
        }
    }
}

std::vector<double> TimedCurve::caps(double feed) const {
    std::vector<double> caps(slope_.size(), feed * feed);
    for (std::size_t i = 0; i < segments(); ++i) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const double most = std::max(std::fabs(slope_[i][k]), std::fabs(slope_[i + 1][k]));
            const double cap = most > 0.0 ? std::pow(limits_.speed[k] / most, 2) : 1e9;
            caps[i] = std::min(caps[i], cap);
            caps[i + 1] = std::min(caps[i + 1], cap);
        }
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const auto from_rest = [&](double slope) { return std::pow(limits_.jump[k] / std::fabs(slope), 2); };
        if (slope_.front()[k] != 0.0) caps.front() = std::min(caps.front(), from_rest(slope_.front()[k]));
        if (slope_.back()[k] != 0.0) caps.back() = std::min(caps.back(), from_rest(slope_.back()[k]));
    }
    return caps;
}

std::vector<double> TimedCurve::timed(double feed) const {
    return timed_within(caps(feed));
}

std::vector<double> TimedCurve::timed_within(std::vector<double> most) const {
    Axis4 accel = limits_.accel;
    for (double& limit : accel) limit *= 1.0 - 1e-8;
    const auto bounds = [&](std::size_t i) {
        return bounds_of({length_, slope_[i], slope_[i + 1], bend_[i]}, accel);
    };
    const std::size_t count = most.size() - 1;
    for (std::size_t i = count; i-- > 0;) most[i] = largest_start(bounds(i), most[i], most[i + 1]);
    for (std::size_t i = 0; i < count; ++i) most[i + 1] = largest_end(bounds(i), most[i], most[i + 1]);
    return most;
}

std::vector<double> TimedCurve::rest_speed2(std::size_t segments) const {
    std::vector<double> most = caps(1e9);
    most.resize(segments + 1);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double slope = slope_[segments][k];
        if (slope != 0.0)
            most.back() = std::min(most.back(), std::pow(limits_.jump[k] / std::fabs(slope), 2));
    }
    return timed_within(std::move(most));
}

Axis4 TimedCurve::slope(std::size_t segment, double way) const {
    Axis4 found = slope_[segment];
    for (std::size_t k = 0; k < kAxisCount; ++k) found[k] += bend_[segment][k] * way;
    return found;
}

double TimedCurve::speed2(std::size_t profile, std::size_t segment, double way) const {
    const double start = speed2_[profile][segment];
    return start + (speed2_[profile][segment + 1] - start) * way / length_;
}

void TimedCurve::fill_blocks() {
    const double per_s = 1.0 / kPathTick_s;
    for (std::size_t i = 0; i < segments(); ++i) {
        MotionBlock block{};
        block.kind = BlockKind::path;
        PathTiming& path = block.path;
        path.length = length_;
        double jump_speed = 1e9;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            block.delta_pulses[k] = std::llround(place_[i + 1][k]) - std::llround(place_[i][k]);
            const double most = std::max(std::fabs(slope_[i][k]), std::fabs(slope_[i + 1][k]));
            const bool moves = most > 0.0;
            path.accel_free[k] = moves ? static_cast<float>(limits_.accel[k] / most * per_s * per_s) : 1e30F;
            path.accel_bend[k] = moves ? static_cast<float>(std::fabs(bend_[i][k]) / most) : 0.0F;
            if (moves) jump_speed = std::min(jump_speed, limits_.jump[k] / most);
        }
        path.start_stop_speed = static_cast<float>(jump_speed * per_s);
        for (std::size_t p = 0; p < 2; ++p) {
            path.start_speed2[p] = speed2_[p][i] * per_s * per_s;
            path.end_speed2[p] = speed2_[p][i + 1] * per_s * per_s;
        }
        block.reaches_points = i % 10 == 9 ? 1 : 0;
        block.point = static_cast<std::uint32_t>(i / 10);
        blocks_.push_back(block);
    }
    blocks_ = as_run(blocks_);
}

}  // namespace psicarve::cycle
