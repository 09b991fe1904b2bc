// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include "shared/machine/jog_lease_word.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve {

// A jog goes on only as long as its sender renews its lease through one word of the segment, `jog_lease`. The
// word holds a token, which the sender chose and sent with the command, and a beat; any change of the beat
// renews, beat 0 ends the jog. A sender that dies or hangs stops renewing, and the token keeps a late sender
// from renewing another's jog.

/// In a jog's `axis`: R1 and R2 together, both outwards or both inwards.
inline constexpr std::uint32_t kBothHeads = kAxisCount;

inline constexpr std::chrono::milliseconds kJogLease{200};          ///< for a hand on a button
inline constexpr std::chrono::milliseconds kLongestJogLease{2000};  ///< a longer one is cut to this
inline constexpr std::chrono::milliseconds kJogRenewal{50};

class Segment;
/// Stores the word and wakes the core.
void write_jog_lease(Segment& segment, std::uint32_t token, std::uint32_t beat) noexcept;

}  // namespace psicarve
