// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "hmi/verify/motor/motor_reach.hpp"
#include "hmi/verify/motor/train_event.hpp"

namespace psicarve::verify {

/// What a stretch of pulses asks for.
struct TrainDemand {
    bool is_speed = false;  ///< no acceleration would do: the top speed is what is exceeded
    double needed = 0.0;    ///< the least limit with which a motion exists [pulses/s^2 or pulses/s]
};

/// Found by bisection, to a ten-thousandth, and never less than the limit itself.
TrainDemand demand_of(std::span<const TrainEvent> stretch, const MotorLimits& limits);

}  // namespace psicarve::verify
