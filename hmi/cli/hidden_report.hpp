// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/report/model_findings.hpp"

namespace psicarve::cli {

/// The worst of where a model hides parts of itself, as lines of a model's report; none where there is
/// nothing to tell.
std::vector<std::string> hidden_lines(const report::HiddenPlaces& places);
/// The same of where it is open.
std::vector<std::string> open_lines(const report::HiddenPlaces& places);
/// All of both, as one JSON object.
std::string hidden_json(const report::HiddenPlaces& places);

}  // namespace psicarve::cli
