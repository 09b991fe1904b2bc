// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/soft_limits.hpp"

#include <algorithm>

namespace psicarve::cycle {
namespace {

using Pulses4 = std::array<std::int64_t, kAxisCount>;

bool leaves(std::int64_t from, std::int64_t to, std::int64_t least, std::int64_t most) noexcept {
    return (to < least && to < from) || (to > most && to > from);
}

double sum_mm(const SoftLimits& limits, const Pulses4& at) noexcept {
    return static_cast<double>(at[0]) * limits.mm_per_pulse[0] +
           static_cast<double>(at[1]) * limits.mm_per_pulse[1];
}

/// The least position of a head that the other one leaves room for.
std::int64_t least_beside_other(const SoftLimits& limits, const Pulses4& at, std::size_t head) noexcept {
    const std::size_t other = 1 - head;
    const double room_mm = limits.least_sum_mm - static_cast<double>(at[other]) * limits.mm_per_pulse[other];
    auto least = static_cast<std::int64_t>(room_mm / limits.mm_per_pulse[head]) - 1;
    while (static_cast<double>(least) * limits.mm_per_pulse[head] < room_mm) ++least;
    return least;
}

}  // namespace

SoftBreach first_breach(const SoftLimits& limits, const Pulses4& from, const Pulses4& to) noexcept {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const auto axis = static_cast<std::uint8_t>(k);
        if (k < kHeads && to[k] < limits.core_pulses[k] && to[k] < from[k] &&
            limits.core_pulses[k] >= limits.least_pulses[k]) {
            return {SoftLimit::core_radius, axis};
        }
        if (leaves(from[k], to[k], limits.least_pulses[k], limits.most_pulses[k])) {
            return {SoftLimit::travel, axis};
        }
    }
    const double sum = sum_mm(limits, to);
    if (sum < limits.least_sum_mm && sum < sum_mm(limits, from)) {
        const bool second_moves_in = to[1] < from[1] && to[0] >= from[0];
        return {SoftLimit::head_clearance, static_cast<std::uint8_t>(second_moves_in ? 1 : 0)};
    }
    return {};
}

std::int64_t furthest_pulses(const SoftLimits& limits, const Pulses4& from, std::size_t axis,
                             bool up) noexcept {
    if (up) return std::max(from[axis], limits.most_pulses[axis]);
    std::int64_t least = limits.least_pulses[axis];
    if (axis < kHeads) {
        least = std::max({least, limits.core_pulses[axis], least_beside_other(limits, from, axis)});
    }
    return std::min(from[axis], least);
}

Pulses4 furthest_of_heads(const SoftLimits& limits, const Pulses4& from, bool out) noexcept {
    // Inwards they share what is left between the tips.
    double way_mm = out ? 1e9 : std::max(0.0, (sum_mm(limits, from) - limits.least_sum_mm) / 2.0);
    for (std::size_t k = 0; k < kHeads; ++k) {
        const std::int64_t alone = furthest_pulses(limits, from, k, out) - from[k];
        way_mm = std::min(way_mm, static_cast<double>(out ? alone : -alone) * limits.mm_per_pulse[k]);
    }
    Pulses4 to = from;
    for (std::size_t k = 0; k < kHeads; ++k) {
        const auto way = static_cast<std::int64_t>(way_mm / limits.mm_per_pulse[k] + 1e-9);
        to[k] += out ? way : -way;
    }
    return to;
}

}  // namespace psicarve::cycle
