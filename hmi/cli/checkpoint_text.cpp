// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/checkpoint_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

namespace psicarve::cli {

std::string checkpoint_text(const std::optional<Checkpoint>& checkpoint, bool is_of_job) {
    if (!checkpoint) return {};
    const std::string layers =
        std::to_string(checkpoint->next_layer) + " of " + std::to_string(checkpoint->layer_count);
    if (checkpoint->next_layer == checkpoint->layer_count)
        return "checkpoint " + layers + " layers, carved to the end\n";
    const std::string whence = checkpoint->is_from_disk() ? ", from a disk" : "";
    const std::string earlier = std::to_string(checkpoint->earlier_layer);
    return "checkpoint " + layers + " layers" + (is_of_job ? "" : ", of another job") + whence +
           (checkpoint->earlier_layer == 0
                ? ""
                : "; the run before it came to " + earlier + " (start --from-layer " + earlier + ")") +
           "\n";
}

nlohmann::ordered_json checkpoint_json(const std::optional<Checkpoint>& checkpoint, bool is_of_job) {
    if (!checkpoint) return nullptr;
    nlohmann::ordered_json object{{"next_layer", checkpoint->next_layer},
                                  {"layer_count", checkpoint->layer_count},
                                  {"is_of_job", is_of_job}};
    if (checkpoint->earlier_layer != 0) object["earlier_layer"] = checkpoint->earlier_layer;
    if (checkpoint->is_from_disk()) object["is_from_disk"] = true;
    return object;
}

std::string current_remark(const std::string& remark, const std::optional<Checkpoint>& checkpoint) {
    constexpr std::string_view kEnd = "the lower one is taken";
    const std::size_t at = remark.find("segment: layer ");
    unsigned in_segment = 0;
    unsigned on_disk = 0;
    if (at == std::string::npos || !checkpoint ||
        std::sscanf(remark.c_str() + at, "segment: layer %u, disk: %u;", &in_segment, &on_disk) != 2 ||
        checkpoint->next_layer == std::min(in_segment, on_disk))
        return remark;
    const std::size_t end = remark.find(kEnd, at);
    if (end == std::string::npos) return remark;
    std::string before = remark.substr(0, at);
    std::string after = remark.substr(end + kEnd.size());
    constexpr std::string_view kBetween = "; ";
    if (before.empty() && after.starts_with(kBetween)) return after.substr(kBetween.size());
    if (after.empty() && before.ends_with(kBetween)) before.resize(before.size() - kBetween.size());
    if (before.ends_with(kBetween) && after.starts_with(kBetween)) after.erase(0, kBetween.size());
    return before + after;
}

}  // namespace psicarve::cli
