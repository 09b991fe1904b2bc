// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hmi/gcode/position.hpp"

namespace psicarve::gcode {

enum class FeedMode : std::uint8_t { inverse_time, per_minute, per_revolution };

inline constexpr double kMmPerInch = 25.4;

/// The modes that hold from block to block, with their values at a program's begin.
struct ModalState {
    int motion = 800;
    const Plane* plane = &kPlaneXy;
    bool is_incremental = false;
    bool has_absolute_centres = false;
    FeedMode feed_mode = FeedMode::per_minute;
    double mm_per_unit = 1.0;
    /// As written, per minute, turn or move; 0: none is given.
    double feed_number = 0.0;
    double feed_mm = 0.0;  ///< the same, taken as a length in the units of that time
    bool retracts_to_start = false;
    double spindle_rpm = 0.0;
    bool is_spindle_on = false;
    bool is_spindle_reverse = false;
    bool is_mist_on = false;
    bool is_flood_on = false;
    bool are_overrides_off = false;  ///< M49
    int path = 640;                  ///< G61 G61.1 G64
    int length = 490;                ///< G43.1 G49
    double tool = 0.0;               ///< selected
    double tool_in_spindle = 0.0;
};

/// Letters that a program has set where it had not set the place before: the result is not known.
struct UnknownZeros {
    AxisMask shift = 0;
    AxisMask tool = 0;
    std::array<AxisMask, 9> origins{};
    std::array<AxisMask, 2> references{};
};

/// Words of a drilling cycle, kept while the same one goes on [mm, s].
struct CycleWords {
    double clear_mm = 0.0;    ///< R
    double depth_mm = 0.0;    ///< the word of the axis across the plane
    double peck_mm = 0.0;     ///< Q
    double dwell_s = 0.0;     ///< P
    double initial_mm = 0.0;  ///< where the axis stood before the first hole
};

}  // namespace psicarve::gcode
