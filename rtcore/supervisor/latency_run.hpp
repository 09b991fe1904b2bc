// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/options/options.hpp"

namespace psicarve::supervisor {

/// --measure-latency: the core's own tick loop with nothing in the tick, treated as the core's tick is, for
/// options.measure_seconds or until SIGINT or SIGTERM. On standard output one JSON object a line: progress
/// once a second, at the end the result with the histogram. Touches neither segment nor port. Returns the
/// exit code.
int run_latency_measurement(const CoreOptions& options);

}  // namespace psicarve::supervisor
