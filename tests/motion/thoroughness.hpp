// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::motion {

/// Sanitizers look for other faults than sweeps do, and take twenty times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

}  // namespace psicarve::motion
