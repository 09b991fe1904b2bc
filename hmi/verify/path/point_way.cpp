// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path/point_way.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace psicarve::verify {

namespace {

constexpr double kHeightSlackPulses = 1.0;

}  // namespace

void Nearest::note(const Positions& now, const Positions& wanted) noexcept {
    std::int64_t most = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) most = std::max(most, std::abs(now[k] - wanted[k]));
    if (most > most_off) return;
    unsigned off = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) off |= now[k] != wanted[k] ? 1U << k : 0U;
    if (most == most_off && std::popcount(off) >= std::popcount(axes_off)) return;
    *this = {now, most, off};
}

std::optional<Axis> Nearest::only_axis_off() const noexcept {
    if (std::popcount(axes_off) != 1 || most_off > kNearPulses) return {};
    return static_cast<Axis>(std::countr_zero(axes_off));
}

void PointWay::aim(CarvePoint point) noexcept {
    point_ = point;
    near_ = {};
    closest_ = {};
    if (point.step != 1) link_from_.reset();
    from_ = to_;
    to_ = geometry_.target(point.layer, point.step);
    if (point.step == 0) return;
    psi_sign_ = to_[kPsi] >= from_[kPsi] ? 1 : -1;
    for (std::size_t h = 0; h < kHeadCount; ++h) lines_[h] = PathLine::between(geometry_, h, from_, to_);
}

PointWay::HeightLine PointWay::height_line(std::int64_t psi_pulses) const noexcept {
    const auto rise = static_cast<double>(to_[kY] - from_[kY]);
    const auto turn = static_cast<double>(to_[kPsi] - from_[kPsi]);
    if (rise == 0.0 || turn == 0.0) return {static_cast<double>(to_[kY]), kHeightSlackPulses};
    const double part = std::clamp(static_cast<double>(psi_pulses - from_[kPsi]) / turn, 0.0, 1.0);
    const double tolerance_pulses = geometry_.tolerance_mm() * geometry_.y_pulses_per_mm();
    // Psi is known to a pulse.
    return {static_cast<double>(from_[kY]) + part * rise,
            tolerance_pulses + kHeightSlackPulses + std::abs(rise / turn)};
}

bool PointWay::leads_not_out(const Positions& at) const noexcept {
    if (at[kPsi] != from_[kPsi] || at[kY] != from_[kY]) return false;
    bool is_on_lines = true;
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::int64_t outward = at[index_of(kHeads[h])] - from_[index_of(kHeads[h])];
        if (outward < 0) return false;
        is_on_lines = is_on_lines && lines_[h].distance(0, outward).is_allowed;
    }
    return !is_on_lines;
}

void PointWay::note_radii(const Positions& at) noexcept {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::size_t axis = index_of(kHeads[h]);
        auto& closest = closest_[h];
        if (!closest || std::abs(at[axis] - to_[axis]) < std::abs(*closest - to_[axis])) closest = at[axis];
    }
}

PointWay::Miss PointWay::miss(const Positions& at) const noexcept {
    if (const auto alone = near_.only_axis_off()) {
        // All other axes met there: so this one has lost its way.
        return {*alone, near_.most_off, near_.at[index_of(*alone)]};
    }
    Miss worst{Axis::psi, 0, at[kPsi]};
    const auto consider = [&](Axis axis, std::int64_t value) {
        const std::int64_t off = std::abs(value - to_[index_of(axis)]);
        if (off > worst.off) worst = {axis, off, value};
    };
    for (std::size_t h = 0; h < kHeadCount; ++h) consider(kHeads[h], closest(h, at));
    consider(Axis::y, at[kY]);
    return worst;
}

}  // namespace psicarve::verify
