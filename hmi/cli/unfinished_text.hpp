// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::cli {

/// The state that an operator finds who wants to continue an unfinished piece.
struct WayBack {
    std::string segment;  ///< its name
    bool has_core = false;
    bool is_published = false;   ///< the piece's job, in that segment
    bool is_other_core = false;  ///< the core's profile differs from the one that carved it
};

/// Some lines for a person: which piece, how far it is, since when, and step by step how to continue.
std::string unfinished_text(const FoundCheckpoint& found, const WayBack& way);
/// One line: where the record is from, its time, and what it says.
std::string disk_source_text(const FoundCheckpoint& found, bool is_other_core);
/// {"source": ..., "next_layer": ..., "layer_count": ..., "written": "2026-11-26T19:23:05Z", ..., "steps":
/// [...]}; null where there is none.
nlohmann::ordered_json unfinished_json(const std::optional<FoundCheckpoint>& found, const WayBack& way);

}  // namespace psicarve::cli
