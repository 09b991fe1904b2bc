// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_of_core.hpp"

#include <algorithm>

namespace psicarve::session {

void ProfileOfCore::offer(const Profile& profile) {
    const std::uint64_t hash = profile_hash(profile);
    const auto is_it = [hash](const Known& known) { return known.hash == hash; };
    if (std::any_of(known_.begin(), known_.end(), is_it)) return;
    known_.push_back({hash, profile});
    forget();
}

void ProfileOfCore::look(std::uint64_t hash, const std::optional<Profile>& chosen, MachineView& view) {
    if (hash == hash_) return;
    hash_ = hash;
    const bool is_other = hash != 0 && chosen && profile_hash(*chosen) != hash;
    view.unused_profile = is_other ? chosen->name : std::string{};
    view.core_profile_hash = hash;
    view.profile.reset();
    view.is_profile_of_job = false;
    for (const Known& known : known_) {
        if (known.hash == hash) view.profile = known.profile;
    }
}

void ProfileOfCore::search(const MachineView& view) {
    const std::uint64_t hash = view.core_profile_hash;
    const bool is_known = view.profile && !view.is_profile_of_job;
    if (is_known || hash == 0 || !view.is_heard() || !queue_.is_idle()) return;
    if (sought_hash_ == hash && sought_pid_ == view.core_pid) return;
    sought_hash_ = hash;
    sought_pid_ = view.core_pid;
    queue_.post([this, hash, pid = view.core_pid, find = search_]() -> BackgroundQueue::Finish {
        return [this, found = find(pid, hash)] {
            if (found) offer(*found);
        };
    });
}

}  // namespace psicarve::session
