// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/options/options.hpp"

namespace psicarve::supervisor {

/// The whole program: profile, port, segment, threads, until it is told to end. Returns the exit code; what
/// went wrong has been said on standard error.
int run_core(const CoreOptions& options);

}  // namespace psicarve::supervisor
