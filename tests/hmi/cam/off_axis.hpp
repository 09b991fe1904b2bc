// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// With a blank of 12 mm that stands 5 mm off the table's axis, towards direction 307.
inline Profile off_axis() {
    Profile profile;
    profile.blank = {12.0, 20.0, 3.0, -4.0};
    return profile;
}

}  // namespace psicarve::cam
