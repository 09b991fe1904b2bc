// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "rtcore/guard/guard_link.hpp"
#include "rtcore/options/options.hpp"
#include "rtcore/port/open_port.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// A real port in its safe state, and the guard that owns it, too.
struct GuardedPort {
    port::OpenPort open;
    std::unique_ptr<guard::GuardLink> guard;  ///< null: --no-guard
};

/// Opens the real port that the options name and parts from the guard; before any thread is started. What
/// comes back is the core's port, or in the guard, when all is over, the exit code.
Result<std::variant<GuardedPort, int>> open_guarded_port(const CoreOptions& options, const Profile& profile);

}  // namespace psicarve::supervisor
