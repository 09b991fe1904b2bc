// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/go_on_text.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "shared/segment/segment.hpp"

namespace psicarve::cli {

std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link) {
    const auto checkpoint = link.checkpoint();
    if (!checkpoint || !link.is_of_published_job(*checkpoint)) return std::nullopt;
    const auto point = link.point_to_resume(*checkpoint);
    if (!point) return std::nullopt;
    return GoOnPlace{checkpoint->next_layer, *point, link.segment_name()};
}

std::string go_on_command(const GoOnPlace& place) {
    const std::string segment =
        place.segment == kDefaultSegmentName ? std::string{} : " --segment " + as_shell_word(place.segment);
    return "psicarve start --from-layer " + std::to_string(place.layer) + " --from-point " +
           std::to_string(place.point) + segment;
}

std::string go_on_text(const std::optional<GoOnPlace>& place) {
    return place ? "go on      " + go_on_command(*place) + "\n" : std::string{};
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
