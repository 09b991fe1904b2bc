// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve {

// The word `jog_lease` of the segment: the token of the lease, and its beat; beat 0 ends the jog. Apart from
// the rest of jog_lease.hpp, because the tick reads it. RT: yes.

constexpr std::uint64_t jog_lease_word(std::uint32_t token, std::uint32_t beat) noexcept {
    return (std::uint64_t{token} << 32U) | beat;
}
constexpr std::uint32_t jog_lease_token(std::uint64_t word) noexcept {
    return static_cast<std::uint32_t>(word >> 32U);
}
constexpr std::uint32_t jog_lease_beat(std::uint64_t word) noexcept {
    return static_cast<std::uint32_t>(word);
}

}  // namespace psicarve
