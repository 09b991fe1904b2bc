// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

struct Check {
    enum class Verdict : std::uint8_t {
        pass,
        fail,     ///< nothing starts
        info,     ///< it does not apply here: neither passed nor failed
        warning,  ///< the operator should look at it, and may start then
    };
    Phrase name;
    Phrase detail;
    Verdict verdict = Verdict::fail;
    Phrase remedy{};  ///< where the check itself does not say what to do; else empty
};

inline constexpr std::size_t kMostChecks = 10;

/// The conditions for Start, in the order in which they are met. Start is locked exactly while one of them
/// fails (action_lock.hpp); docs/operator.md has a table of them.
std::vector<Check> preflight_checks(const MachineView& machine, const OpenJobView& job);

}  // namespace psicarve::session
