// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/program_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "shared/base/units.hpp"

namespace psicarve::report {
namespace {

constexpr int kMostGCode = 1000;
constexpr int kMostMCode = 100;
constexpr int kFirstSystem = 540;
constexpr int kLastSystem = 593;

std::string g_text(int tenths) {
    std::string text = "G" + std::to_string(tenths / 10);
    return tenths % 10 == 0 ? text : text + "." + std::to_string(tenths % 10);
}

bool is_g_code(int tenths) noexcept {
    return tenths >= 0 && tenths < kMostGCode;
}

}  // namespace

std::string codes_text(const ProgramModes& modes) {
    std::string text;
    const auto add = [&text](const std::string& code) { text += (text.empty() ? "" : " ") + code; };
    for (const int code : modes.g_codes)
        if (is_g_code(code)) add(g_text(code));
    for (const int code : modes.m_codes)
        if (code >= 0 && code < kMostMCode) add("M" + std::to_string(code));
    return text;
}

std::string system_text(const ProgramModes& modes) {
    const auto system = std::ranges::find_if(
        modes.g_codes, [](int code) { return code >= kFirstSystem && code <= kLastSystem; });
    return system == modes.g_codes.end() ? std::string{} : g_text(*system);
}

std::string word_text(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

bool is_at_hand(const ProgramModes& modes, const ProgramStatus& status) noexcept {
    return modes.program == status.program && !codes_text(modes).empty() && status.sequence <= modes.sequence;
}

bool has_numbers(const std::array<double, kAxisCount>& values) noexcept {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

std::optional<std::array<double, kAxisCount>> to_go(const ProgramModes& modes, const ProgramStatus& status,
                                                    const CoreStatus& machine, const Profile& profile) {
    if (!is_at_hand(modes, status) || !has_numbers(modes.end)) return std::nullopt;
    std::array<double, kAxisCount> left{};
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        const double pulse = 1.0 / axis_motion(profile, axis).pulses_per_unit;
        left[k] = modes.end[k] - static_cast<double>(machine.position_pulses[k]) * pulse;
        // Where it ends it stands on the nearest pulse.
        if (std::abs(left[k]) <= 0.5 * pulse * (1.0 + 1e-6)) left[k] = 0.0;
    }
    return left;
}

}  // namespace psicarve::report
