// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "hmi/machine/jog.hpp"
#include "hmi/session/work_lane.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/jog_lease.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::session {

/// A hand on the jog buttons. The jog's lease is renewed by a thread of its own, but only while the owner
/// keeps calling poll(): a window that hangs lets go.
class JogHand {
public:
    using Refused = std::function<void(const Error&, bool is_of_test)>;
    /// `refused` is called by poll(). An owner, or a whole process, that is silent for `limit` hangs.
    JogHand(std::string segment_name, std::string group, Refused refused,
            std::chrono::milliseconds limit = kJogLease);
    ~JogHand() { release(); }

    /// Until release(). `speed` [mm/s; deg/s].
    void hold(machine::JogAxis axis, bool up, double speed);
    /// By a distance [mm; deg]. Ends early by release().
    void step(machine::JogAxis axis, double distance, double speed);
    /// No jog, but held alike: one output alone, with the drives off, until release(); or so many pulses.
    void test(Signal output, std::uint32_t pulses, double rate_hz);
    /// At once, whatever is under way.
    void release() noexcept { wanted_.store(0); }
    void poll();
    /// How often something was asked for: grows with each.
    std::uint64_t asked() const noexcept { return last_ticket_; }
    /// Nothing moves while it is locked.
    void set_locked(bool locked) noexcept {
        if (locked) release();
        is_locked_ = locked;
    }

private:
    struct Wish {
        machine::JogAxis axis;
        double distance;  ///< of a step
        bool up;
        bool is_step;
        double speed;  ///< of a test: pulses in a second
        std::uint64_t ticket;
        std::optional<Signal> output;  ///< of a test
        std::uint32_t pulses = 0;
    };
    void begin(Wish wish);
    Result<void> jog(const Wish& wish);
    Result<machine::HeldJog> take(machine::MachineLink& link, const Wish& wish) const;
    bool is_wanted(const Wish& wish) const noexcept;

    std::string segment_name_;
    std::string group_;
    Refused refused_;
    std::chrono::milliseconds limit_;
    std::atomic<std::uint64_t> wanted_{0};  ///< the ticket of the jog that goes on; 0: none
    std::atomic<std::int64_t> beat_ns_{0};  ///< when the owner was last heard
    std::uint64_t last_ticket_ = 0;
    bool is_locked_ = false;
    WorkLane lane_;  // last: its thread uses the others
};

}  // namespace psicarve::session
