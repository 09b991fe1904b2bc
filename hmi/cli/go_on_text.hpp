// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "hmi/machine/machine_link.hpp"

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

/// "psicarve start --from-layer 131 --from-point 56": for a shell, with the segment where it is not the usual
/// one.
std::string go_on_command(const GoOnPlace& place);
/// That in a line of the status; empty without a place.
std::string go_on_text(const std::optional<GoOnPlace>& place);
/// {"layer": 131, "point": 56, "command": "psicarve start ..."} or null.
nlohmann::ordered_json go_on_json(const std::optional<GoOnPlace>& place);

/// As a shell reads it back.
std::string as_shell_word(const std::string& text);

}  // namespace psicarve::cli
