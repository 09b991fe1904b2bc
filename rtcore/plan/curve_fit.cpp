// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_fit.hpp"

#include <algorithm>
#include <cmath>

// Four axes fit one AVX register. The same operations in the same order, so the same bits, with or without;
// sanitizers start too late for the linker's choice between the two.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PSICARVE_FOR_WIDE_REGISTERS __attribute__((target_clones("avx2", "default")))
#else
#define PSICARVE_FOR_WIDE_REGISTERS
#endif

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
        build_and_eliminate();
        substitute_back(change_);
        Vec length;
        const Reach predicted = predict();
        length_within(predicted.shrink, length);
        const Vec possible = gap_ + length * (predicted.linear + length * predicted.square);
        const Vec share = gap_ > 0.0 ? possible / gap_ : Vec{};
        const Vec target = share * share * share * gap_ / bound_count_;
        correct(target);
        const Reach reach = reach_corrected(target);
        length_within(reach.shrink, length);
        advance(is_done_ ? Vec{} : length);
    }
    control_.resize(count_);
    for (std::size_t j = 0; j < count_; ++j) {
        for (std::size_t k = 0; k < kAxisCount; ++k) control_[j][k] = points_[j].axes[k];
    }
    mend(nodes);
}

// Should rounding ever get the better of an axis, its curve through the middle of the tube is slower, and
// safe.
void CurveFit::mend(const CurveNodes& nodes) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const auto is_good = [k](const Lanes& control) { return std::isfinite(control[k]); };
        if (std::all_of(control_.begin(), control_.end(), is_good)) continue;
        for (std::size_t j = 0; j < count_; ++j) control_[j][k] = 0.5 * (nodes.low[j][k] + nodes.high[j][k]);
    }
}

PSICARVE_FOR_WIDE_REGISTERS
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
    is_done_ = Mask{};
    bound_count_ = 2.0 * static_cast<double>(count_ - 2);
}

PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::start(const CurveNodes& nodes, std::span<const Lanes> fixed) {
    points_.resize(count_);
    side_.resize(count_);
    states_.resize(count_);
    band_.resize(count_);
    change_.resize(count_);
    for (std::size_t j = 0; j < count_; ++j) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            states_[j].low[k] = nodes.low[j][k];
            states_[j].high[k] = nodes.high[j][k];
            points_[j].axes[k] = j < fixed.size() ? fixed[j][k] : 0.5 * (nodes.low[j][k] + nodes.high[j][k]);
        }
    }
    fixed_ = std::max<std::size_t>(1, fixed.size());
    // A press of about what it takes to bend the curve into the middle of its tube.
    Vec press{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = bend_[j];
        const Vec force = row.at * (row.before * points_[j - 1].axes + row.at * points_[j].axes +
                                    row.after * points_[j + 1].axes);
        press += force < 0.0 ? -force : force;
        states_[j].value = value_[j].before * points_[j - 1].axes + value_[j].at * points_[j].axes +
                           value_[j].after * points_[j + 1].axes;
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

PSICARVE_FOR_WIDE_REGISTERS
bool CurveFit::has_converged() {
    Vec gap{};
    Vec bending{};
    Vec outside{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = bend_[j];
        const State& state = states_[j];
        const Vec bend =
            row.before * points_[j - 1].axes + row.at * points_[j].axes + row.after * points_[j + 1].axes;
        bending += bend * bend;
        gap += state.lower.distance * state.lower.press + state.upper.distance * state.upper.press;
        raise_to(outside, Vec(state.low - state.value));
        raise_to(outside, Vec(state.value - state.high));
    }
    gap_ = gap;
    bool all_done = true;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double least = kAccelTolerance * accel_[k];
        const double allowed = 0.5 * (kBendingTolerance * bending[k] + least * least * length_);
        // An axis that has arrived stays: driven on while others still need iterations, its gap would shrink
        // until nothing of it can be represented.
        is_done_[k] = is_done_[k] != 0 || (gap[k] <= allowed && outside[k] <= kBoundTolerancePulses) ? -1 : 0;
        all_done = all_done && is_done_[k] != 0;
    }
    return all_done;
}

// One bound's pull on the matrix and on the right side of the predictor.
void CurveFit::weigh(State& state, Vec& weight, Vec& push) {
    Bound& lower = state.lower;
    Bound& upper = state.upper;
    lower.inverse_distance = 1.0 / lower.distance;
    upper.inverse_distance = 1.0 / upper.distance;
    const Vec lower_weight = lower.press * lower.inverse_distance;
    const Vec upper_weight = upper.press * upper.inverse_distance;
    weight = lower_weight + upper_weight;
    push = upper_weight * (state.high - state.value - upper.distance) -
           lower_weight * (state.value - state.low - lower.distance);
}

// stiffness + value' * (press / distance) * value = L D L', and the predictor's right side, forwards through
// L: in one pass, since a row is complete once the node after it is known.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::build_and_eliminate() {
    Elimination rows;
    Vec weight_before{};
    Vec weight{};
    Vec push_before{};
    Vec push{};
    Vec bend_before{};
    Vec bend{};
    for (std::size_t j = 0; j + 1 < count_; ++j) {
        Vec weight_after{};
        Vec push_after{};
        Vec bend_after{};
        if (j + 2 < count_) {
            weigh(states_[j + 1], weight_after, push_after);
            const Row& row = bend_[j + 1];
            bend_after =
                row.before * points_[j].axes + row.at * points_[j + 1].axes + row.after * points_[j + 2].axes;
        }
        if (j >= fixed_) {
            const Row& before = value_[j - 1];
            const Row& at = value_[j];
            const Row& after = value_[j + 1];
            Band& band = band_[j];
            band.at = stiffness_[j][0] + weight_after * (after.before * after.before) +
                      weight * (at.at * at.at) + weight_before * (before.after * before.after);
            band.next =
                stiffness_[j][1] + weight_after * (after.before * after.at) + weight * (at.at * at.after);
            band.second = stiffness_[j][2] + weight_after * (after.before * after.after);
            Vec side = after.before * push_after + at.at * push + before.after * push_before -
                       bend_[j + 1].before * bend_after - bend_[j].at * bend -
                       bend_[j - 1].after * bend_before;
            rows.eliminate(band);
            rows.substitute(band, side);
            change_[j].axes = side;
        }
        weight_before = weight;
        weight = weight_after;
        push_before = push;
        push = push_after;
        bend_before = bend;
        bend = bend_after;
    }
}

// Backwards: what the rows' factors make of a right side that went forwards through them.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::substitute_back(std::vector<Four>& side) const {
    for (std::size_t j = 0; j < fixed_; ++j) side[j].axes = Vec{};
    side[count_ - 1].axes = Vec{};
    Vec after{};
    Vec second{};
    for (std::size_t j = count_ - 1; j-- > fixed_;) {
        const Band& row = band_[j];
        side[j].axes = side[j].axes * row.at - row.next * after - row.second * second;
        second = after;
        after = side[j].axes;
    }
}

// The way straight to the bounds: what it would change, without going.
PSICARVE_FOR_WIDE_REGISTERS
CurveFit::Reach CurveFit::predict() {
    Reach reach{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = value_[j];
        State& state = states_[j];
        const Vec shift =
            row.before * change_[j - 1].axes + row.at * change_[j].axes + row.after * change_[j + 1].axes;
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
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::correct(const Vec& target) {
    Elimination rows;
    Vec push_before{};
    Vec push{};
    for (std::size_t j = 0; j + 1 < count_; ++j) {
        Vec push_after{};
        if (j + 2 < count_) {
            const Bound& lower = states_[j + 1].lower;
            const Bound& upper = states_[j + 1].upper;
            push_after = (target - lower.distance_change * lower.press_change) * lower.inverse_distance -
                         (target - upper.distance_change * upper.press_change) * upper.inverse_distance;
        }
        if (j >= fixed_) {
            Vec side =
                value_[j + 1].before * push_after + value_[j].at * push + value_[j - 1].after * push_before;
            rows.substitute(band_[j], side);
            side_[j].axes = side;
        }
        push_before = push;
        push = push_after;
    }
    substitute_back(side_);
    for (std::size_t j = fixed_; j + 1 < count_; ++j) change_[j].axes += side_[j].axes;
}

PSICARVE_FOR_WIDE_REGISTERS
CurveFit::Reach CurveFit::reach_corrected(const Vec& target) {
    Reach reach{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Row& row = value_[j];
        State& state = states_[j];
        state.shift =
            row.before * change_[j - 1].axes + row.at * change_[j].axes + row.after * change_[j + 1].axes;
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

PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::advance(const Vec& length) {
    for (std::size_t j = 0; j < count_; ++j) points_[j].axes += length * change_[j].axes;
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
