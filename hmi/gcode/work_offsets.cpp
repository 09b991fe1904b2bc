// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/work_offsets.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

void turn(Position& position, double sine, double cosine) noexcept {
    const double x = position[0];
    position[0] = x * cosine - position[1] * sine;
    position[1] = x * sine + position[1] * cosine;
}

}  // namespace

bool KeptOffsets::is_within_limits() const noexcept {
    const auto is_within = [](double value) { return std::abs(value) <= kMostOffset; };
    const auto are_within = [&](const Position& position) {
        return std::ranges::all_of(position, is_within);
    };
    return are_within(shift) &&
           std::ranges::all_of(systems,
                               [&](const SystemOffset& system) {
                                   return are_within(system.origin) && is_within(system.rotation_deg);
                               }) &&
           std::ranges::all_of(references, [&](const auto& place) { return !place || are_within(*place); });
}

WorkOffsets::WorkOffsets(const KeptOffsets& kept) noexcept
    : systems_(kept.systems),
      shift_(kept.is_shifted ? kept.shift : Position{}),
      kept_shift_(kept.shift),
      is_shifted_(kept.is_shifted) {
    refresh();
}

void WorkOffsets::keep(KeptOffsets& kept) const noexcept {
    kept.systems = systems_;
    kept.shift = kept_shift_;
    kept.is_shifted = is_shifted_;
}

Position WorkOffsets::to_machine(const Position& program) const noexcept {
    Position machine;
    if (!is_turned()) {
        for (std::size_t axis = 0; axis < kLetterCount; ++axis) machine[axis] = program[axis] + sum_[axis];
        return machine;
    }
    for (std::size_t axis = 0; axis < kLetterCount; ++axis) machine[axis] = program[axis] + shift_[axis];
    turn(machine, sine_, cosine_);
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        machine[axis] += systems_[active_].origin[axis] + tool_[axis];
    return machine;
}

Position WorkOffsets::unturned(const Position& machine, const SystemOffset& system) const noexcept {
    Position program;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        program[axis] = machine[axis] - system.origin[axis] - tool_[axis];
    const double angle_rad = rad_from_deg(system.rotation_deg);
    if (system.rotation_deg != 0.0) turn(program, -std::sin(angle_rad), std::cos(angle_rad));
    return program;
}

Position WorkOffsets::to_program(const Position& machine) const noexcept {
    Position program = unturned(machine, systems_[active_]);
    for (std::size_t axis = 0; axis < kLetterCount; ++axis) program[axis] -= shift_[axis];
    return program;
}

void WorkOffsets::refresh() noexcept {
    const SystemOffset& system = systems_[active_];
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        sum_[axis] = system.origin[axis] + shift_[axis] + tool_[axis];
    sine_ = std::sin(rad_from_deg(system.rotation_deg));
    cosine_ = std::cos(rad_from_deg(system.rotation_deg));
}

void WorkOffsets::select(std::size_t system) noexcept {
    active_ = system;
    refresh();
}

void WorkOffsets::set_origin(std::size_t system, std::size_t axis, double origin) noexcept {
    systems_[system].origin[axis] = origin;
    refresh();
}

void WorkOffsets::set_rotation(std::size_t system, double rotation_deg) noexcept {
    systems_[system].rotation_deg = rotation_deg;
    refresh();
}

void WorkOffsets::set_current(std::size_t system, const Position& machine, AxisMask axes,
                              const Position& program) noexcept {
    SystemOffset& changed = systems_[system];
    Position wanted = unturned(machine, changed);
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        if ((axes & mask_of(axis)) != 0) wanted[axis] = program[axis] + shift_[axis];
    const double angle_rad = rad_from_deg(changed.rotation_deg);
    if (changed.rotation_deg != 0.0) turn(wanted, std::sin(angle_rad), std::cos(angle_rad));
    const AxisMask touched = changed.rotation_deg != 0.0 && (axes & 3U) != 0 ? axes | 3U : axes;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        if ((touched & mask_of(axis)) != 0) changed.origin[axis] = machine[axis] - tool_[axis] - wanted[axis];
    refresh();
}

void WorkOffsets::set_shift(const Position& machine, AxisMask axes, const Position& program) noexcept {
    const Position base = unturned(machine, systems_[active_]);
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        if ((axes & mask_of(axis)) != 0) shift_[axis] = base[axis] - program[axis];
    kept_shift_ = shift_;
    is_shifted_ = true;
    refresh();
}

void WorkOffsets::clear_shift() noexcept {
    kept_shift_ = {};
    suspend_shift();
}

void WorkOffsets::suspend_shift() noexcept {
    shift_ = {};
    is_shifted_ = false;
    refresh();
}

void WorkOffsets::restore_shift() noexcept {
    shift_ = kept_shift_;
    is_shifted_ = true;
    refresh();
}

void WorkOffsets::set_tool(AxisMask axes, const Position& length) noexcept {
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        if ((axes & mask_of(axis)) != 0) tool_[axis] = length[axis];
    refresh();
}

void WorkOffsets::clear_tool() noexcept {
    tool_ = {};
    refresh();
}

}  // namespace psicarve::gcode
