// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "hmi/verify/motor/train_event.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

/// Position [pulses] over time [s].
using Motion = std::function<double(double)>;

/// From rest at `start_s`: a jump to `jump_pps`, up to `top_pps`, along for `cruise_s`, down again, a jump to
/// rest.
struct RampMotion {
    double jump_pps;
    double top_pps;
    double accel_pps2;
    double start_s = 0.02;
    double cruise_s = 0.03;

    double ramp_s() const { return (top_pps - jump_pps) / accel_pps2; }
    double end_s() const { return start_s + 2.0 * ramp_s() + cruise_s; }
    double operator()(double time_s) const {
        const double from_start_s = time_s - start_s;
        if (from_start_s <= 0.0) return 0.0;
        if (from_start_s <= ramp_s()) return climbed(from_start_s);
        const double cruised = climbed(ramp_s()) + top_pps * (from_start_s - ramp_s());
        if (from_start_s <= ramp_s() + cruise_s) return cruised;
        const double all = 2.0 * climbed(ramp_s()) + top_pps * cruise_s;
        return time_s >= end_s() ? all : all - climbed(end_s() - time_s);
    }

private:
    double climbed(double time_s) const { return jump_pps * time_s + 0.5 * accel_pps2 * time_s * time_s; }
};

/// How a controller turns a motion into pulses.
struct PulseMaker {
    std::int64_t tick_ns = 10'000;
    double phase_pulses = 0.0;   ///< where between two whole pulses the motion begins
    double jitter_pulses = 0.0;  ///< how early or late the interpolation may be
    std::uint32_t seed = 1;
};

/// A pulse in the first tick at which the motion is half a pulse past the count (and a good pulse when it
/// turns back, so that noise makes no pulses of its own). Motions are sampled once a tick.
inline std::vector<TrainEvent> pulses_of(const Motion& motion, double duration_s, const PulseMaker& maker) {
    std::mt19937 random(maker.seed);
    std::uniform_real_distribution<double> jitter(-maker.jitter_pulses, maker.jitter_pulses);
    std::vector<TrainEvent> events;
    std::int64_t count = 0;
    double shift = maker.phase_pulses + jitter(random);
    const double begin = motion(0.0);
    for (std::int64_t time_ns = 0; seconds_from_ns(time_ns) <= duration_s; time_ns += maker.tick_ns) {
        const double ahead = motion(seconds_from_ns(time_ns)) - begin + shift - static_cast<double>(count);
        if (ahead < 0.5 && ahead > -1.0) continue;
        const bool forward = ahead > 0.0;
        count += forward ? 1 : -1;
        events.push_back({time_ns, forward ? TrainEvent::Kind::forward : TrainEvent::Kind::backward});
        shift = maker.phase_pulses + jitter(random);
    }
    return events;
}

}  // namespace psicarve::verify
