// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shared/wording/wording.hpp"

namespace psicarve {

// The table in its parts, by their numbers: what follows has greater ones.

std::span<const Wording> command_wordings() noexcept;
std::span<const Wording> job_wordings() noexcept;
std::span<const Wording> program_wordings() noexcept;

}  // namespace psicarve
