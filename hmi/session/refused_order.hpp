// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/machine/command.hpp"
#include "shared/message/message.hpp"

namespace psicarve::session {

/// The group of buttons that gives an order.
enum class OrderPlace : std::uint8_t { position, jog, move, job, alarm, outputs };
OrderPlace place_of(CommandKind kind) noexcept;

/// An order that the core refused.
struct OrderRefusal {
    enum class Help : std::uint8_t { none, home_all, reset_alarm };
    OrderPlace place = OrderPlace::job;
    Phrase what;  ///< "Start: the machine is not homed; home first"
    Help help = Help::none;
};

/// What would help against it.
OrderRefusal::Help help_for(const psicarve::Message& why) noexcept;

/// The last refused order, for as long as that holds: until another order is given, its fields have changed,
/// or the machine's state has.
class RefusedOrder {
public:
    void note(OrderRefusal refusal, const MachineView& machine);
    /// Call it at every look at the machine.
    void look(const MachineView& machine);
    void forget() noexcept { told_.reset(); }
    void forget(OrderPlace place) noexcept {
        if (told_ && told_->place == place) forget();
    }
    /// Nothing: none was refused, or it holds no longer.
    const std::optional<OrderRefusal>& told() const noexcept { return told_; }

private:
    /// The part of the machine's state that a refusal depends on.
    struct Ground {
        bool is_heard = false;
        std::uint32_t core_pid = 0;
        MachineState state = MachineState::off;
        std::uint32_t homed_mask = 0;
        std::uint64_t alarm_count = 0;
        std::uint64_t job_generation = 0;
        SignalWord switches = 0;
        std::array<std::int64_t, kAxisCount> position_pulses{};  ///< at rest
        bool operator==(const Ground&) const = default;
    };
    static Ground ground_of(const MachineView& machine) noexcept;
    bool still_helps(const MachineView& machine) const noexcept;

    std::optional<OrderRefusal> told_;
    Ground ground_;
    std::uint64_t settled_heartbeat_ = 0;
};

}  // namespace psicarve::session
