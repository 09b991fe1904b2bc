// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "hmi/verify/motor/motor_reach.hpp"
#include "hmi/verify/motor/train_event.hpp"

namespace psicarve::verify {

/// The limit that a stretch of pulses requires.
struct TrainDemand {
    bool is_speed = false;  ///< no acceleration suffices: the top speed is exceeded
    double needed = 0.0;    ///< the least limit with which a motion exists [pulses/s^2 or pulses/s]
};

/// Found by bisection, to a ten-thousandth, and never less than the limit itself.
TrainDemand demand_of(std::span<const TrainEvent> stretch, const MotorLimits& limits);

}  // namespace psicarve::verify
