// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_fit.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::plan {
namespace {

constexpr int kMostIterations = 40;
// How much more bending than necessary is left, as a share of it: ten times less of time.
constexpr double kBendingTolerance = 1e-2;
// Accelerations below this share of what the motors can do do not matter.
constexpr double kAccelTolerance = 0.01;
constexpr double kBoundTolerancePulses = 0.02;
// How close to a bound one iteration may go.
constexpr double kBoundShare = 0.99;

template <typename Vec>
void raise_to(Vec& greatest, const Vec& value) {
    greatest = value > greatest ? value : greatest;
}

// The length of a step that shrinks something by `shrink` per unit: not to nothing.
template <typename Vec>
void length_within(const Vec& shrink, Vec& length) {
    const Vec most = Vec{} + kBoundShare;
    length = shrink > most ? most / shrink : Vec{} + 1.0;
}

}  // namespace

void CurveFit::solve(const CurveNodes& nodes, std::span<const Lanes> fixed) {
    prepare(nodes);
    start(nodes, fixed);
    for (iterations_ = 0; iterations_ < kMostIterations && !has_converged(); ++iterations_) {
        build_matrix();
        factorise();
        substitute(side_);
        change_ = side_;
        Vec length;
        const Reach predicted = predict();
        length_within(predicted.shrink, length);
        const Vec possible = gap_ + length * (predicted.linear + length * predicted.square);
        const Vec share = gap_ > 0.0 ? possible / gap_ : Vec{};
        const Vec target = share * share * share * gap_ / bound_count_;
        correct(target);
        const Reach reach = reach_corrected(target);
        length_within(reach.shrink, length);
        advance(length);
    }
    control_.resize(count_);
    for (std::size_t j = 0; j < count_; ++j) {
        for (std::size_t k = 0; k < kAxisCount; ++k) control_[j][k] = points_[j][k];
    }
}

void CurveFit::prepare(const CurveNodes& nodes) {
    count_ = nodes.step.size();
    bend_.assign(count_, Row{});
    value_.assign(count_, Row{0.0, 1.0, 0.0});
    stiffness_.assign(count_, {});
    length_ = 0.0;
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const double before = 1.0 / nodes.control_step[j - 1];
        const double after = 1.0 / nodes.control_step[j];
        const double cell = nodes.cell[j];
        length_ += cell;
        const double first = before / cell;
        const double last = after / cell;
        const double offset = nodes.offset[j];
        const double lift = 0.125 * cell * cell + 0.5 * offset * offset;
        const double tilt = 0.5 * offset;
        value_[j] = {lift * first - tilt * before, 1.0 - lift * (first + last) + tilt * (before - after),
                     lift * last + tilt * after};
        const double weight = std::sqrt(cell);
        const Row row{weight * first, -weight * (first + last), weight * last};
        bend_[j] = row;
        stiffness_[j - 1][0] += row.before * row.before;
        stiffness_[j - 1][1] += row.before * row.at;
        stiffness_[j - 1][2] += row.before * row.after;
        stiffness_[j][0] += row.at * row.at;
        stiffness_[j][1] += row.at * row.after;
        stiffness_[j + 1][0] += row.after * row.after;
    }
    bound_count_ = 2.0 * static_cast<double>(count_ - 2);
}

void CurveFit::start(const CurveNodes& nodes, std::span<const Lanes> fixed) {
    points_.resize(count_);
    side_.resize(count_);
    states_.resize(count_);
    band_.resize(count_ + 2);
    for (std::size_t j = 0; j < count_; ++j) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            states_[j].low[k] = nodes.low[j][k];
            states_[j].high[k] = nodes.high[j][k];
            points_[j][k] = j < fixed.size() ? fixed[j][k] : 0.5 * (nodes.low[j][k] + nodes.high[j][k]);
        }
    }
    fixed_ = std::max<std::size_t>(1, fixed.size());
    // A press of about what it takes to bend the curve into the middle of its tube.
    Vec press{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = bend_[j];
        const Vec force =
            row.at * (row.before * points_[j - 1] + row.at * points_[j] + row.after * points_[j + 1]);
        press += force < 0.0 ? -force : force;
        states_[j].value =
            value_[j].before * points_[j - 1] + value_[j].at * points_[j] + value_[j].after * points_[j + 1];
    }
    press /= static_cast<double>(count_ - 2);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        press[k] = std::max(press[k], kAccelTolerance * accel_[k] * std::abs(bend_[1].at));
    }
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        State& state = states_[j];
        state.lower.distance = state.upper.distance = 0.5 * (state.high - state.low);
        state.lower.press = state.upper.press = press;
    }
}

bool CurveFit::has_converged() {
    Vec gap{};
    Vec bending{};
    Vec outside{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = bend_[j];
        const State& state = states_[j];
        const Vec bend = row.before * points_[j - 1] + row.at * points_[j] + row.after * points_[j + 1];
        bending += bend * bend;
        gap += state.lower.distance * state.lower.press + state.upper.distance * state.upper.press;
        raise_to(outside, Vec(state.low - state.value));
        raise_to(outside, Vec(state.value - state.high));
    }
    gap_ = gap;
    bool is_done = true;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double least = kAccelTolerance * accel_[k];
        const double allowed = 0.5 * (kBendingTolerance * bending[k] + least * least * length_);
        is_done = is_done && gap[k] <= allowed && outside[k] <= kBoundTolerancePulses;
    }
    return is_done;
}

// stiffness + value' * (press / distance) * value, and the right side of the predictor.
void CurveFit::build_matrix() {
    for (std::size_t j = 0; j < count_; ++j) {
        band_[j].at = Vec{} + stiffness_[j][0];
        band_[j].next = Vec{} + stiffness_[j][1];
        band_[j].second = Vec{} + stiffness_[j][2];
        side_[j] = Vec{};
    }
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& bend_row = bend_[j];
        const Row& row = value_[j];
        State& state = states_[j];
        Bound& lower = state.lower;
        Bound& upper = state.upper;
        lower.inverse_distance = 1.0 / lower.distance;
        upper.inverse_distance = 1.0 / upper.distance;
        const Vec lower_weight = lower.press * lower.inverse_distance;
        const Vec upper_weight = upper.press * upper.inverse_distance;
        const Vec weight = lower_weight + upper_weight;
        const Vec before = weight * row.before;
        const Vec at = weight * row.at;
        band_[j - 1].at += before * row.before;
        band_[j - 1].next += before * row.at;
        band_[j - 1].second += before * row.after;
        band_[j].at += at * row.at;
        band_[j].next += at * row.after;
        band_[j + 1].at += weight * (row.after * row.after);
        const Vec push = upper_weight * (state.high - state.value - upper.distance) -
                         lower_weight * (state.value - state.low - lower.distance);
        const Vec bend =
            bend_row.before * points_[j - 1] + bend_row.at * points_[j] + bend_row.after * points_[j + 1];
        side_[j - 1] += row.before * push - bend_row.before * bend;
        side_[j] += row.at * push - bend_row.at * bend;
        side_[j + 1] += row.after * push - bend_row.after * bend;
    }
}

// L D L' of the rows of the points that may move: `at` becomes 1 / pivot, `next` and `second` the factors.
void CurveFit::factorise() {
    for (std::size_t j = fixed_; j + 1 < count_; ++j) {
        Band& row = band_[j];
        const Vec inverse = 1.0 / row.at;
        const Vec next = row.next * inverse;
        const Vec second = row.second * inverse;
        band_[j + 1].at -= next * row.next;
        band_[j + 1].next -= next * row.second;
        band_[j + 2].at -= second * row.second;
        row.at = inverse;
        row.next = next;
        row.second = second;
    }
}

void CurveFit::substitute(std::vector<Vec>& side) const {
    const std::size_t end = count_ - 1;
    for (std::size_t j = 0; j < fixed_; ++j) side[j] = Vec{};
    for (std::size_t j = fixed_; j < end; ++j) {
        side[j + 1] -= band_[j].next * side[j];
        if (j + 2 <= end) side[j + 2] -= band_[j].second * side[j];
    }
    side[end] = Vec{};
    Vec after{};
    Vec second{};
    for (std::size_t j = end; j-- > fixed_;) {
        const Band& row = band_[j];
        side[j] = side[j] * row.at - row.next * after - row.second * second;
        second = after;
        after = side[j];
    }
}

// The way straight to the bounds: what it would change, without going.
CurveFit::Reach CurveFit::predict() {
    Reach reach{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = value_[j];
        State& state = states_[j];
        const Vec shift = row.before * change_[j - 1] + row.at * change_[j] + row.after * change_[j + 1];
        const auto bound_changes = [&reach](Bound& bound, const Vec& distance_change) {
            const Vec relative = distance_change * bound.inverse_distance;
            bound.distance_change = distance_change;
            bound.press_change = -bound.press * (relative + 1.0);
            raise_to(reach.shrink, Vec(-relative));
            raise_to(reach.shrink, Vec(relative + 1.0));
            reach.linear += distance_change * bound.press + bound.distance * bound.press_change;
            reach.square += distance_change * bound.press_change;
        };
        bound_changes(state.lower, Vec(shift + state.value - state.low - state.lower.distance));
        bound_changes(state.upper, Vec(state.high - state.value - state.upper.distance - shift));
    }
    return reach;
}

// Towards the middle by `target`, and what the prediction left out to second order.
void CurveFit::correct(const Vec& target) {
    std::fill(side_.begin(), side_.end(), Vec{});
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = value_[j];
        const Bound& lower = states_[j].lower;
        const Bound& upper = states_[j].upper;
        const Vec push = (target - lower.distance_change * lower.press_change) * lower.inverse_distance -
                         (target - upper.distance_change * upper.press_change) * upper.inverse_distance;
        side_[j - 1] += row.before * push;
        side_[j] += row.at * push;
        side_[j + 1] += row.after * push;
    }
    substitute(side_);
    for (std::size_t j = 0; j < count_; ++j) change_[j] += side_[j];
}

CurveFit::Reach CurveFit::reach_corrected(const Vec& target) {
    Reach reach{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = value_[j];
        State& state = states_[j];
        state.shift = row.before * change_[j - 1] + row.at * change_[j] + row.after * change_[j + 1];
        const auto bound_changes = [&](Bound& bound, const Vec& distance_change) {
            const Vec relative = distance_change * bound.inverse_distance;
            const Vec second = bound.distance_change * bound.press_change;
            bound.distance_change = distance_change;
            bound.press_change = (target - second) * bound.inverse_distance - bound.press * (relative + 1.0);
            raise_to(reach.shrink, Vec(-relative));
            raise_to(reach.shrink, Vec(-bound.press_change / bound.press));
        };
        bound_changes(state.lower, Vec(state.shift + state.value - state.low - state.lower.distance));
        bound_changes(state.upper, Vec(state.high - state.value - state.upper.distance - state.shift));
    }
    return reach;
}

void CurveFit::advance(const Vec& length) {
    for (std::size_t j = 0; j < count_; ++j) points_[j] += length * change_[j];
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        State& state = states_[j];
        state.value += length * state.shift;
        for (Bound* bound : {&state.lower, &state.upper}) {
            bound->distance += length * bound->distance_change;
            bound->press += length * bound->press_change;
        }
    }
}

}  // namespace psicarve::plan
