// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"

namespace psicarve::cycle {

/// What became of a request.
struct Verdict {
    Refusal refusal;              ///< none: done
    std::uint8_t axis = kNoAxis;  ///< the one for which it is refused, where there is one
};

}  // namespace psicarve::cycle
