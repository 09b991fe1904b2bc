// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace psicarve::doctor {

enum class Verdict : std::uint8_t { ok, warning, problem };

/// The result of one check that is made before a machine is driven from this computer.
struct Finding {
    std::string name;  ///< "locked memory"
    Verdict verdict = Verdict::ok;
    std::string seen;     ///< what the check found
    std::string meaning;  ///< why it matters; empty when ok
    std::string remedy;   ///< what to do; empty when ok
};

inline Finding fine(std::string name, std::string seen) {
    return {.name = std::move(name),
            .verdict = Verdict::ok,
            .seen = std::move(seen),
            .meaning = {},
            .remedy = {}};
}

}  // namespace psicarve::doctor
