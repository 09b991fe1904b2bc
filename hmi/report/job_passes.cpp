// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/job_passes.hpp"

#include <array>
#include <cstdio>

namespace psicarve::report {

std::vector<PassLayers> passes_of(const JobView& job, std::span<const double> layer_seconds) {
    std::vector<PassLayers> passes;
    for (const JobPass& run : job.passes()) {
        if (passes.empty() || passes.back().first.number != run.number)
            passes.push_back({pass_name(run), run, 0, 0.0});
        passes.back().layers += run.layer_count;
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

nlohmann::ordered_json passes_json(const JobView& job, std::span<const double> layer_seconds) {
    auto array = nlohmann::ordered_json::array();
    for (const PassLayers& pass : passes_of(job, layer_seconds)) {
        nlohmann::ordered_json object{{"pass", pass.name},
                                      {"layers", pass.layers},
                                      {"allowance_mm", pass.first.allowance_mm},
                                      {"depth_mm", pass.first.depth_mm}};
        if (!layer_seconds.empty()) object["seconds"] = pass.seconds;
        array.push_back(object);
    }
    return array;
}

}  // namespace psicarve::report
