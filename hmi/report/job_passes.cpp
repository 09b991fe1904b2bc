// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/job_passes.hpp"

#include <array>
#include <cstdio>

namespace psicarve::report {
std::vector<PassLayers> passes_of(const JobView& job, std::span<const double> layer_seconds,
                                  std::span<const cam::LayerPath> layer_paths) {
    std::vector<PassLayers> passes;
    for (const JobPass& run : job.passes()) {
        if (passes.empty() || passes.back().first.number != run.number)
            passes.push_back({pass_name(run), run, 0, 0.0, {}});
        passes.back().layers += run.layer_count;
        for (std::uint32_t i = 0; i < run.layer_count && !layer_paths.empty(); ++i)
            passes.back().path += layer_paths[run.first_layer + i];
        if (layer_seconds.size() < job.layer_count()) continue;
        for (const double seconds : layer_seconds.subspan(run.first_layer, run.layer_count))
            passes.back().seconds += seconds;
    }
    return passes;
}

std::string passes_text(const JobView& job) {
    const auto passes = passes_of(job);
    const std::uint32_t rough = job.finishing_layer();
    std::array<char, 160> text{};
    if (rough == 0) return "the finishing pass alone";
    std::snprintf(text.data(), text.size(),
                  "%zu roughing %s of %u layers, leaving %g mm, and the finishing pass of %u",
                  passes.size() - 1, passes.size() == 2 ? "pass" : "passes", rough,
                  passes.front().first.allowance_mm, job.layer_count() - rough);
    return text.data();
}

nlohmann::ordered_json heads_json(const std::array<double, 2>& by_head) {
    return {{"r1", by_head[0]}, {"r2", by_head[1]}};
}

nlohmann::ordered_json passes_json(const JobView& job, std::span<const double> layer_seconds,
                                   std::span<const cam::LayerPath> layer_paths) {
    auto array = nlohmann::ordered_json::array();
    for (const PassLayers& pass : passes_of(job, layer_seconds, layer_paths)) {
        nlohmann::ordered_json object{{"pass", pass.name},
                                      {"layers", pass.layers},
                                      {"allowance_mm", pass.first.allowance_mm},
                                      {"depth_mm", pass.first.depth_mm}};
        if (!layer_seconds.empty()) object["seconds"] = pass.seconds;
        if (!layer_paths.empty()) {
            object["cutting_mm"] = heads_json(pass.path.cutting_mm);
            object["links_mm"] = heads_json(pass.path.link_mm);
            object["total_mm"] = heads_json(pass.path.total_mm());
        }
        array.push_back(object);
    }
    return array;
}

}  // namespace psicarve::report
