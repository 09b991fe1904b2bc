// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/guarded_port.hpp"

#include <cstdio>
#include <utility>

#include "rtcore/guard/guard.hpp"
#include "rtcore/supervisor/realtime_requirement.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::supervisor {

Result<std::variant<GuardedPort, int>> open_guarded_port(const CoreOptions& options, const Profile& profile) {
    using Side = std::variant<GuardedPort, int>;
    if (const auto allowed = require_realtime(options); !allowed) return allowed.error();
    const auto pin_map = PinMap::from_profile(profile);
    if (!pin_map) return pin_map.error();
    auto open = port::open_port(options.port, *pin_map);
    if (!open) return open.error();
    std::fprintf(stderr, "psicarve-rtcore: %s\n", open->description().c_str());
    if (options.no_guard) {
        std::fprintf(stderr, "psicarve-rtcore: no guard: if the core is killed, %s stay as they are\n",
                     names_of_powered(profile).c_str());
        return Side{GuardedPort{std::move(*open), nullptr}};
    }
    auto parted = guard::fork_guard({.safe_state = port::SafeState{open->access(), *pin_map},
                                     .segment_name = options.segment_name,
                                     .group = options.group});
    if (!parted) return parted.error();
    if (const int* exit_code = std::get_if<int>(&*parted)) return Side{*exit_code};
    auto link = std::make_unique<guard::GuardLink>(std::move(std::get<guard::GuardLink>(*parted)));
    return Side{GuardedPort{std::move(*open), std::move(link)}};
}

}  // namespace psicarve::supervisor
