// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/go_on_text.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "shared/machine/machine_state.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::cli {

std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link) {
    const auto checkpoint = link.checkpoint();
    if (!checkpoint || !link.is_of_published_job(*checkpoint)) return std::nullopt;
    const auto point = link.point_to_resume(*checkpoint);
    if (!point) return std::nullopt;
    return GoOnPlace{checkpoint->next_layer, *point, link.segment_name()};
}

std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link, const CoreStatus& status) {
    const bool takes_start = !runs_job(status.state) && status.job_generation != 0 &&
                             status.job_generation == published_generation(link.segment());
    return takes_start ? place_to_go_on(link) : std::nullopt;
}

std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link,
                                        const std::optional<FoundCheckpoint>& on_disk) {
    const auto checkpoint = link.checkpoint();
    // Of another job, or of the other kind of machine, it says nothing of this piece.
    const bool is_of_piece = checkpoint && on_disk &&
                             on_disk->saved.checkpoint.job_checksum == checkpoint->job_checksum &&
                             on_disk->saved.is_simulator == checkpoint->is_simulated();
    if (is_of_piece && !is_same_place(on_disk->saved.checkpoint, *checkpoint)) return std::nullopt;
    return place_to_go_on(link);
}

std::string go_on_command(const GoOnPlace& place) {
    const std::string segment =
        place.segment == kDefaultSegmentName ? std::string{} : " --segment " + as_shell_word(place.segment);
    return "psicarve start --resume" + segment;
}

std::string go_on_text(const std::optional<GoOnPlace>& place) {
    if (!place) return {};
    return "go on      " + go_on_command(*place) + " (within layer " + std::to_string(place->layer) +
           ", with its point " + std::to_string(place->point) + ")\n";
}

nlohmann::ordered_json go_on_json(const std::optional<GoOnPlace>& place) {
    if (!place) return nullptr;
    return {{"layer", place->layer}, {"point", place->point}, {"command", go_on_command(*place)}};
}

std::string as_shell_word(const std::string& text) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+=:,@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string word = "'";
    for (const char letter : text) word += letter == '\'' ? std::string{"'\\''"} : std::string{letter};
    return word + "'";
}

}  // namespace psicarve::cli
