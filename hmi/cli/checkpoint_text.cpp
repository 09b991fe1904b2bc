// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/checkpoint_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "shared/wording/wording.hpp"

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

std::vector<Message> current_remarks(std::vector<Message> remarks,
                                     const std::optional<Checkpoint>& checkpoint) {
    std::erase_if(remarks, [&](const Message& remark) {
        const bool is_of_both = remark.id == MessageId::segment_and_disk_disagree && is_sound(remark);
        return is_of_both && checkpoint &&
               checkpoint->next_layer != std::min(remark.arguments[0].bits, remark.arguments[1].bits);
    });
    return remarks;
}

}  // namespace psicarve::cli
