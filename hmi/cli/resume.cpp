// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_resume(CommandSet& commands) {
    constexpr CommandText kResumeText{"resume", "Go on after hold", "Returns when the machine moves again.",
                                      "psicarve resume"};
    commands.add(kResumeText, [](const CommonOptions& common) {
        return motion_body(common, {CommandKind::resume, {}, {}});
    });
}

}  // namespace psicarve::cli
