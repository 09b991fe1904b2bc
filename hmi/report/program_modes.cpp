// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/program_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "shared/base/units.hpp"

namespace psicarve::report {
namespace {

/// Those that are active ones of a modal group, in tenths; a test compares them with the reader's.
constexpr int kGCodes[] = {0,   10,  20,  30,  71,  121, 131, 170, 180, 190, 200, 210, 400, 431,
                           490, 540, 550, 560, 570, 580, 590, 591, 592, 593, 610, 611, 640, 800,
                           810, 820, 830, 900, 901, 910, 911, 930, 940, 950, 980, 990};
constexpr int kMCodes[] = {3, 4, 5, 7, 8, 9, 48, 49};
constexpr int kFirstSystem = 540;
constexpr int kLastSystem = 593;
/// No number of a program is larger, in whatever unit.
constexpr double kMostNumber = 1e12;
constexpr std::int64_t kMostTool = 1'000'000'000'000'000;

std::string g_text(int tenths) {
    std::string text = "G" + std::to_string(tenths / 10);
    return tenths % 10 == 0 ? text : text + "." + std::to_string(tenths % 10);
}

bool is_g_code(int tenths) noexcept {
    return std::ranges::find(kGCodes, tenths) != std::ranges::end(kGCodes);
}

bool is_m_code(int code) noexcept {
    return std::ranges::find(kMCodes, code) != std::ranges::end(kMCodes);
}

bool is_number(double value) noexcept {
    return std::abs(value) <= kMostNumber;
}

/// Its outputs are going off: to where its program would lead it does not go any more.
bool has_given_up(MachineState state) noexcept {
    return state == MachineState::stopping || state == MachineState::alarm ||
           state == MachineState::backing_off;
}

}  // namespace

std::string codes_text(const ProgramModes& modes) {
    std::string text;
    const auto add = [&text](const std::string& code) { text += (text.empty() ? "" : " ") + code; };
    for (const int code : modes.g_codes)
        if (is_g_code(code)) add(g_text(code));
    for (const int code : modes.m_codes)
        if (is_m_code(code)) add("M" + std::to_string(code));
    return text;
}

std::string system_text(const ProgramModes& modes) {
    const auto system = std::ranges::find_if(modes.g_codes, [](int code) {
        return code >= kFirstSystem && code <= kLastSystem && is_g_code(code);
    });
    return system == modes.g_codes.end() ? std::string{} : g_text(*system);
}

std::string word_text(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::optional<double> shown_number(double value) noexcept {
    return is_number(value) ? std::optional{value} : std::nullopt;
}

std::optional<std::int64_t> shown_tool(const ProgramModes& modes) noexcept {
    return modes.tool >= 0 && modes.tool <= kMostTool ? std::optional{modes.tool} : std::nullopt;
}

std::string words_text(const ProgramModes& modes, std::string_view between) {
    std::string text;
    const auto add = [&](char letter, const std::string& value) {
        if (!text.empty()) text += between;
        text += std::string{letter} + " " + value;
    };
    if (is_number(modes.feed)) add('F', word_text(modes.feed));
    if (is_number(modes.speed_rpm)) add('S', word_text(modes.speed_rpm));
    if (const auto tool = shown_tool(modes)) add('T', std::to_string(*tool));
    return text;
}

bool is_at_hand(const ProgramModes& modes, const ProgramStatus& status) noexcept {
    return modes.program == status.program && !codes_text(modes).empty() && status.sequence <= modes.sequence;
}

bool has_numbers(const std::array<double, kAxisCount>& values) noexcept {
    return std::ranges::all_of(values, is_number);
}

std::optional<std::array<double, kAxisCount>> to_go(const ProgramModes& modes, const ProgramStatus& status,
                                                    const CoreStatus& machine, const Profile& profile) {
    if (!is_at_hand(modes, status) || !has_numbers(modes.end) || has_given_up(machine.state))
        return std::nullopt;
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
