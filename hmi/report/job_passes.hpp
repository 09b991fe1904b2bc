// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "shared/job.hpp"

namespace psicarve::report {

/// What is carved to one depth, in however many runs.
struct PassLayers {
    std::string name;
    JobPass first;  ///< of its runs
    std::uint32_t layers = 0;
    double seconds = 0.0;  ///< where seconds by layer were given
};
/// At least one. `layer_seconds`: of every layer, or nothing.
std::vector<PassLayers> passes_of(const JobView& job, std::span<const double> layer_seconds = {});

/// "7 roughing passes of 93 layers, leaving 0.3 mm, and the finishing pass of 40".
std::string passes_text(const JobView& job);
/// An array: pass, layers, allowance_mm, depth_mm; seconds where they were given.
nlohmann::ordered_json passes_json(const JobView& job, std::span<const double> layer_seconds = {});

}  // namespace psicarve::report
