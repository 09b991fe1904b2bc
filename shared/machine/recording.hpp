// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "shared/machine/recording_form.hpp"

namespace psicarve {

// A process may have the core record every pin for it: it sends the command `record` with a token of its own
// choice, and from then on the pieces of a pin trace come through the ring `recording` of the segment, under
// that token, until the process sends `record` again (value 0) or is no more. One recording at a time. The
// reader renews its lease by storing token and a new beat, and says in `recording_taken` how many entries of
// the ring it has: a core on the virtual clock waits for it, one by the wall clock never does, and a reader
// that was too slow knows how many pieces it lost.

/// A reader that stores no new beat for so long is taken for dead; its recording ends.
inline constexpr std::chrono::milliseconds kRecordingLease{2000};

}  // namespace psicarve
