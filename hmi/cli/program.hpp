// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::cli {

/// The whole of `psicarve`: reads the command line, does what it says, returns the exit code.
int run(int argc, char** argv);

}  // namespace psicarve::cli
