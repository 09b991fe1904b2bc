// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hmi/machine/latency_probe.hpp"

namespace psicarve::cli {

/// A picture of how late ticks were, a row for each doubling, bars as long as the logarithm of their count;
/// below it percentiles, missed ticks and what disturbed the tick.
std::string latency_text(const machine::LatencyResult& result, const machine::LatencyWish& wish);
nlohmann::ordered_json latency_json(const machine::LatencyResult& result, const machine::LatencyWish& wish);
/// late_us,ticks
std::string latency_csv(const machine::LatencyResult& result);

}  // namespace psicarve::cli
