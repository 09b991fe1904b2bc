// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::test {

/// A block with these places of the axes.
inline std::string block_to(const char* words, double r1_mm, double r2_mm, double psi_deg, double y_mm) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "%s X%.6f Z%.6f C%.6f Y%.6f\n", words, r1_mm, r2_mm, psi_deg,
                  y_mm);
    return text.data();
}

/// A table as a program: G1 from point to point with the spindle on, between layers out and in again by G0.
/// `path_words` as "G61" or "G64 P0.02".
inline std::string program_of_table(const JobView& table, const Profile& profile,
                                    const std::string& path_words) {
    constexpr double kOut_mm = 10.0;
    const auto at = [&](const char* words, std::uint32_t layer, std::uint32_t step, double out_mm) {
        const std::uint32_t point = carved_point(table.joining(), table.point_count(), layer, step);
        return block_to(words, table.r_left_pulses(layer)[point] / profile.r1.pulses_per_mm + out_mm,
                        table.r_right_pulses(layer)[point] / profile.r2.pulses_per_mm + out_mm,
                        360.0 * static_cast<double>(table.psi_pulses(layer, point)) /
                            static_cast<double>(profile.psi.pulses_per_rev),
                        static_cast<double>(table.y_pulses(layer, point)) / profile.y.pulses_per_mm);
    };
    const std::uint32_t last = table.point_count() - 1;
    std::string text = "G21 G90 G94 " + path_words + " F1200\n" + at("G0", 0, 0, kOut_mm) + "M3\n";
    for (std::uint32_t layer = 0; layer < table.layer_count(); ++layer) {
        if (layer > 0) text += at("G0", layer - 1, last, kOut_mm) + at("G0", layer, 0, kOut_mm);
        for (std::uint32_t step = 0; step <= last; ++step) text += at("G1", layer, step, 0.0);
    }
    return text + at("G0", table.layer_count() - 1, last, kOut_mm) + "M5\nM2\n";
}

}  // namespace psicarve::test
