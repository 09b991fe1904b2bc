// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kSingleText{
    "single", "Run the program at hand line by line, or on",
    "While a program in G-code runs. on: it rests where the line that it is in ends, or the first that a "
    "brake "
    "reaches,\nand each psicarve resume runs a line. off: the next resume runs on.",
    "psicarve single on"};

}  // namespace

void add_single(CommandSet& commands) {
    const auto word = std::make_shared<std::string>();
    commands
        .add(kSingleText,
             [word](const CommonOptions& common) {
                 MotionCommand motion{CommandKind::single, {}, {}, {}};
                 motion.details.value = *word == "on" ? 1.0 : 0.0;
                 return motion_body(common, motion);
             })
        .choice_argument("STATE", *word, {"on", "off"}, "Whether it waits behind each line");
}

}  // namespace psicarve::cli
