// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve {

/// In the value of a recorded start (flight recorder): it was a dry run.
inline constexpr std::uint64_t kRecordedDryRun = std::uint64_t{1} << 63U;

/// In the same value: the first layer that is carved; 0: the job from its beginning.
inline constexpr std::uint64_t kRecordedFirstLayer = 0xf'ffffU;

/// In the same value: one more than the point of that layer's table that was begun with; 0: the layer's
/// begin.
inline constexpr std::uint64_t kRecordedFirstPoint = 0xff0'0000'fff0'0000U;

}  // namespace psicarve
