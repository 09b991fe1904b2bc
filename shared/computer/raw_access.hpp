// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace psicarve {

/// Why a program is not let at the addresses of a port.
struct RawRefusal {
    std::string reason;
    std::string remedy;
};

/// What ioperm() failed with; `has_right`: although the program has CAP_SYS_RAWIO.
RawRefusal raw_refusal(int error, bool has_right);

/// Takes so many addresses from `base` on for the calling thread, as a core does. Nothing: it has them.
std::optional<RawRefusal> take_addresses(std::uint16_t base, std::uint16_t count);

/// Asks whether it could, and leaves them.
std::optional<RawRefusal> ask_for_addresses(std::uint16_t base, std::uint16_t count);

}  // namespace psicarve
