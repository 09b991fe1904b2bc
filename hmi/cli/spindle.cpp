// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kSpindleText{
    "spindle", "Switch the spindle on or off by hand",
    "While the machine is ready or moves by hand; a job does it by itself, and stop "
    "switches it off.",
    "psicarve spindle on"};

}  // namespace

void add_spindle(CommandSet& commands) {
    const auto word = std::make_shared<std::string>();
    commands
        .add(kSpindleText,
             [word](const CommonOptions& common) {
                 MotionCommand motion{CommandKind::spindle, {}, {}, {}};
                 motion.details.value = *word == "on" ? 1.0 : 0.0;
                 return motion_body(common, motion);
             })
        .choice_argument("STATE", *word, {"on", "off"}, "What it shall be");
}

}  // namespace psicarve::cli
