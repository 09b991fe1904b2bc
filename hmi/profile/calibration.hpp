// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/profile/profile_draft.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::profile {

// Turns measurements at the machine into values of its profile. Each function puts them into the draft, or
// refuses (bad_input) an impossible measurement and leaves the draft as it is.

/// A head's tip touches a pin that stands on the axis, while the core counts `counted_mm` for it. Sets the
/// tip's offset, and the tool's wear to none.
Result<void> touch_off(ProfileDraft& draft, Axis head, double pin_diameter_mm, double counted_mm);

/// Two marks on a round blank, R1's and R2's, that would fall together on a machine without error: each made
/// at the same height, R2's with the table half a turn on. `around_mm`: from R1's to R2's along the surface,
/// counter-clockwise seen from above; `up_mm`: how much higher R2's is.
Result<void> two_marks(ProfileDraft& draft, double blank_diameter_mm, double around_mm, double up_mm);

/// How much shorter a head's tool has become since its touch-off.
Result<void> tool_wear(ProfileDraft& draft, Axis head, double wear_mm);

}  // namespace psicarve::profile
