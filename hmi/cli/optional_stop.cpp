// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kOptionalStopText{
    "optional-stop", "Let the program at hand hold at M1, or not",
    "While a program in G-code runs. on: it holds at the next M1 that a brake reaches, and psicarve resume "
    "goes on. off: M1 does nothing.",
    "psicarve optional-stop on"};

}  // namespace

void add_optional_stop(CommandSet& commands) {
    const auto word = std::make_shared<std::string>();
    commands
        .add(kOptionalStopText,
             [word](const CommonOptions& common) {
                 MotionCommand motion{CommandKind::optional_stop, {}, {}, {}};
                 motion.details.value = *word == "on" ? 1.0 : 0.0;
                 return motion_body(common, motion);
             })
        .choice_argument("STATE", *word, {"on", "off"}, "Whether it holds at M1");
}

}  // namespace psicarve::cli
