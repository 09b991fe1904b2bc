// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "hmi/session/background_queue.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// The machine's profile that a window was started with, read on a thread of its own while the window is open
/// already. All calls come from one thread, the owner's.
class ProfileArrival {
public:
    using Told = std::function<void(const Result<Profile>&)>;

    /// The poll() that finds it read calls `told`.
    void fetch(const std::string& path, Told told);
    /// The machine's profile is not known until then.
    bool is_awaited() const noexcept { return is_awaited_; }
    /// Call it at screen rate.
    void poll() { queue_.deliver(); }

private:
    bool is_awaited_ = false;
    BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::session
