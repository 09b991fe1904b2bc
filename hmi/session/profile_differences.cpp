// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_differences.hpp"

#include <string>

namespace psicarve::session {

std::vector<Phrase> profile_differences(const Profile& core, const Profile& here, std::size_t most) {
    const auto of_core = profile_values(core);
    const auto of_here = profile_values(here);
    std::vector<Phrase> told;
    std::size_t count = 0;
    for (std::size_t key = 0; key < of_core.size(); ++key) {
        if (of_core[key] == of_here[key] || ++count > most) continue;
        told.push_back(phrase("%1: core %2, here %3", profile_keys()[key].path, of_core[key], of_here[key]));
    }
    if (count > most) told.push_back(phrase("%1 more", std::to_string(count - most)));
    return told;
}

}  // namespace psicarve::session
