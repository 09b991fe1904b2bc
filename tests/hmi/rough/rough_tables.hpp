// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "hmi/rough/roughing.hpp"
#include "shared/base/units.hpp"

namespace psicarve::rough {

inline constexpr std::uint32_t kPoints = 19;

/// [mm], of the tip at a height.
using TipRadius = std::function<double(double direction_rad, double height_mm)>;

inline JobTable table_of(const Profile& profile, std::uint32_t layers, double pitch_mm, Joining joining,
                         const TipRadius& tip, std::uint32_t points = kPoints) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = 20.0;
    table.joining = joining;
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        const double height_mm = 4.0 + pitch_mm * layer;
        table.layer_height_pulses.push_back(pulses_from_mm(height_mm, profile.y.pulses_per_mm));
        for (std::uint32_t point = 0; point < points; ++point) {
            const double turned = joining == Joining::zigzag ? 0.0 : layer;
            const double psi = kPi * (turned + static_cast<double>(point) / (points - 1));
            const double over = psi + kPi + profile.head_r2_angle_error_deg * kPi / 180.0;
            const auto counted = [](const LinearAxisProfile& head, double mm) {
                return static_cast<std::int32_t>(pulses_from_mm(mm - head.tip_mm(), head.pulses_per_mm));
            };
            table.r_left_pulses.push_back(counted(profile.r1, tip(psi, height_mm)));
            table.r_right_pulses.push_back(
                counted(profile.r2, tip(over, height_mm + profile.head_r2_height_error_mm)));
        }
    }
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    return table;
}

inline RoughingSummary roughed(JobTable& table, const Profile& profile, const RoughingOptions& options) {
    const JobTable own = table;
    const auto summary = add_roughing(table, own, profile, options);
    EXPECT_TRUE(summary) << summary.error().message;
    return summary ? *summary : RoughingSummary{};
}

inline JobView checked_view(const std::vector<std::byte>& blob, const Profile& profile) {
    const auto view = JobView::check(blob);
    EXPECT_TRUE(view) << view.error().message;
    const auto good = check_job(*view, profile);
    EXPECT_TRUE(good) << good.error().message;
    return *view;
}

/// Smooth and steep, with flats further out than the blank.
inline TipRadius random_body(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<double> wave;
    for (int i = 0; i < 6; ++i) wave.push_back(static_cast<double>(random() % 1000) / 1000.0);
    return [wave](double direction, double height_mm) {
        const double sum = 6.5 + 2.0 * wave[0] * std::cos(2.0 * direction + 6.0 * wave[1]) +
                           3.0 * wave[2] * std::sin(1.5 * height_mm + 6.0 * wave[3]) +
                           1.5 * wave[4] * std::cos(5.0 * direction + height_mm + 6.0 * wave[5]);
        return std::clamp(sum, 3.0, 11.0);
    };
}

}  // namespace psicarve::rough
