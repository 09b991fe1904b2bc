// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/known_profile.hpp"

#include <utility>

#include "hmi/cli/job_source.hpp"
#include "hmi/machine/core_profile.hpp"

namespace psicarve::cli {

Result<KnownProfile> KnownProfile::read(const CommonOptions& common) {
    auto chosen = readable_profile(common);
    if (!chosen) return chosen.error();
    KnownProfile known{!common.profile.empty()};
    known.chosen_ = std::move(chosen).value();
    return known;
}

std::optional<Profile> KnownProfile::of(machine::MachineLink& link) {
    const std::uint64_t hash = link.segment().header().core_profile_hash.load();
    if (chosen_ && profile_hash(*chosen_) == hash) return chosen_;
    if (is_named_) return std::nullopt;
    if (looked_for_hash_ != hash) {
        looked_for_hash_ = hash;
        found_ = machine::find_core_profile(link.core_pid().value_or(0), hash);
    }
    return found_;
}

}  // namespace psicarve::cli
