// SPDX-License-Identifier: GPL-3.0-or-later
// What a program can read of the machine. Source of numbers and names: LinuxCNC 2.9.
#include <algorithm>
#include <array>

#include "hmi/gcode/interpreter.hpp"

namespace psicarve::gcode {
namespace {

using Kind = StateAnswer::Kind;

/// Where nine axes have a parameter each.
constexpr std::uint32_t kFirstReference = 5161;
constexpr std::uint32_t kSecondReference = 5181;
constexpr std::uint32_t kShift = 5211;
constexpr std::uint32_t kSystems = 5221;
constexpr std::uint32_t kSystemStep = 20;
constexpr std::uint32_t kPlaces = 5420;

/// Of LinuxCNC: probing, M66, the tool table, faults of the tool changer.
constexpr bool is_foreign(std::uint32_t number) noexcept {
    return (number >= 5061 && number <= 5070) || number == 5399 || (number >= 5401 && number <= 5413) ||
           number >= 5600;
}

constexpr std::array<std::string_view, 16> kForeignNames{"_adaptive_feed",
                                                         "_ccomp",
                                                         "_current_pocket",
                                                         "_feed_hold",
                                                         "_feed_override",
                                                         "_ini",
                                                         "_hal",
                                                         "_lathe_diameter_mode",
                                                         "_lathe_radius_mode",
                                                         "_remap_level",
                                                         "_selected_pocket",
                                                         "_speed_override",
                                                         "_spindle_css_mode",
                                                         "_spindle_rpm_mode",
                                                         "_task",
                                                         "_vmajor"};

bool is_foreign_name(std::string_view name) noexcept {
    return name == "_vminor" || name.starts_with("_ini[") || name.starts_with("_hal[") ||
           std::find(kForeignNames.begin(), kForeignNames.end(), name) != kForeignNames.end();
}

StateAnswer known(double value) noexcept {
    return {Kind::value, value, true};
}

StateAnswer truth_of(bool is_true) noexcept {
    return known(is_true ? 1.0 : 0.0);
}

/// Which of nine parameters in a row it is.
std::optional<std::size_t> row_place(std::uint32_t number, std::uint32_t first) noexcept {
    if (number < first || number >= first + kLetterCount) return std::nullopt;
    return number - first;
}

std::optional<std::size_t> axis_of(char letter) noexcept {
    const std::size_t axis = kAxisLetters.find(static_cast<char>(letter - 'a' + 'A'));
    return axis == std::string_view::npos ? std::nullopt : std::optional{axis};
}

/// As LinuxCNC numbers systems: 540 to 590, 591 to 593.
double system_code(std::size_t system) noexcept {
    return system < 6 ? 540.0 + 10.0 * static_cast<double>(system) : 585.0 + static_cast<double>(system);
}

}  // namespace

/// In the program's coordinates and units.
StateAnswer Interpreter::program_place(std::size_t axis) const noexcept {
    const double unit_mm = modes_.mm_per_unit;
    if (is_drawing(DrawnMode::polar) && (axis == kDepthLetter || axis == kTurnLetter))
        return {Kind::value,
                (axis == kDepthLetter ? drawing_.place.first_mm : drawing_.place.second_mm) / unit_mm,
                !drawing_.is_doubtful};
    const AxisMask needed = both_if_turned(mask_of(axis));
    const bool is_certain = (place_.placed & needed) == needed && (unknown_zeros() & needed) == 0;
    return {Kind::value, place_.program[axis] / (is_rotary(axis) ? 1.0 : unit_mm), is_certain};
}

StateAnswer Interpreter::machine_place(std::size_t axis) const noexcept {
    return {Kind::value, place_.machine[axis] / (is_rotary(axis) ? 1.0 : modes_.mm_per_unit),
            (place_.placed & mask_of(axis)) != 0};
}

StateAnswer Interpreter::numbered(std::uint32_t number) const {
    if (is_foreign(number)) return {Kind::not_read};
    if (number == 5400) return known(modes_.tool_in_spindle);
    if (const auto axis = row_place(number, kPlaces)) return program_place(*axis);
    for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
        const auto axis = row_place(number, which == 0 ? kFirstReference : kSecondReference);
        if (axis)
            return {Kind::value, references_[which].at[*axis],
                    (unknown_.references[which] & mask_of(*axis)) == 0};
    }
    if (number == kShift - 1) return truth_of(offsets_.is_shifted());
    if (const auto axis = row_place(number, kShift))
        return {Kind::value, offsets_.kept_shift()[*axis], (unknown_.shift & mask_of(*axis)) == 0};
    if (number == kSystems - 1) return known(static_cast<double>(offsets_.active() + 1));
    if (number < kSystems) return {};
    const std::size_t system = (number - kSystems) / kSystemStep;
    const std::size_t place = (number - kSystems) % kSystemStep;
    if (system >= WorkOffsets::kSystemCount || place > kLetterCount) return {};
    if (place == kLetterCount) return known(offsets_.rotation_deg(system));
    return {Kind::value, offsets_.origin(system)[place], (unknown_.origins[system] & mask_of(place)) == 0};
}

StateAnswer Interpreter::named(std::string_view name) const {
    if (is_foreign_name(name)) return {Kind::not_read};
    if (name.size() == 2)
        if (const auto axis = axis_of(name[1])) return program_place(*axis);
    if (name.size() == 6 && name.starts_with("_abs_"))
        if (const auto axis = axis_of(name[5])) return machine_place(*axis);
    return mode(name);
}

StateAnswer Interpreter::mode(std::string_view name) const noexcept {
    const bool is_inch = modes_.mm_per_unit != 1.0;
    if (name == "_line") return known(static_cast<double>(course_.line));
    if (name == "_motion_mode") return known(modes_.motion);
    const Plane* plane = is_drawing(DrawnMode::none) ? modes_.plane : drawing_.plane_before;
    if (name == "_plane") return known(plane == &kPlaneXy ? 170 : (plane == &kPlaneZx ? 180 : 190));
    if (name == "_metric") return truth_of(!is_inch);
    if (name == "_imperial") return truth_of(is_inch);
    if (name == "_absolute") return truth_of(!modes_.is_incremental);
    if (name == "_incremental") return truth_of(modes_.is_incremental);
    if (name == "_inverse_time") return truth_of(modes_.feed_mode == FeedMode::inverse_time);
    if (name == "_units_per_minute") return truth_of(modes_.feed_mode == FeedMode::per_minute);
    if (name == "_units_per_rev") return truth_of(modes_.feed_mode == FeedMode::per_revolution);
    if (name == "_ijk_absolute_mode") return truth_of(modes_.has_absolute_centres);
    if (name == "_coord_system") return known(system_code(offsets_.active()));
    if (name == "_tool_offset") return truth_of(offsets_.has_tool_length());
    if (name == "_retract_r_plane") return truth_of(!modes_.retracts_to_start);
    if (name == "_retract_old_z") return truth_of(modes_.retracts_to_start);
    if (name == "_feed") return known(modes_.feed_number);
    if (name == "_rpm") return known(modes_.spindle_rpm);
    if (name == "_spindle_on") return truth_of(modes_.is_spindle_on);
    if (name == "_spindle_cw") return truth_of(modes_.is_spindle_on && !modes_.is_spindle_reverse);
    if (name == "_mist") return truth_of(modes_.is_mist_on);
    if (name == "_flood") return truth_of(modes_.is_flood_on);
    if (name == "_current_tool") return known(modes_.tool_in_spindle);
    if (name == "_selected_tool") return known(modes_.tool);
    return {};
}

}  // namespace psicarve::gcode
