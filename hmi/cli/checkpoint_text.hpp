// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shared/message/message.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve::cli {

/// A line for a person: how far the last carving came; empty when there was none.
std::string checkpoint_text(const std::optional<Checkpoint>& checkpoint, bool is_of_job);
/// {"next_layer": ..., "layer_count": ..., "is_of_job": ...} or null; "earlier_layer" where the run before
/// came further.
nlohmann::ordered_json checkpoint_json(const std::optional<Checkpoint>& checkpoint, bool is_of_job);

/// The core's remarks on the published job, without what it says of memory and disk once the piece is carved
/// past the lower of the two layers.
std::vector<Message> current_remarks(std::vector<Message> remarks,
                                     const std::optional<Checkpoint>& checkpoint);

}  // namespace psicarve::cli
