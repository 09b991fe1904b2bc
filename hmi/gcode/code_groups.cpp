// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/code_groups.hpp"

#include <array>
#include <initializer_list>

namespace psicarve::gcode {
namespace {

constexpr std::size_t kGCodeCount = 1000;  // in tenths
constexpr std::size_t kMCodeCount = 100;

template <std::size_t kCount>
constexpr void set_standing(std::array<CodeEntry, kCount>& table, CodeStanding standing,
                            std::initializer_list<int> codes) {
    for (const int code : codes) table[static_cast<std::size_t>(code)].standing = standing;
}

template <std::size_t kCount>
constexpr void set_group(std::array<CodeEntry, kCount>& table, CodeGroup group,
                         std::initializer_list<int> codes) {
    for (const int code : codes) table[static_cast<std::size_t>(code)] = {CodeStanding::known, group};
}

constexpr std::array<CodeEntry, kGCodeCount> make_g_codes() {
    std::array<CodeEntry, kGCodeCount> table{};
    set_group(table, CodeGroup::once, {40, 100, 280, 281, 300, 301, 530, 920, 921, 922, 923});
    set_group(table, CodeGroup::motion, {0, 10, 20, 30, 800, 810, 820, 830});
    set_group(table, CodeGroup::plane, {170, 180, 190});
    set_group(table, CodeGroup::distance, {900, 910});
    set_group(table, CodeGroup::arc_distance, {901, 911});
    set_group(table, CodeGroup::feed_mode, {930, 940, 950});
    set_group(table, CodeGroup::units, {200, 210});
    set_group(table, CodeGroup::compensation, {400});
    set_group(table, CodeGroup::length, {431, 490});
    set_group(table, CodeGroup::retract, {980, 990});
    set_group(table, CodeGroup::system, {540, 550, 560, 570, 580, 590, 591, 592, 593});
    set_group(table, CodeGroup::path, {610, 611, 640});
    set_group(table, CodeGroup::drawing, {71, 121, 131});
    set_standing(table, CodeStanding::compensation, {410, 411, 420, 421});
    set_standing(table, CodeStanding::tool_table, {430, 432});
    return table;
}

constexpr std::array<CodeEntry, kMCodeCount> make_m_codes() {
    std::array<CodeEntry, kMCodeCount> table{};
    set_group(table, CodeGroup::outputs, {62, 63, 64, 65, 66});
    set_group(table, CodeGroup::tool, {6});
    set_group(table, CodeGroup::spindle, {3, 4, 5});
    set_group(table, CodeGroup::coolant, {7, 8, 9});
    set_group(table, CodeGroup::overrides, {48, 49, 50, 51, 52, 53});
    set_group(table, CodeGroup::stop, {0, 1, 2, 30, 60, 98, 99});
    return table;
}

constexpr auto kGCodes = make_g_codes();
constexpr auto kMCodes = make_m_codes();

template <std::size_t kCount>
CodeEntry entry_of(const std::array<CodeEntry, kCount>& table, int code) noexcept {
    const bool is_inside = code >= 0 && static_cast<std::size_t>(code) < kCount;
    return is_inside ? table[static_cast<std::size_t>(code)] : CodeEntry{};
}

}  // namespace

CodeEntry g_code_entry(int tenths) noexcept {
    return entry_of(kGCodes, tenths);
}

CodeEntry m_code_entry(int number) noexcept {
    return entry_of(kMCodes, number);
}

}  // namespace psicarve::gcode
