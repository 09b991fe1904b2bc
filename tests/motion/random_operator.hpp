// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::motion {

/// Holds, resumes and overrides, of programs that of rapids too, at random ticks, half of `longest_span`
/// apart in the mean.
class Operator {
public:
    enum class Of { jobs, programs };
    explicit Operator(std::uint64_t seed, std::uint64_t longest_span = 4000, Of of = Of::jobs)
        : random_(seed), longest_span_(longest_span), of_(of) {}
    void operator()(cycle::MachineRig& rig) {
        const std::uint64_t now = rig.cycle->next_tick();
        if (now < next_tick_) return;
        next_tick_ = now + 1 + random_() % longest_span_;
        const MachineState state = rig.cycle->state();
        if (state != MachineState::carving) {
            rig.ask(cycle::RequestKind::resume);
        } else if (random_() % 3 == 0) {
            rig.ask(cycle::RequestKind::hold);
        } else if (of_ == Of::programs && random_() % 3 == 0) {
            rig.ask(cycle::RequestKind::rapid_override, 0, 10 + random_() % 91);
        } else {
            rig.ask(cycle::RequestKind::override, 0, 10 + random_() % 191);
        }
    }

private:
    std::mt19937_64 random_;
    std::uint64_t longest_span_;
    Of of_;
    std::uint64_t next_tick_ = 0;
};

/// A stop at one tick, also while the machine is held or slows down.
class Stopper {
public:
    Stopper(std::uint64_t seed, std::uint64_t longest_span, std::uint64_t latest_tick = 100'000)
        : operator_(seed, longest_span), random_(seed), latest_tick_(latest_tick) {}
    void operator()(cycle::MachineRig& rig) {
        if (stop_tick_ == 0) stop_tick_ = rig.cycle->next_tick() + 1 + random_() % latest_tick_;
        if (rig.cycle->next_tick() == stop_tick_) rig.stop();
        operator_(rig);
    }

private:
    Operator operator_;
    std::mt19937_64 random_;
    std::uint64_t latest_tick_;
    std::uint64_t stop_tick_ = 0;
};

}  // namespace psicarve::motion
