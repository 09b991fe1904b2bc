// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/sensor.hpp"

namespace psicarve::sim {

Sensor::Sensor(const SensorConfig& config, std::int64_t pulses_per_turn, std::int64_t start_pulses) noexcept
    : config_(config),
      pulses_per_turn_(pulses_per_turn),
      turn_start_pulses_(config.edge_pulses),
      tripped_(is_tripped_at(start_pulses)),
      shown_(tripped_) {}

bool Sensor::is_tripped_at(std::int64_t position_pulses) noexcept {
    switch (config_.kind) {
        case SensorKind::none:
            return false;
        case SensorKind::low_end:
            return position_pulses <= config_.edge_pulses;
        case SensorKind::high_end:
            return position_pulses >= config_.edge_pulses;
        case SensorKind::index:
            break;
    }
    // One or two turns at most lie between two calls, so that following the turns beats a division.
    while (position_pulses < turn_start_pulses_) turn_start_pulses_ -= pulses_per_turn_;
    while (position_pulses >= turn_start_pulses_ + pulses_per_turn_) turn_start_pulses_ += pulses_per_turn_;
    return position_pulses - turn_start_pulses_ < config_.width_pulses;
}

bool Sensor::move_to(std::int64_t position_pulses, std::int64_t time_ns) noexcept {
    const bool tripped = is_tripped_at(position_pulses);
    if (tripped == tripped_) return false;
    tripped_ = tripped;
    changed_ns_ = time_ns;
    return true;
}

bool Sensor::shows(std::int64_t time_ns) noexcept {
    bool shown = tripped_;
    const std::int64_t since_ns = time_ns - changed_ns_;
    if (since_ns < config_.bounce_ns && (since_ns / config_.bounce_half_period_ns) % 2 == 1)
        shown = !tripped_;
    if (config_.fault != SensorFault::none) shown = config_.fault == SensorFault::always_trips;
    if (shown != shown_) changes_.add(1);
    shown_ = shown;
    return shown;
}

std::int64_t Sensor::next_change_ns(std::int64_t time_ns) const noexcept {
    const std::int64_t since_ns = time_ns - changed_ns_;
    if (since_ns >= config_.bounce_ns) return kForeverNs;
    const std::int64_t next_ns =
        (since_ns / config_.bounce_half_period_ns + 1) * config_.bounce_half_period_ns;
    return changed_ns_ + (next_ns < config_.bounce_ns ? next_ns : config_.bounce_ns);
}

}  // namespace psicarve::sim
