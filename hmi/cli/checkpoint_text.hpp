// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "shared/segment/checkpoint.hpp"

namespace psicarve::cli {

/// A line for a person: how far the last carving came; empty when there was none.
std::string checkpoint_text(const std::optional<Checkpoint>& checkpoint, bool is_of_job);
/// {"next_layer": ..., "layer_count": ..., "is_of_job": ...} or null; "earlier_layer" where the run before
/// came further.
nlohmann::ordered_json checkpoint_json(const std::optional<Checkpoint>& checkpoint, bool is_of_job);

/// The core's remark on the published job; leaves out the part about a difference between memory and disk
/// once the piece is carved past the lower of the two layers.
std::string current_remark(const std::string& remark, const std::optional<Checkpoint>& checkpoint);

}  // namespace psicarve::cli
