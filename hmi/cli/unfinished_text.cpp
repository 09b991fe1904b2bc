// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/unfinished_text.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "hmi/cli/go_on_text.hpp"
#include "hmi/report/utc_text.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::cli {
namespace {

std::vector<std::string> steps_of(const FoundCheckpoint& found, const WayBack& way) {
    const Checkpoint& checkpoint = found.saved.checkpoint;
    const std::string segment =
        way.segment == kDefaultSegmentName ? std::string{} : " --segment " + as_shell_word(way.segment);
    std::vector<std::string> steps;
    if (!way.has_core) steps.push_back("psicarve-rtcore" + segment + " (with its options: start the core)");
    if (!way.is_published) {
        steps.push_back(found.job_path.empty()
                            ? "psicarve publish JOB" + segment + " (that very job; there is no copy of it)"
                            : "psicarve publish " + as_shell_word(found.job_path) + segment);
    }
    steps.push_back("psicarve home" + segment);
    const std::string layer = std::to_string(checkpoint.earlier_layer);
    steps.push_back(checkpoint.next_layer != 0
                        ? "psicarve start --resume" + segment
                        : "psicarve start --from-layer " + layer + segment + " (for the piece of before)");
    return steps;
}

std::string progress_of(const Checkpoint& checkpoint) {
    const std::string count = std::to_string(checkpoint.layer_count);
    const std::string earlier = std::to_string(checkpoint.earlier_layer);
    if (checkpoint.next_layer == 0)
        return "none of " + count + " layers is carved; the run before it came to " + earlier;
    return std::to_string(checkpoint.next_layer) + " of " + count + " layers are carved" +
           (checkpoint.earlier_layer == 0
                ? ""
                : "; the run before it came to " + earlier + " (start --from-layer " + earlier + ")");
}

}  // namespace

std::string disk_source_text(const FoundCheckpoint& found, bool is_other_core) {
    const SavedCheckpoint& saved = found.saved;
    return found.path + " of " + report::utc_text(saved.written_s) + ": " + saved.source_name + ", " +
           progress_of(saved.checkpoint) + (saved.tool.empty() ? "" : ", tool " + saved.tool) +
           (saved.is_simulator ? ", simulated machine" : "") +
           (is_other_core ? ", carved with another profile of the machine" : "");
}

std::string unfinished_text(const FoundCheckpoint& found, const WayBack& way) {
    const SavedCheckpoint& saved = found.saved;
    std::string text = "unfinished " + saved.source_name + ": " + progress_of(saved.checkpoint) + "\n";
    text += "since      " + report::utc_text(saved.written_s);
    if (!saved.tool.empty()) text += "; tool " + saved.tool;
    text += saved.is_simulator ? "; simulated machine\n" : "\n";
    text += "kept in    " + found.path + "\n";
    if (way.is_other_core) text += "mind       the core's profile is not the one that it was carved with\n";
    if (found.keeper == Keeper::other_core)
        text += "mind       this core keeps pieces elsewhere, or nowhere: this one is another core's\n";
    for (const std::string& other : found.other_paths)
        text += "mind       " + other + " tells of another piece: see which of them is mounted\n";
    int number = 0;
    for (const std::string& step : steps_of(found, way)) {
        text += number++ == 0 ? "go on      " : "           ";
        text += std::to_string(number) + ". " + step + "\n";
    }
    return text;
}

nlohmann::ordered_json unfinished_json(const std::optional<FoundCheckpoint>& found, const WayBack& way) {
    if (!found) return nullptr;
    const SavedCheckpoint& saved = found->saved;
    nlohmann::ordered_json object{{"source", saved.source_name},
                                  {"next_layer", saved.checkpoint.next_layer},
                                  {"layer_count", saved.checkpoint.layer_count}};
    if (saved.checkpoint.earlier_layer != 0) object["earlier_layer"] = saved.checkpoint.earlier_layer;
    object["written"] = report::utc_stamp(saved.written_s);
    object["tool"] = saved.tool;
    object["is_simulator"] = saved.is_simulator;
    object["kept_in"] = found->path;
    object["is_other_profile"] = way.is_other_core;
    if (found->keeper == Keeper::other_core) object["is_other_cores"] = true;
    if (!found->other_paths.empty()) object["others_kept_in"] = found->other_paths;
    object["job"] =
        found->job_path.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(found->job_path);
    object["steps"] = steps_of(*found, way);
    return object;
}

}  // namespace psicarve::cli
