// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/jog.hpp"

#include <chrono>
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/number_argument.hpp"
#include "hmi/cli/operator_break.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kJogText{
    "jog", "Move one axis by a distance, or on and on until Ctrl-C",
    "DISTANCE is in mm, for psi in degrees; + or - goes on until Ctrl-C or the end of the travel. At home\n"
    "speed if no other is given. The machine must be homed and ready. A jog ends by itself when this program "
    "does.",
    "psicarve jog r1 -2.5\n  psicarve jog psi + --speed 30"};

struct JogOptions {
    std::string axis;
    std::string distance;
    std::optional<double> speed;
    std::optional<double> lease_s;
};

bool goes_on(const JogOptions& options) {
    return options.distance == "+" || options.distance == "-";
}

Result<machine::HeldJog> begin_jog(machine::MachineLink& link, const JogOptions& options, double distance,
                                   std::chrono::milliseconds lease) {
    const auto named = axis_from_name(options.axis);
    const machine::JogAxis axis = named ? machine::JogAxis{*named} : machine::JogAxis::heads();
    const double speed = options.speed.value_or(0.0);
    if (goes_on(options)) return machine::HeldJog::on(link, axis, options.distance == "+", speed, lease);
    return machine::HeldJog::by(link, axis, distance, speed, lease);
}

/// Judges how a jog ended; only the first two ends are what was asked for.
Result<void> judge_end(const CoreStatus& status, bool may_be_released) {
    if (status.move_end == MoveEnd::reached) return {};
    if (status.move_end == MoveEnd::released && may_be_released) return {};
    if (status.move_end == MoveEnd::released)
        return Error{ErrorCode::cancelled, "jog: ended by the operator"};
    if (status.move_end == MoveEnd::lease_gone) {
        return Error{ErrorCode::machine_refused,
                     "jog: ended early, the core had not heard from us for too long; is the computer busy?"};
    }
    return Error{ErrorCode::machine_refused, "jog: ended early: somebody stopped the machine"};
}

Result<int> jog(const CommonOptions& common, const JogOptions& options) {
    double distance = 0.0;
    if (!goes_on(options)) {
        const auto number = number_argument("DISTANCE", options.distance);
        if (!number) return number.error();
        distance = *number;
    }
    const auto lease =
        lease_argument(options.lease_s, goes_on(options) ? kJogLease : machine::kDistanceJogLease);
    if (!lease) return lease.error();
    auto link = link_to_core(common);
    if (!link) return link.error();
    OperatorBreak operator_break;
    auto held = begin_jog(*link, options, distance, *lease);
    if (!held) return held.error();
    if (const Message& remark = link->command_remark(); !remark.is_none())
        print_warning("jog: " + in_words(remark));
    const auto watch = [&](const CoreStatus&) -> Result<void> {
        if (operator_break.was_asked()) {
            held->release();
        } else {
            held->renew();
        }
        return {};
    };
    const auto end = link->wait_for_state({MachineState::ready}, watch);
    if (!end) return end.error();
    if (const auto went = judge_end(*end, goes_on(options)); !went) return went.error();
    report_motion(common, kJogText.name, *end);
    return kExitDone;
}

}  // namespace

void add_jog(CommandSet& commands) {
    const auto options = std::make_shared<JogOptions>();
    commands.add(kJogText, [options](const CommonOptions& common) { return jog(common, *options); })
        .choice_argument("AXIS", options->axis, {"r1", "r2", "psi", "y", "heads"},
                         "The axis to move; heads: R1 and R2 together")
        .argument("DISTANCE", options->distance, "How far [mm; psi: deg], or + or - to go on")
        .option("--speed", options->speed, "SPEED", "How fast at most [mm/s; psi: deg/s]")
        .option(
            "--lease", options->lease_s, "SECONDS",
            "How long it goes on after this program has died, 0.1 to 2 [0.2; with a distance 1]: longer on a "
            "computer that is busy");
}

}  // namespace psicarve::cli
