// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve {

// The only place that knows how many seconds, degrees or nanoseconds make another unit.
// A position inside the motion code is a whole number of pulses (int64); mm and degrees live in files and
// windows.

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegPerRev = 360.0;
inline constexpr std::int64_t kNsPerS = 1'000'000'000;
inline constexpr std::int64_t kNsPerUs = 1'000;
inline constexpr std::int64_t kNsPerMs = 1'000'000;

/// Nearest whole number, halves away from zero; the same on every machine (no rounding mode, no libm).
/// Requires |value| < 2^62. RT: yes.
constexpr std::int64_t round_to_pulse(double value) noexcept {
    // Not value + 0.5: that sum itself rounds, just below a half and above 2^52.
    const auto whole = static_cast<std::int64_t>(value);
    const double rest = value - static_cast<double>(whole);
    return rest >= 0.5 ? whole + 1 : (rest <= -0.5 ? whole - 1 : whole);
}

constexpr std::int64_t pulses_from_mm(double length_mm, double pulses_per_mm) noexcept {
    return round_to_pulse(length_mm * pulses_per_mm);
}
constexpr double mm_from_pulses(std::int64_t length_pulses, double pulses_per_mm) noexcept {
    return static_cast<double>(length_pulses) / pulses_per_mm;
}
constexpr std::int64_t pulses_from_deg(double angle_deg, std::int64_t pulses_per_rev) noexcept {
    return round_to_pulse(angle_deg * static_cast<double>(pulses_per_rev) / kDegPerRev);
}
constexpr double deg_from_pulses(std::int64_t angle_pulses, std::int64_t pulses_per_rev) noexcept {
    return static_cast<double>(angle_pulses) * kDegPerRev / static_cast<double>(pulses_per_rev);
}
constexpr double rad_from_deg(double angle_deg) noexcept {
    return angle_deg * (2.0 * kPi / kDegPerRev);
}
constexpr double deg_from_rad(double angle_rad) noexcept {
    return angle_rad * (kDegPerRev / (2.0 * kPi));
}
constexpr double rad_from_pulses(std::int64_t angle_pulses, std::int64_t pulses_per_rev) noexcept {
    return static_cast<double>(angle_pulses) * (2.0 * kPi) / static_cast<double>(pulses_per_rev);
}
constexpr double seconds_from_ns(std::int64_t time_ns) noexcept {
    return static_cast<double>(time_ns) / static_cast<double>(kNsPerS);
}

/// Whole ticks that cover a time; 0 ns needs none. Requires period_ns > 0. RT: yes.
constexpr std::int64_t ticks_covering_ns(std::int64_t time_ns, std::int64_t period_ns) noexcept {
    return (time_ns + period_ns - 1) / period_ns;
}

/// Table angle of point `point_index` within a layer: round(j * sweep / (count - 1)), in whole numbers.
/// Requires point_count >= 2, psi_sweep_pulses >= 0 and a product below 2^62. RT: yes.
constexpr std::int64_t point_angle_pulses(std::int64_t point_index, std::int64_t psi_sweep_pulses,
                                          std::int64_t point_count) noexcept {
    const std::int64_t steps = point_count - 1;
    return (2 * point_index * psi_sweep_pulses + steps) / (2 * steps);
}

}  // namespace psicarve
