// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/move_request.hpp"

#include "hmi/session/action_lock.hpp"

namespace psicarve::session {
namespace {

std::uint32_t axes_of(const MoveRequest& request) {
    std::uint32_t axes = 0;
    for (const Axis axis : kAllAxes) {
        if (request.target[index_of(axis)]) axes |= 1U << index_of(axis);
    }
    return axes;
}

constexpr std::uint32_t bit(Axis axis) {
    return 1U << index_of(axis);
}

std::optional<Phrase> shape_lock(const MoveRequest& request) {
    const std::uint32_t axes = axes_of(request);
    if (axes == 0) return phrase("Go to: choose an axis");
    if (request.shape == MoveShape::straight) return std::nullopt;
    if ((axes & bit(Axis::psi)) != 0) return phrase("Go to: Ψ moves in straight lines only");
    const bool is_head_and_y =
        axes == (bit(Axis::r1) | bit(Axis::y)) || axes == (bit(Axis::r2) | bit(Axis::y));
    if (request.shape == MoveShape::stepped) {
        const bool has_all = axes == (bit(Axis::r1) | bit(Axis::r2) | bit(Axis::y));
        return has_all ? std::optional{phrase("Go to: two axes at most, step by step")} : std::nullopt;
    }
    return is_head_and_y ? std::nullopt : std::optional{phrase("Go to: an arc is of one head and Y")};
}

}  // namespace

std::optional<Phrase> move_lock(const MachineView& machine, const MoveRequest& request) {
    if (auto lock = lock_of(Action::jog, machine, OpenJobView{})) return lock;
    if (machine.state() == MachineState::moving) return phrase("Locked while an axis moves");
    return shape_lock(request);
}

Command move_command(const MoveRequest& request) {
    Command command{};
    command.kind = CommandKind::move;
    command.axis = axes_of(request);
    command.shape = request.shape;
    const bool is_arc = request.shape == MoveShape::arc || request.shape == MoveShape::clockwise;
    for (const Axis axis : kAllAxes) {
        const auto& target = request.target[index_of(axis)];
        if (!target) continue;
        command.target[index_of(axis)] = *target;
        if (is_arc) command.centre[index_of(axis)] = request.centre[index_of(axis)];
    }
    return command;
}

std::optional<Phrase> spindle_lock(const MachineView& machine) {
    // A jog or a move may go on meanwhile.
    return lock_of(Action::jog, machine, OpenJobView{});
}

}  // namespace psicarve::session
