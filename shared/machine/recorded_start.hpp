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

/// What such a value asks for. A number from a file may be anything.
struct RecordedStart {
    std::uint32_t first_layer = 0;
    std::uint32_t layers = 0;        ///< 0: all that follow
    std::uint32_t point_number = 0;  ///< as in kRecordedFirstPoint
    bool is_dry = false;
};
constexpr RecordedStart recorded_start(std::uint64_t value) noexcept {
    constexpr unsigned kPointLow = 20;  // two parts of a point's number: 12 bits here, 8 above the layers'
    constexpr unsigned kLayers = 32;
    constexpr unsigned kPointHigh = 52;
    constexpr std::uint64_t kLowPart = 0xfffU;
    constexpr std::uint64_t kHighPart = 0xffU;
    const std::uint64_t point = (value >> kPointLow & kLowPart) | (value >> kPointHigh & kHighPart) << 12U;
    return {static_cast<std::uint32_t>(value & kRecordedFirstLayer),
            static_cast<std::uint32_t>(value >> kLayers & kRecordedFirstLayer),
            static_cast<std::uint32_t>(point), (value & kRecordedDryRun) != 0};
}

}  // namespace psicarve
