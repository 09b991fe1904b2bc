// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_start_interpolation(CommandSet& commands) {
    constexpr CommandText kStartInterpolationText{
        "start-interpolation", "Begin to carve the published job",
        "The machine waits at the first point (psicarve start). Returns when carving has begun.",
        "psicarve start-interpolation"};
    commands.add(kStartInterpolationText, [](const CommonOptions& common) {
        return motion_body(common, {CommandKind::start_interpolation, {}, {}});
    });
}

}  // namespace psicarve::cli
