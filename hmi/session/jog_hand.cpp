// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/jog_hand.hpp"

#include <chrono>
#include <utility>

#include "hmi/machine/jog.hpp"
#include "hmi/machine/machine_link.hpp"

namespace psicarve::session {
namespace {

using machine::HeldJog;
using machine::MachineLink;

std::int64_t now_ns() noexcept {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds{1};
}

}  // namespace

JogHand::JogHand(std::string segment_name, std::string group, Refused refused, Remarked remarked,
                 std::chrono::milliseconds limit)
    : segment_name_(std::move(segment_name)),
      group_(std::move(group)),
      refused_(std::move(refused)),
      remarked_(std::move(remarked)),
      limit_(limit) {}

void JogHand::hold(machine::JogAxis axis, bool up, double speed) {
    begin({axis, 0.0, up, false, speed, 0, {}});
}

void JogHand::step(machine::JogAxis axis, double distance, double speed) {
    begin({axis, distance, distance > 0.0, true, speed, 0, {}});
}

void JogHand::test(Signal output, std::uint32_t pulses, double rate_hz) {
    begin({Axis::r1, 0.0, true, false, rate_hz, 0, output, pulses});
}

void JogHand::poll() {
    beat_ns_.store(now_ns());
    queue_.deliver();
}

void JogHand::begin(Wish wish) {
    if (is_locked_) return;
    beat_ns_.store(now_ns());
    wish.ticket = ++last_ticket_;
    wanted_.store(wish.ticket);
    queue_.post([this, wish]() -> BackgroundQueue::Finish {
        const auto went = jog(wish);
        if (went && went->is_none()) return {};
        if (went) return [this, remark = *went] { remarked_(remark); };
        return [this, error = went.error(), is_of_test = wish.output.has_value()] {
            refused_(error, is_of_test);
        };
    });
}

bool JogHand::is_wanted(const Wish& wish) const noexcept {
    const std::chrono::nanoseconds silence{now_ns() - beat_ns_.load()};
    return wanted_.load() == wish.ticket && silence < limit_;
}

Result<HeldJog> JogHand::take(MachineLink& link, const Wish& wish) const {
    if (wish.output) return HeldJog::test(link, *wish.output, wish.pulses, wish.speed, limit_);
    if (wish.is_step) return HeldJog::by(link, wish.axis, wish.distance, wish.speed);
    return HeldJog::on(link, wish.axis, wish.up, wish.speed, limit_);
}

/// What the core said of it, once it has ended.
Result<psicarve::Message> JogHand::jog(const Wish& wish) {
    if (!is_wanted(wish)) return psicarve::Message{};
    auto link = MachineLink::attach(segment_name_, group_);
    if (!link) return link.error();
    auto held = take(*link, wish);
    if (!held) return held.error();
    const psicarve::Message remark = link->command_remark();
    const auto watch = [&](const CoreStatus&) -> Result<void> {
        if (is_wanted(wish)) {
            held->renew();
        } else {
            held->release();
        }
        return {};
    };
    const auto end = link->wait_for_state({wish.output ? MachineState::off : MachineState::ready}, watch);
    if (!end) return end.error();
    return remark;
}

}  // namespace psicarve::session
