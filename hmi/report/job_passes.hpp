// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "hmi/cam/path_length.hpp"
#include "shared/job/job.hpp"

namespace psicarve::report {

/// The layers carved to one depth, in however many runs.
struct PassLayers {
    std::string name;
    JobPass first;  ///< of its runs
    std::uint32_t layers = 0;
    double seconds = 0.0;  ///< if seconds by layer were given
    cam::LayerPath path;   ///< of all its layers, if paths by layer were given
};
/// At least one. `layer_seconds`, `layer_paths`: for every layer, or empty.
std::vector<PassLayers> passes_of(const JobView& job, std::span<const double> layer_seconds = {},
                                  std::span<const cam::LayerPath> layer_paths = {});

/// "7 roughing passes of 93 layers, leaving 0.3 mm, and the finishing pass of 40".
std::string passes_text(const JobView& job);
/// An array: pass, layers, allowance_mm, depth_mm; seconds, and cutting_mm, links_mm and total_mm of both
/// heads, if they were given.
nlohmann::ordered_json passes_json(const JobView& job, std::span<const double> layer_seconds = {},
                                   std::span<const cam::LayerPath> layer_paths = {});
/// {"r1": ..., "r2": ...}.
nlohmann::ordered_json heads_json(const std::array<double, 2>& by_head);

}  // namespace psicarve::report
