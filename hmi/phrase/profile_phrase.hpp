// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// What is wrong with a value of a profile, as ProfileDraft::problem() and profile_problems() say it, in
/// words that can be translated. What is not known stays as it is.
Phrase profile_problem_phrase(const std::string& problem);

/// Why a profile could not be read or saved: "m.toml:2: job.feed_mm_s: ..." and what ProfileDraft says.
/// Nothing when it is another error.
std::optional<Phrase> profile_error_phrase(const std::string& message);

/// Of those that profile_problem_phrase() knows, the words before anything stands in them.
std::vector<std::string> known_profile_problems();

}  // namespace psicarve::session
