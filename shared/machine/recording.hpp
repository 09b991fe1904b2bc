// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "shared/machine/recording_form.hpp"

namespace psicarve {

// A process may have the core record every pin for it. It sends the command `record` with a token that it
// chooses; from then on the core puts the pieces of a pin trace, under that token, into the ring `recording`
// of the segment, until the process sends `record` again (value 0) or is dead. One recording at a time. The
// reader renews its lease by storing token and a new beat, and says in `recording_taken` how many entries of
// the ring it has: a core on the virtual clock waits for it, one on the real clock never does, and a reader
// that is too slow knows how many pieces it lost.

/// A reader that stores no new beat for this long counts as dead; its recording ends.
inline constexpr std::chrono::milliseconds kRecordingLease{2000};

}  // namespace psicarve
