// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/machine/latency_probe.hpp"

namespace psicarve::cli {

/// A histogram of the ticks' lateness, a row for each doubling, bars as long as the logarithm of their count;
/// below it percentiles, missed ticks and what disturbed the tick.
std::string latency_text(const machine::LatencyResult& result, const machine::LatencyOptions& options);

}  // namespace psicarve::cli
