// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/number_argument.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{"move", "Move to a position: one axis or several in a straight line",
                            "Positions are in mm, for psi in degrees, which psi reaches the short way. The "
                            "machine must be homed and\n"
                            "ready. Waits until it is there.",
                            "psicarve move r1=30 r2=30\n  psicarve move psi=90"};

Result<void> add_target(Command& command, const std::string& word) {
    const std::size_t equals = word.find('=');
    const auto axis = axis_from_name(word.substr(0, equals));
    if (equals == std::string::npos || !axis) {
        return Error{ErrorCode::bad_usage,
                     "move: '" + word + "' is not AXIS=POSITION with r1, r2, psi or y, as in r1=30"};
    }
    const auto position = number_argument(std::string{name_of(*axis)}, word.substr(equals + 1));
    if (!position) return position.error();
    const std::uint32_t bit = 1U << index_of(*axis);
    if ((command.axis & bit) != 0)
        return Error{ErrorCode::bad_usage, "move: " + std::string{name_of(*axis)} + " is given twice"};
    command.axis |= bit;
    command.target[index_of(*axis)] = *position;
    return {};
}

Result<int> move(const CommonOptions& common, const std::vector<std::string>& words) {
    MotionCommand motion{CommandKind::move, {}, {MachineState::ready}, {}};
    for (const std::string& word : words) {
        if (const auto added = add_target(motion.details, word); !added) return added.error();
    }
    auto link = link_to_core(common);
    if (!link) return link.error();
    const auto end = run_motion(*link, motion);
    if (!end) return end.error();
    if (end->move_end != MoveEnd::reached)
        return Error{ErrorCode::machine_refused, "move: ended early: somebody stopped the machine"};
    report_motion(common, kText.name, *end);
    return kExitDone;
}

}  // namespace

void add_move(CommandSet& commands) {
    const auto words = std::make_shared<std::vector<std::string>>();
    commands.add(kText, [words](const CommonOptions& common) { return move(common, *words); })
        .arguments("AXIS=POSITION", *words, "Where to: r1=30 psi=90 ...");
}

}  // namespace psicarve::cli
