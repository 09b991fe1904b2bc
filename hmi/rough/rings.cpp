// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/rings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/base/units.hpp"

namespace psicarve::rough {
namespace {

// For a radius that is a whole number of pulses but for the rounding of its calculation.
constexpr double kRounding = 1e-6;
constexpr double kUnreachablePulses = 1e9;

RoughHead rough_head(const Profile& profile, Axis name) {
    const LinearAxisProfile& axis = name == Axis::r1 ? profile.r1 : profile.r2;
    const AxisMotion motion = axis_motion(profile, name);
    RoughHead head;
    head.pulses_per_mm = axis.pulses_per_mm;
    head.tip_mm = axis.tip_mm();
    head.least =
        static_cast<std::int32_t>(std::max(core_radius_pulses(profile, name), motion.travel_min_pulses));
    head.travel = static_cast<std::int32_t>(
        std::min<std::int64_t>(motion.travel_max_pulses, std::numeric_limits<std::int32_t>::max()));
    return head;
}

}  // namespace

std::int32_t RoughHead::counted_outside(double real_mm) const noexcept {
    const double counted = std::ceil((real_mm - tip_mm) * pulses_per_mm - kRounding);
    return static_cast<std::int32_t>(std::clamp(counted, -kUnreachablePulses, kUnreachablePulses));
}

std::int32_t RoughHead::standing_outside(double real_mm) const noexcept {
    return std::max(least, counted_outside(real_mm));
}

std::size_t first_cell(Joining joining, std::size_t point_count, std::size_t layer) noexcept {
    return joining != Joining::zigzag && layer % 2 != 0 ? point_count - 1 : 0;
}

Rings::Rings(const JobTable& table, const Profile& profile)
    : cells_(2 * (std::size_t{table.point_count} - 1)),
      y_pulses_per_mm_(profile.y.pulses_per_mm),
      heads_agree_(profile.head_r2_angle_error_deg == 0.0 && profile.head_r2_height_error_mm == 0.0),
      heads_{rough_head(profile, Axis::r1), rough_head(profile, Axis::r2)},
      heights_(table.layer_height_pulses) {
    heads_[1].turn_rad =
        rad_from_pulses(pulses_from_deg(profile.head_r2_angle_error_deg, profile.psi.pulses_per_rev),
                        profile.psi.pulses_per_rev);
    heads_[1].height_mm = profile.head_r2_height_error_mm;
    for (auto& tips : tips_) tips.resize(heights_.size() * cells_);
    for (std::size_t h = 0; h < kHeads; ++h) take(table, h);
    for (std::size_t h = 0; h < kHeads; ++h) fill_other_half(table, h);
}

void Rings::take(const JobTable& table, std::size_t h) {
    const auto& radii = h == 0 ? table.r_left_pulses : table.r_right_pulses;
    const std::size_t points = point_count();
    for (std::size_t ring = 0; ring < heights_.size(); ++ring) {
        const std::size_t first = first_cell(table.joining, points, ring) + h * (points - 1);
        for (std::size_t point = 0; point < points; ++point) {
            tips_[h][ring * cells_ + (first + point) % cells_] = radii[ring * points + point];
        }
    }
}

void Rings::fill_other_half(const JobTable& table, std::size_t h) {
    const std::size_t points = point_count();
    const std::size_t other = 1 - h;
    const double turn_rad = std::abs(heads_[1].turn_rad);
    const auto aside = static_cast<std::size_t>(std::ceil(turn_rad / direction_rad(1) - kRounding));
    const double pitch = pitch_mm();
    const double rise_mm = std::abs(heads_[1].height_mm);
    const auto up = pitch > 0.0 ? static_cast<std::size_t>(std::ceil(rise_mm / pitch - kRounding)) : 0;
    const auto own_begin = [&](std::size_t ring, std::size_t of) {
        return first_cell(table.joining, points, ring) + of * (points - 1);
    };
    for (std::size_t ring = 0; ring < heights_.size(); ++ring) {
        const std::size_t first = own_begin(ring, other);
        for (std::size_t point = 1; point + 1 < points; ++point) {
            const std::size_t cell = (first + point) % cells_;
            double most_mm = -kUnreachablePulses;
            const std::size_t low = ring - std::min(up, ring);
            const std::size_t high = std::min(ring + up, heights_.size() - 1);
            for (std::size_t near = low; near <= high; ++near) {
                for (std::size_t turn = 0; turn <= 2 * aside; ++turn) {
                    const std::size_t at = (cell + cells_ + turn - aside) % cells_;
                    // In that ring this is the other head's half, or this head's own table has it.
                    const std::size_t along = (at + cells_ - own_begin(near, other) % cells_) % cells_;
                    const std::size_t knows = along < points ? other : h;
                    const std::int32_t counted = tips_[knows][near * cells_ + at];
                    most_mm = std::max(most_mm, heads_[knows].real_mm(counted));
                }
            }
            tips_[h][ring * cells_ + cell] = heads_[h].standing_outside(most_mm);
        }
    }
}

double Rings::most_about_mm(std::size_t low_ring, std::size_t high_ring, std::size_t cell) const noexcept {
    const double pitch = pitch_mm();
    const double rise_mm = std::abs(heads_[1].height_mm);
    const auto up = 1 + (pitch > 0.0 ? static_cast<std::size_t>(std::ceil(rise_mm / pitch - kRounding)) : 0);
    const auto aside =
        1 + static_cast<std::size_t>(std::ceil(std::abs(heads_[1].turn_rad) / direction_rad(1) - kRounding));
    double most_mm = -kUnreachablePulses;
    const std::size_t end = std::min(high_ring + up + 1, heights_.size());
    for (std::size_t ring = low_ring - std::min(low_ring, up); ring < end; ++ring) {
        for (std::size_t turn = 0; turn <= 2 * aside; ++turn) {
            const std::size_t at = (cell + cells_ + turn - std::min(aside, cells_)) % cells_;
            for (std::size_t h = 0; h < kHeads; ++h)
                most_mm = std::max(most_mm, heads_[h].real_mm(tip(h, ring, at)));
        }
    }
    return most_mm;
}

double Rings::pitch_mm() const noexcept {
    double least = std::numeric_limits<double>::max();
    for (std::size_t ring = 1; ring < heights_.size(); ++ring)
        least = std::min(least, height_mm(ring) - height_mm(ring - 1));
    return heights_.size() > 1 ? least : 0.0;
}

double Rings::least_tip_mm() const noexcept {
    double least = std::numeric_limits<double>::max();
    for (std::size_t h = 0; h < kHeads; ++h)
        least = std::min(least, heads_[h].real_mm(*std::min_element(tips_[h].begin(), tips_[h].end())));
    return least;
}

double Rings::direction_rad(std::size_t cell) const noexcept {
    return 2.0 * kPi * static_cast<double>(cell) / static_cast<double>(cells_);
}

}  // namespace psicarve::rough
