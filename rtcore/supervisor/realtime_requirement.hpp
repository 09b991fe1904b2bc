// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/options/options.hpp"
#include "shared/base/result.hpp"

namespace psicarve::supervisor {

/// Before a real port is touched: may a thread of this process be scheduled in real time? If not, the error
/// says what to do, unless the options allow to go on without. The simulated port asks for nothing.
Result<void> require_realtime(const CoreOptions& options);

}  // namespace psicarve::supervisor
