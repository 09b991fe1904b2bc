// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/number_argument.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kMoveText{
    "move", "Move to a position: one axis or several in a straight line",
    "Positions are in mm, for psi in degrees, which psi reaches the short way. The machine must be homed "
    "and\n"
    "ready. Waits until it is there. --stepwise moves one of two axes at a time, by point-by-point "
    "comparison;\n"
    "--centre goes there so on an arc of a head and y, from +head towards +y unless --clockwise.",
    "psicarve move r1=30 r2=30\n  psicarve move psi=90\n  psicarve move r1=30 y=40 --centre r1=30,y=30"};

struct MoveOptions {
    std::vector<std::string> targets;
    std::vector<std::string> centre;
    bool stepwise = false;
    bool clockwise = false;
};

/// Reads AXIS=POSITION words into `position`; returns the given axes, bit by axis.
Result<std::uint32_t> read_positions(const std::vector<std::string>& words, double (&position)[kAxisCount]) {
    std::uint32_t axes = 0;
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        const auto axis = axis_from_name(word.substr(0, equals));
        if (equals == std::string::npos || !axis) {
            return Error{ErrorCode::bad_usage,
                         "move: '" + word + "' is not AXIS=POSITION with r1, r2, psi or y, as in r1=30"};
        }
        const auto number = number_argument(std::string{name_of(*axis)}, word.substr(equals + 1));
        if (!number) return number.error();
        const std::uint32_t bit = 1U << index_of(*axis);
        if ((axes & bit) != 0)
            return Error{ErrorCode::bad_usage, "move: " + std::string{name_of(*axis)} + " is given twice"};
        axes |= bit;
        position[index_of(*axis)] = *number;
    }
    return axes;
}

Result<Command> command_of(const MoveOptions& options) {
    Command command{};
    const auto axes = read_positions(options.targets, command.target);
    if (!axes) return axes.error();
    command.axis = *axes;
    if (options.stepwise) command.shape = MoveShape::stepped;
    if (options.centre.empty() && options.clockwise)
        return Error{ErrorCode::bad_usage, "move: --clockwise is of an arc: give its --centre, too"};
    if (options.centre.empty()) return command;
    const auto centre = read_positions(options.centre, command.centre);
    if (!centre) return centre.error();
    if (*centre != *axes) {
        return Error{ErrorCode::bad_usage,
                     "move: --centre takes the axes that are moved, as in "
                     "move r1=30 y=40 --centre r1=30,y=30"};
    }
    command.shape = options.clockwise ? MoveShape::clockwise : MoveShape::arc;
    return command;
}

Result<int> move(const CommonOptions& common, const MoveOptions& options) {
    const auto command = command_of(options);
    if (!command) return command.error();
    auto link = link_to_core(common);
    if (!link) return link.error();
    const auto end = run_motion(*link, {CommandKind::move, {}, {MachineState::ready}, *command});
    if (!end) return end.error();
    if (end->move_end != MoveEnd::reached)
        return Error{ErrorCode::machine_refused, "move: ended early: somebody stopped the machine"};
    report_motion(common, kMoveText.name, *end);
    return kExitDone;
}

}  // namespace

void add_move(CommandSet& commands) {
    const auto options = std::make_shared<MoveOptions>();
    commands.add(kMoveText, [options](const CommonOptions& common) { return move(common, *options); })
        .arguments("AXIS=POSITION", options->targets, "Where to: r1=30 psi=90 ...")
        .flag("--stepwise", options->stepwise, "One axis at a time, point by point; one or two of r1, r2, y")
        .words("--centre", options->centre, "AXIS=POSITION,...", "Go on an arc round this place")
        .flag("--clockwise", options->clockwise, "The arc the other way round");
}

}  // namespace psicarve::cli
