// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace psicarve {

/// Why a program may not access the addresses of a port.
struct RawRefusal {
    std::string reason;
    std::string remedy;
};

/// Makes a reason of ioperm()'s error number; `has_right`: the program has CAP_SYS_RAWIO all the same.
RawRefusal raw_refusal(int error, bool has_right);

/// Gives the calling thread access to `count` addresses from `base` on, as a core does. Nothing: it has them.
std::optional<RawRefusal> take_addresses(std::uint16_t base, std::uint16_t count);

/// Takes the addresses to see whether it can, and gives them back.
std::optional<RawRefusal> ask_for_addresses(std::uint16_t base, std::uint16_t count);

}  // namespace psicarve
