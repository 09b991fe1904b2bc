// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/move_wish.hpp"

#include "hmi/session/action_lock.hpp"

namespace psicarve::session {
namespace {

std::uint32_t axes_of(const MoveWish& wish) {
    std::uint32_t axes = 0;
    for (const Axis axis : kAllAxes) {
        if (wish.target[index_of(axis)]) axes |= 1U << index_of(axis);
    }
    return axes;
}

constexpr std::uint32_t bit(Axis axis) {
    return 1U << index_of(axis);
}

std::optional<Phrase> shape_lock(const MoveWish& wish) {
    const std::uint32_t axes = axes_of(wish);
    if (axes == 0) return phrase("Go to: choose an axis");
    if (wish.shape == MoveShape::straight) return std::nullopt;
    if ((axes & bit(Axis::psi)) != 0) return phrase("Go to: Ψ moves in straight lines only");
    const bool is_head_and_y =
        axes == (bit(Axis::r1) | bit(Axis::y)) || axes == (bit(Axis::r2) | bit(Axis::y));
    if (wish.shape == MoveShape::stepped) {
        const bool has_all = axes == (bit(Axis::r1) | bit(Axis::r2) | bit(Axis::y));
        return has_all ? std::optional{phrase("Go to: two axes at most, step by step")} : std::nullopt;
    }
    return is_head_and_y ? std::nullopt : std::optional{phrase("Go to: an arc is of one head and Y")};
}

}  // namespace

std::optional<Phrase> move_lock(const MachineSight& machine, const MoveWish& wish) {
    if (auto lock = lock_of(Action::jog, machine, JobSight{})) return lock;
    if (machine.state() == MachineState::moving) return phrase("Locked while an axis moves");
    return shape_lock(wish);
}

Command move_command(const MoveWish& wish) {
    Command command{};
    command.kind = CommandKind::move;
    command.axis = axes_of(wish);
    command.shape = wish.shape;
    const bool is_arc = wish.shape == MoveShape::arc || wish.shape == MoveShape::clockwise;
    for (const Axis axis : kAllAxes) {
        const auto& target = wish.target[index_of(axis)];
        if (!target) continue;
        command.target[index_of(axis)] = *target;
        if (is_arc) command.centre[index_of(axis)] = wish.centre[index_of(axis)];
    }
    return command;
}

std::optional<Phrase> spindle_lock(const MachineSight& machine) {
    // A jog or a move may go on meanwhile.
    return lock_of(Action::jog, machine, JobSight{});
}

}  // namespace psicarve::session
