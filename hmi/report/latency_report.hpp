// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hmi/machine/latency_probe.hpp"

namespace psicarve::report {

nlohmann::ordered_json latency_json(const machine::LatencyResult& result,
                                    const machine::LatencyOptions& options);
/// late_us,ticks
std::string latency_csv(const machine::LatencyResult& result);

}  // namespace psicarve::report
