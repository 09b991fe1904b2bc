// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_changes.hpp"

#include <cstddef>
#include <string>

#include "shared/profile/profile_text.hpp"

namespace psicarve::session {
namespace {

Phrase value_phrase(const ProfileKey& key, const std::string& typed) {
    const bool has_quotes = key.value == ProfileValue::word || key.value == ProfileValue::text;
    if (has_quotes) return phrase("%1", toml_quoted(typed));
    const bool has_unit = !key.unit.empty() && key.unit != "pin";
    return phrase("%1", has_unit ? typed + " " + key.unit : typed);
}

}  // namespace

std::vector<DifferenceRow> profile_changes(const profile::ProfileDraft& draft) {
    std::vector<DifferenceRow> rows;
    for (std::size_t i = 0; i < profile_keys().size(); ++i) {
        const ProfileKey& key = profile_keys()[i];
        if (!draft.is_changed(i)) continue;
        rows.push_back(
            {phrase("%1", key.path), value_phrase(key, draft.saved(i)), value_phrase(key, draft.typed(i))});
    }
    return rows;
}

}  // namespace psicarve::session
