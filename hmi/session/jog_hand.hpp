// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "hmi/machine/jog.hpp"
#include "hmi/session/background_queue.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/jog_lease.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::session {

/// The operator's hand on the jog buttons. A thread of its own renews the jog's lease, but only while the
/// owner keeps calling poll(): a window that hangs ends the jog.
class JogHand {
public:
    using Refused = std::function<void(const Error&, bool is_of_test)>;
    /// What the core said of a jog that it took: that its speed is limited.
    using Remarked = std::function<void(const psicarve::Message&)>;
    /// poll() calls `refused` and `remarked`. An owner, or a whole process, that is silent for `limit` counts
    /// as hanging.
    JogHand(std::string segment_name, std::string group, Refused refused, Remarked remarked,
            std::chrono::milliseconds limit = kJogLease);
    ~JogHand() { release(); }

    /// Jogs until release(). `speed` [mm/s; deg/s].
    void hold(machine::JogAxis axis, bool up, double speed);
    /// Jogs by a distance [mm; deg]. release() ends it early.
    void step(machine::JogAxis axis, double distance, double speed);
    /// An output test, held the same way: one output alone, with the drives off, until release(); or `pulses`
    /// pulses.
    void test(Signal output, std::uint32_t pulses, double rate_hz);
    /// Ends it at once.
    void release() noexcept { wanted_.store(0); }
    void poll();
    /// The number of requests so far.
    std::uint64_t asked() const noexcept { return last_ticket_; }
    /// Refuses and ends all motion while it is locked.
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
    Result<psicarve::Message> jog(const Wish& wish);
    Result<machine::HeldJog> take(machine::MachineLink& link, const Wish& wish) const;
    bool is_wanted(const Wish& wish) const noexcept;

    std::string segment_name_;
    std::string group_;
    Refused refused_;
    Remarked remarked_;
    std::chrono::milliseconds limit_;
    std::atomic<std::uint64_t> wanted_{0};  ///< the ticket of the present jog; 0: none
    std::atomic<std::int64_t> beat_ns_{0};  ///< when the owner last called
    std::uint64_t last_ticket_ = 0;
    bool is_locked_ = false;
    BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::session
