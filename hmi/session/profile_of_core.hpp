// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "hmi/session/background_queue.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// Finds the profile that a core runs by: the core tells only its hash, so the profile is one of those that
/// were offered, or is searched in files. All calls come from one thread, the owner's.
class ProfileOfCore {
public:
    /// May take long: it is called by a thread of its own.
    using Search = std::function<std::optional<Profile>(std::uint32_t core_pid, std::uint64_t hash)>;
    explicit ProfileOfCore(Search search) : search_(std::move(search)) {}

    /// One that a core may have.
    void offer(const Profile& profile);
    /// The next look begins anew, as if the core were another.
    void forget() noexcept { hash_ = 0; }
    /// The core tells `hash`; 0: none. Where it is another one than before, writes the view's profile and
    /// hash, and the name of `chosen` as unused where that one is not the core's.
    void look(std::uint64_t hash, const std::optional<Profile>& chosen, MachineView& view);
    /// Begins a search in files, once for each core that is heard and whose profile is not known.
    void search(const MachineView& view);
    /// Takes what was found; the next look has it. Call it at screen rate.
    void poll() { queue_.deliver(); }

private:
    struct Known {
        std::uint64_t hash;
        Profile profile;
    };

    Search search_;
    std::vector<Known> known_;
    std::uint64_t hash_ = 0;         ///< as it was looked at last
    std::uint64_t sought_hash_ = 0;  ///< searched in files last
    std::uint32_t sought_pid_ = 0;
    /// A disk that hangs must not delay attaching. Last: its thread uses the others.
    BackgroundQueue queue_{BackgroundQueue::Haste::background};
};

}  // namespace psicarve::session
