// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace psicarve::rtcore {

/// Writes "psicarve-rtcore: LINE" to standard error. Waits as long as the reader lets it.
void say(std::string_view line) noexcept;

/// The same, but drops the line when it cannot be written at once: safety must not wait for a reader. Only a
/// regular file on a disk that hangs makes it wait.
void try_to_say(std::string_view line) noexcept;

}  // namespace psicarve::rtcore
