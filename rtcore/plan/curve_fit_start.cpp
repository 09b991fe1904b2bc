// SPDX-License-Identifier: GPL-3.0-or-later
// Where a fit begins: the curve in the middle of its tube, and how hard the bounds press on it.
#include <algorithm>
#include <cmath>

#include "rtcore/plan/curve_fit.hpp"

namespace psicarve::plan {
namespace {

// At the start bounds press by about what it takes to bend the curve there: so much of it, averaged over the
// neighbours with weights that fall by the factor kPressMemory a node, and a part of it evenly.
constexpr double kPressShare = 0.2;
constexpr double kPressMemory = 0.7;
constexpr double kEvenShare = 0.4;

}  // namespace

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
        const BendingForms::Row& row = forms_.bend[j];
        const Vec force =
            forms_.weight[j].axes * (row.at * (row.before * before + row.at * at + row.after * after));
        side_[j].axes = force < 0.0 ? -force : force;
        mean += side_[j].axes;
        const BendingForms::Row& value = forms_.value[j];
        states_[j].residual =
            value.before * before + value.at * at + value.after * after - states_[j].residual;
    }
    mean /= static_cast<double>(count_ - 2);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        mean[k] = std::max(mean[k], kAccelTolerance * accel_[k] * std::abs(forms_.bend[1].at));
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

}  // namespace psicarve::plan
