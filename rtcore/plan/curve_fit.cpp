// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_fit.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::plan {
namespace {

constexpr int kMostIterations = 40;
// How much more bending than necessary is left, as a share of it: ten times less of time.
constexpr double kBendingTolerance = 1e-2;
constexpr double kBoundTolerancePulses = 0.02;
// How close to a bound one iteration may go.
constexpr double kBoundShare = 0.995;
// The length of a step that shrinks something by `shrink` per unit: not to nothing.
void length_within(const Vec& shrink, Vec& length) {
    const Vec most = Vec{} + kBoundShare;
    length = shrink > most ? most / shrink : Vec{} + 1.0;
}

}  // namespace

void CurveFit::solve(const NodesView& nodes, const DecidedEnds& decided) {
    count_ = nodes.cell.size();
    forms_.set(nodes);
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

// Goes the last step to its end and builds the matrix of the next: stiffness + value' * (press / distance) *
// value = L D L', and the predictor's right side, forwards through L. A row is complete once the node after
// it is known.
PSICARVE_FOR_WIDE_REGISTERS
void CurveFit::advance_and_eliminate() {
    BandElimination rows;
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
            const BendingForms::Row& row = forms_.bend[j + 1];
            const Vec bent =
                row.before * points_[j].axes + row.at * points_[j + 1].axes + row.after * points_[j + 2].axes;
            bend_after = forms_.weight[j + 1].axes * bent;
            bending += bent * bend_after;
        }
        if (j >= begin_ && j < end_) {
            const BendingForms::Row &before = forms_.value[j - 1], &at = forms_.value[j],
                                    &after = forms_.value[j + 1];
            BandRow& band = band_[j];
            band.at = forms_.stiffness[j][0].axes + weight_after * (after.before * after.before) +
                      weight * (at.at * at.at) + weight_before * (before.after * before.after);
            band.next = forms_.stiffness[j][1].axes + weight_after * (after.before * after.at) +
                        weight * (at.at * at.after);
            band.second = forms_.stiffness[j][2].axes + weight_after * (after.before * after.after);
            Vec side = after.before * push_after + at.at * push + before.after * push_before -
                       forms_.bend[j + 1].before * bend_after - forms_.bend[j].at * bend -
                       forms_.bend[j - 1].after * bend_before;
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
        const double allowed = 0.5 * (kBendingTolerance * bending_[k] + least * least * forms_.length);
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
    BandElimination rows;
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
            const BendingForms::Row& row = forms_.value[j + 1];
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
    BandElimination rows;
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
            Vec side = forms_.value[j + 1].before * push_after + forms_.value[j].at * push +
                       forms_.value[j - 1].after * push_before;
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
    BandElimination rows;
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
            const BendingForms::Row& row = forms_.value[j + 1];
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
