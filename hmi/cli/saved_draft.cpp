// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/saved_draft.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/cli/exit_code.hpp"
#include "hmi/profile/calibration_steps.hpp"

namespace psicarve::cli {
namespace {

nlohmann::ordered_json changes_json(const profile::ProfileDraft& draft) {
    auto changes = nlohmann::ordered_json::object();
    for (const profile::KeyChange& change : profile::changes_of(draft))
        changes[change.key] = {{"from", change.from}, {"to", change.to}};
    return changes;
}

}  // namespace

Result<int> save_draft(profile::ProfileDraft& draft, const CommonOptions& common) {
    const std::string changes = profile::changes_text(draft);
    const auto as_json = changes_json(draft);
    const bool is_backed_up = !changes.empty() && draft.keeps_backup();
    if (!changes.empty()) {
        if (const auto saved = draft.save(); !saved) return saved.error();
    }
    const std::string backup = profile::ProfileDraft::backup_path(draft.path());
    if (common.json) {
        const nlohmann::ordered_json report{
            {"profile", draft.path()},
            {"backup", is_backed_up ? nlohmann::ordered_json(backup) : nlohmann::ordered_json()},
            {"changes", as_json}};
        std::printf("%s\n", report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    } else if (changes.empty()) {
        std::printf("%s: nothing changed\n", draft.path().c_str());
    } else {
        std::printf("%s%s: written%s. Start the core with it, and slice models anew.\n", changes.c_str(),
                    draft.path().c_str(), is_backed_up ? (", the old one is " + backup).c_str() : "");
    }
    return kExitDone;
}

}  // namespace psicarve::cli
