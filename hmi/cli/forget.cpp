// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <string>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/machine/forget_piece.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kForgetText{
    "forget", "Nobody goes on with the unfinished piece",
    "How far it is carved goes from the segment and from the disk, and the copy of its job from the disk.\n"
    "The next start begins with the first layer. Nothing moves; refused while a job runs.",
    "psicarve forget"};

}  // namespace

void add_forget(CommandSet& commands) {
    const auto folder = std::make_shared<std::string>();
    commands
        .add(kForgetText,
             [folder](const CommonOptions& common) -> Result<int> {
                 const auto done = machine::forget_piece(common.segment, common.group, *folder);
                 if (!done) return done.error();
                 if (common.json) {
                     std::fputs("{\"command\":\"forget\"}\n", stdout);
                 } else {
                     std::fputs("forget: no piece is unfinished\n", stdout);
                 }
                 return kExitDone;
             })
        .option("--state", *folder, "FOLDER", "Where the core keeps it, if it was given --state");
}

}  // namespace psicarve::cli
