// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace psicarve::rtcore {

/// "psicarve-rtcore: LINE" on standard error. Waits as long as whoever reads it lets it.
void say(std::string_view line) noexcept;

/// The same, but what cannot be said at once is not said: nobody's safety waits for a reader. Only a regular
/// file on a disk that hangs makes it wait.
void try_to_say(std::string_view line) noexcept;

}  // namespace psicarve::rtcore
