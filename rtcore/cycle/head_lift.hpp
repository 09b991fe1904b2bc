// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// Takes both heads out of the cut while a run is on hold, and back to the very pulse from which they went,
/// screws' gaps included:
///
///     rest - out - lifted ... rest - back - (gaps as they were) - rest - on the path
///
/// Each way is from rest to rest and can be turned round: hold while they come back, resume while they go
/// out. The config outlives it. RT: yes.
class HeadLift {
public:
    HeadLift(const CycleConfig& config, PulseStage& pulses) noexcept : config_(&config), pulses_(&pulses) {}

    bool is_active() const noexcept { return aim_ != Aim::none; }
    /// From the path, where everything rests, or on the way back to it.
    void lift() noexcept;
    void lower() noexcept;
    /// Comes to rest wherever the heads are; then they are not its own any more.
    void halt() noexcept { turn_to(Aim::halt); }
    void forget() noexcept {
        aim_ = Aim::none;
        is_moving_ = false;
    }

    enum class Progress : std::uint8_t { going_on, lifted, back, halted };
    /// Requires is_active().
    Progress step(std::uint64_t tick) noexcept;

private:
    enum class Aim : std::uint8_t { none, out, path, halt };

    void turn_to(Aim aim) noexcept;
    Progress next_leg(std::uint64_t tick) noexcept;
    bool begin_leg(const std::array<std::int64_t, kAxisCount>& way_pulses, std::uint64_t tick) noexcept;
    void move(std::uint64_t tick) noexcept;

    const CycleConfig* config_;
    PulseStage* pulses_;
    FineMove fine_;
    Aim aim_ = Aim::none;
    bool is_moving_ = false;
    bool must_rest_ = false;
    std::int64_t rest_left_ = 0;
    std::array<std::int64_t, kHeads> path_pulses_{};  ///< where the tips left the path
    std::array<std::int64_t, kHeads> out_pulses_{};
    std::array<std::int64_t, kHeads> path_slack_{};  ///< pulses upwards, there, before a tip follows
};

}  // namespace psicarve::cycle
