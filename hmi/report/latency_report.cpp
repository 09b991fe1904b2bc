// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/latency_report.hpp"

#include <nlohmann/json.hpp>

#include "shared/base/units.hpp"

namespace psicarve::report {
namespace {

double max_us(const machine::LatencyResult& result) {
    return static_cast<double>(result.max_ns) / static_cast<double>(kNsPerUs);
}

}  // namespace

nlohmann::ordered_json latency_json(const machine::LatencyResult& result,
                                    const machine::LatencyOptions& options) {
    auto histogram = nlohmann::ordered_json::array();
    for (const auto& [late_us, ticks] : result.bins) histogram.push_back({late_us, ticks});
    return {{"period_us", options.period_us},
            {"priority", result.priority},
            {"cpu", result.cpu < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(result.cpu)},
            {"ticks", result.ticks},
            {"missed_ticks", result.missed},
            {"late_us",
             {{"p50", result.late_us(0.5)},
              {"p99", result.late_us(0.99)},
              {"p99_9", result.late_us(0.999)},
              {"max", max_us(result)}}},
            {"page_faults", result.page_faults},
            {"preemptions", result.preemptions},
            {"refused", result.refused},
            {"histogram_us", histogram}};
}

std::string latency_csv(const machine::LatencyResult& result) {
    std::string text = "late_us,ticks\n";
    for (const auto& [late_us, ticks] : result.bins)
        text += std::to_string(late_us) + "," + std::to_string(ticks) + "\n";
    return text;
}

}  // namespace psicarve::report
