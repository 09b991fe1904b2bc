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
constexpr double kBoundShare = 0.995;
// At the start bounds press by about what it takes to bend the curve there: so much of it, averaged over the
// neighbours with weights that fall by the factor kPressMemory a node, and a part of it evenly.
constexpr double kPressShare = 0.2;
constexpr double kPressMemory = 0.7;
constexpr double kEvenShare = 0.4;

// The length of a step that shrinks something by `shrink` per unit: not to nothing.
void length_within(const Vec& shrink, Vec& length) {
    const Vec most = Vec{} + kBoundShare;
    length = shrink > most ? most / shrink : Vec{} + 1.0;
}

}  // namespace

/// Rows of a band matrix, one after the other: what those before take off the present one.
class CurveFit::Elimination {
public:
    /// at becomes 1 / pivot, next and second the factors.
    PSICARVE_INLINE void eliminate(Band& row) {
        row.at = (row.at - at_by_second_) - at_by_next_;
        row.next -= next_by_both_;
        const Vec inverse = 1.0 / row.at;
        at_by_second_ = at_after_;
        at_by_next_ = row.next * row.next * inverse;
        next_by_both_ = row.next * row.second * inverse;
        at_after_ = row.second * row.second * inverse;
        row.at = inverse;
        row.next *= inverse;
        row.second *= inverse;
    }
    PSICARVE_INLINE void substitute(const Band& row, Vec& side) {
        side = (side - side_by_second_) - side_by_next_;
        side_by_second_ = side_after_;
        side_by_next_ = row.next * side;
        side_after_ = row.second * side;
    }
    /// Backwards: `side` went forwards through the rows' factors.
    PSICARVE_INLINE void substitute_back(const Band& row, Vec& side) {
        side = (side * row.at - row.second * side_by_second_) - row.next * side_by_next_;
        side_by_second_ = side_by_next_;
        side_by_next_ = side;
    }

private:
    Vec at_by_second_{}, at_by_next_{}, at_after_{}, next_by_both_{};
    Vec side_by_second_{}, side_by_next_{}, side_after_{};
};

void CurveFit::solve(const NodesView& nodes, const DecidedEnds& decided) {
    prepare(nodes);
    start(nodes, decided);
    for (iterations_ = 0;; ++iterations_) {
        advance_and_eliminate();
        has_converged_ = note_converged();
        if (has_converged_ || iterations_ == kMostIterations) break;
        Reach reach;
        Vec target;
        predict(reach);
        target_after(reach, target);
        correct(target);
        reach_corrected(target, reach);
        set_steps(reach);
    }
    control_.resize(count_);
    for (std::size_t j = 0; j < count_; ++j) store(points_[j].axes, control_[j]);
    mend(nodes);
}

// Should rounding ever get the better of an axis, its curve through the middle of the tube is slower, and
// safe.
void CurveFit::mend(const NodesView& nodes) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const auto is_good = [k](const Lanes& control) { return std::isfinite(control[k]); };
        if (std::all_of(control_.begin(), control_.end(), is_good)) continue;
        for (std::size_t j = 0; j < count_; ++j) control_[j][k] = 0.5 * (nodes.low[j][k] + nodes.high[j][k]);
    }
}

PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::prepare(const NodesView& nodes) {
    count_ = nodes.cell.size();
    bend_.assign(count_, Row{});
    value_.assign(count_, Row{0.0, 1.0, 0.0});
    weight_.resize(count_);
    for (std::size_t j = 0; j < count_; ++j) load(nodes.weight[j], weight_[j].axes);
    stiffness_.assign(count_, {});
    length_ = 0.0;
    double after = 1.0 / nodes.control_step[0];
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const double before = after;
        after = 1.0 / nodes.control_step[j];
        const double cell = nodes.cell[j];
        length_ += cell;
        const double first = before / cell;
        const double last = after / cell;
        const double offset = nodes.offset[j];
        const double lift = 0.125 * cell * cell + 0.5 * offset * offset;
        const double tilt = 0.5 * offset;
        value_[j] = {lift * first - tilt * before, 1.0 - lift * (first + last) + tilt * (before - after),
                     lift * last + tilt * after};
        const double root = std::sqrt(cell);
        const Row row{root * first, -root * (first + last), root * last};
        bend_[j] = row;
        const Vec weight = weight_[j].axes;
        stiffness_[j - 1][0].axes += weight * (row.before * row.before);
        stiffness_[j - 1][1].axes += weight * (row.before * row.at);
        stiffness_[j - 1][2].axes += weight * (row.before * row.after);
        stiffness_[j][0].axes += weight * (row.at * row.at);
        stiffness_[j][1].axes += weight * (row.at * row.after);
        stiffness_[j + 1][0].axes += weight * (row.after * row.after);
    }
}

PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::start(const NodesView& nodes, const DecidedEnds& decided) {
    points_.resize(count_);
    side_.resize(count_);
    states_.resize(count_);
    band_.resize(count_);
    change_.resize(count_);
    begin_ = std::max<std::size_t>(1, decided.first.size());
    end_ = count_ - std::max<std::size_t>(1, decided.last.size());
    for (std::size_t j = 0; j < count_; ++j) {
        Vec low;
        Vec high;
        load(nodes.low[j], low);
        load(nodes.high[j], high);
        points_[j].axes = 0.5 * (low + high);
        const Vec half = 0.5 * (high - low);
        // The middle, until all control points are known.
        states_[j] = State{points_[j].axes, Vec{}, {half, Vec{}, Vec{}, Vec{}}, {half, Vec{}, Vec{}, Vec{}}};
    }
    for (std::size_t j = 0; j < decided.first.size(); ++j) load(decided.first[j], points_[j].axes);
    for (std::size_t j = 0; j < decided.last.size(); ++j) {
        load(decided.last[j], points_[count_ - decided.last.size() + j].axes);
    }
    start_pressing();
    is_done_ = Mask{};
    left_ = Vec{} + 1.0;
    distance_step_ = press_step_ = Vec{};
}

PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::start_pressing() {
    Vec mean{};
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        const Vec &before = points_[j - 1].axes, &at = points_[j].axes, &after = points_[j + 1].axes;
        const Row& row = bend_[j];
        const Vec force =
            weight_[j].axes * (row.at * (row.before * before + row.at * at + row.after * after));
        side_[j].axes = force < 0.0 ? -force : force;
        mean += side_[j].axes;
        const Row& value = value_[j];
        states_[j].residual =
            value.before * before + value.at * at + value.after * after - states_[j].residual;
    }
    mean /= static_cast<double>(count_ - 2);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        mean[k] = std::max(mean[k], kAccelTolerance * accel_[k] * std::abs(bend_[1].at));
    }
    Vec near = mean;
    for (std::size_t j = 1; j + 1 < count_; ++j) {
        near = kPressMemory * near + (1.0 - kPressMemory) * side_[j].axes;
        change_[j].axes = near;
    }
    near = mean;
    for (std::size_t j = count_ - 2; j > 0; --j) {
        near = kPressMemory * near + (1.0 - kPressMemory) * side_[j].axes;
        const Vec around = 0.5 * (near + change_[j].axes);
        State& state = states_[j];
        state.lower.press = state.upper.press =
            kPressShare * (kEvenShare * mean + (1.0 - kEvenShare) * around);
    }
    for (Four& change : change_) change.axes = Vec{};
}

// Goes the last step to its end and builds the matrix of the next: stiffness + value' * (press / distance) *
// value = L D L', and the predictor's right side, forwards through L. A row is complete once the node after
// it is known.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::advance_and_eliminate() {
    Elimination rows;
    Vec gap{}, bending{}, outside{};
    Vec weight_before{}, weight{}, push_before{}, push{}, bend_before{}, bend{};
    const Vec distance_step = distance_step_;
    const Vec press_step = press_step_;
    const Vec left = left_;
    points_[1].axes += distance_step * change_[1].axes;
    for (std::size_t j = 0; j + 1 < count_; ++j) {
        Vec weight_after{}, push_after{}, bend_after{};
        if (j + 2 < count_) {
            State& state = states_[j + 1];
            Bound &lower = state.lower, &upper = state.upper;
            lower.distance += distance_step * state.rise;
            upper.distance -= distance_step * state.rise;
            lower.press += press_step * lower.press_change;
            upper.press += press_step * upper.press_change;
            lower.inverse_distance = 1.0 / lower.distance;
            upper.inverse_distance = 1.0 / upper.distance;
            const Vec residual = left * state.residual;
            gap += lower.distance * lower.press + upper.distance * upper.press;
            raise_to(outside, Vec(-lower.distance - residual));
            raise_to(outside, Vec(residual - upper.distance));
            weight_after = lower.press * lower.inverse_distance + upper.press * upper.inverse_distance;
            push_after = -weight_after * residual;
            points_[j + 2].axes += distance_step * change_[j + 2].axes;
            const Row& row = bend_[j + 1];
            const Vec bent =
                row.before * points_[j].axes + row.at * points_[j + 1].axes + row.after * points_[j + 2].axes;
            bend_after = weight_[j + 1].axes * bent;
            bending += bent * bend_after;
        }
        if (j >= begin_ && j < end_) {
            const Row &before = value_[j - 1], &at = value_[j], &after = value_[j + 1];
            Band& band = band_[j];
            band.at = stiffness_[j][0].axes + weight_after * (after.before * after.before) +
                      weight * (at.at * at.at) + weight_before * (before.after * before.after);
            band.next = stiffness_[j][1].axes + weight_after * (after.before * after.at) +
                        weight * (at.at * at.after);
            band.second = stiffness_[j][2].axes + weight_after * (after.before * after.after);
            Vec side = after.before * push_after + at.at * push + before.after * push_before -
                       bend_[j + 1].before * bend_after - bend_[j].at * bend -
                       bend_[j - 1].after * bend_before;
            rows.eliminate(band);
            rows.substitute(band, side);
            side_[j].axes = side;
        }
        weight_before = weight;
        weight = weight_after;
        push_before = push;
        push = push_after;
        bend_before = bend;
        bend = bend_after;
    }
    gap_ = gap;
    bending_ = bending;
    outside_ = outside;
}

bool CurveFit::note_converged() {
    bool all_done = true;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double least = kAccelTolerance * accel_[k];
        const double allowed = 0.5 * (kBendingTolerance * bending_[k] + least * least * length_);
        // An axis that has arrived stays: driven on while others still need iterations, its gap would shrink
        // until nothing of it can be represented.
        is_done_[k] =
            is_done_[k] != 0 || (gap_[k] <= allowed && outside_[k] <= kBoundTolerancePulses) ? -1 : 0;
        all_done = all_done && is_done_[k] != 0;
    }
    return all_done;
}

// The way straight to the bounds: what it would change, without going.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::predict(Reach& reach) {
    Elimination rows;
    Vec distance_shrink{}, press_shrink{}, by_distance{}, by_press{}, by_both{};
    Vec at{}, after{};
    const Vec left = left_;
    for (std::size_t j = count_ - 1; j-- > 0;) {
        Vec change{};
        if (j >= begin_ && j < end_) {
            change = side_[j].axes;
            rows.substitute_back(band_[j], change);
        }
        change_[j].axes = change;
        if (j + 2 < count_) {
            const Row& row = value_[j + 1];
            State& state = states_[j + 1];
            Bound &lower = state.lower, &upper = state.upper;
            const Vec rise = row.before * change + row.at * at + row.after * after + left * state.residual;
            const Vec lower_share = rise * lower.inverse_distance;
            const Vec upper_share = rise * upper.inverse_distance;
            raise_to(distance_shrink, Vec(-lower_share));
            raise_to(distance_shrink, upper_share);
            raise_to(press_shrink, Vec(1.0 + lower_share));
            raise_to(press_shrink, Vec(1.0 - upper_share));
            state.rise = rise;
            lower.press_change = -lower.press * (1.0 + lower_share);
            upper.press_change = -upper.press * (1.0 - upper_share);
            by_distance += rise * (lower.press - upper.press);
            by_press += lower.distance * lower.press_change + upper.distance * upper.press_change;
            by_both += rise * (lower.press_change - upper.press_change);
        }
        after = at;
        at = change;
    }
    reach = {distance_shrink, press_shrink, by_distance, by_press, by_both};
}

// As far towards the bounds as the prediction says is worth it.
void CurveFit::target_after(const Reach& predicted, Vec& target) const {
    Vec distance_length;
    Vec press_length;
    length_within(predicted.distance_shrink, distance_length);
    length_within(predicted.press_shrink, press_length);
    const Vec possible = gap_ + distance_length * (predicted.by_distance + press_length * predicted.by_both) +
                         press_length * predicted.by_press;
    const Vec share = gap_ > 0.0 ? possible / gap_ : Vec{};
    target = share * share * share * gap_ / (2.0 * static_cast<double>(count_ - 2));
}

// Towards the middle by `target`, and what the prediction left out to second order: forwards through L.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::correct(const Vec& target) {
    Elimination rows;
    Vec push_before{}, push{};
    const Vec towards = target;
    for (std::size_t j = 0; j < end_; ++j) {
        Vec push_after{};
        if (j + 2 < count_) {
            const State& state = states_[j + 1];
            const Bound &lower = state.lower, &upper = state.upper;
            push_after = (towards - state.rise * lower.press_change) * lower.inverse_distance -
                         (towards + state.rise * upper.press_change) * upper.inverse_distance;
        }
        if (j >= begin_) {
            Vec side =
                value_[j + 1].before * push_after + value_[j].at * push + value_[j - 1].after * push_before;
            rows.substitute(band_[j], side);
            side_[j].axes = side;
        }
        push_before = push;
        push = push_after;
    }
}

// Both together: the step, and how far it can go.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::reach_corrected(const Vec& target, Reach& reach) {
    Elimination rows;
    Vec distance_shrink{}, press_shrink{};
    Vec at{}, after{};
    const Vec left = left_;
    const Vec towards = target;
    for (std::size_t j = count_ - 1; j-- > 0;) {
        Vec change{};
        if (j >= begin_ && j < end_) {
            Vec side = side_[j].axes;
            rows.substitute_back(band_[j], side);
            change = change_[j].axes + side;
        }
        change_[j].axes = change;
        if (j + 2 < count_) {
            const Row& row = value_[j + 1];
            State& state = states_[j + 1];
            Bound &lower = state.lower, &upper = state.upper;
            const Vec rise = row.before * change + row.at * at + row.after * after + left * state.residual;
            const Vec lower_share = rise * lower.inverse_distance;
            const Vec upper_share = rise * upper.inverse_distance;
            lower.press_change = (towards - state.rise * lower.press_change) * lower.inverse_distance -
                                 lower.press * (1.0 + lower_share);
            upper.press_change = (towards + state.rise * upper.press_change) * upper.inverse_distance -
                                 upper.press * (1.0 - upper_share);
            state.rise = rise;
            raise_to(distance_shrink, Vec(-lower_share));
            raise_to(distance_shrink, upper_share);
            raise_to(press_shrink, Vec(-lower.press_change / lower.press));
            raise_to(press_shrink, Vec(-upper.press_change / upper.press));
        }
        after = at;
        at = change;
    }
    reach = {distance_shrink, press_shrink, Vec{}, Vec{}, Vec{}};
}

// Curve and presses each go as far as they can by themselves: the right side of the next step asks nothing
// of the presses.
void CurveFit::set_steps(const Reach& reach) {
    length_within(reach.distance_shrink, distance_step_);
    length_within(reach.press_shrink, press_step_);
    distance_step_ = is_done_ ? Vec{} : distance_step_;
    press_step_ = is_done_ ? Vec{} : press_step_;
    left_ *= 1.0 - distance_step_;
}

}  // namespace psicarve::plan
