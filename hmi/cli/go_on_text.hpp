// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "hmi/machine/machine_link.hpp"
#include "shared/machine/status.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::cli {

/// The place within a layer with which the piece of the published job goes on.
struct GoOnPlace {
    std::uint32_t layer;
    std::uint32_t point;
    std::string segment;  ///< its name
};
/// As the core, or one that is gone, left it in the segment. Nothing: it is not known, or it is the layer's
/// begin.
std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link);
/// The same of a core with this status; nothing where it would take no start of the published job.
std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link, const CoreStatus& status);
/// The same without a core; nothing where a disk's record of the piece is of another place: a run may have
/// begun anew since, and the next core takes the lower of the two.
std::optional<GoOnPlace> place_to_go_on(const machine::MachineLink& link,
                                        const std::optional<FoundCheckpoint>& on_disk);

/// "psicarve start --resume": for a shell, with the segment where it is not the usual one. The core decides
/// where it goes on: with layer and point named it would check nothing.
std::string go_on_command(const GoOnPlace& place);
/// That in a line of the status, with the place in words; empty without a place.
std::string go_on_text(const std::optional<GoOnPlace>& place);
/// {"layer": 131, "point": 56, "command": "psicarve start --resume"} or null.
nlohmann::ordered_json go_on_json(const std::optional<GoOnPlace>& place);

/// As a shell reads it back.
std::string as_shell_word(const std::string& text);

}  // namespace psicarve::cli
