// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/report/model_findings.hpp"

namespace psicarve::cli {

/// The largest hidden parts of a model, as lines of its report; empty where there are none.
std::vector<std::string> hidden_lines(const report::HiddenPlaces& places);
/// The same for its open parts.
std::vector<std::string> open_lines(const report::HiddenPlaces& places);
/// All of both, as one JSON object.
std::string hidden_json(const report::HiddenPlaces& places);

}  // namespace psicarve::cli
