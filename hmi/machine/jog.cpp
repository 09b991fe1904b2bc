// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/jog.hpp"

#include <atomic>
#include <utility>

#include "shared/computer/process_identity.hpp"

namespace psicarve::machine {
namespace {

/// Differs for each jog, and is hardly ever another process's.
std::uint32_t new_token() noexcept {
    static std::atomic<std::uint32_t> count{0};
    const std::uint32_t token = own_pid() * 2654435761U + count.fetch_add(1);
    return token != 0 ? token : 1;
}

Command jog_command(CommandKind kind, JogAxis axis, double value, double speed) noexcept {
    Command command{};
    command.kind = kind;
    command.axis = axis.number();
    command.value = value;
    command.speed = speed;
    return command;
}

}  // namespace

Result<HeldJog> HeldJog::begin(MachineLink& link, Command command, std::chrono::milliseconds lease) {
    HeldJog jog{link, new_token()};
    command.lease_token = jog.token_;
    command.lease_ms = static_cast<std::uint32_t>(lease.count());
    if (const auto sent = link.send(command); !sent) {
        jog.is_released_ = true;
        return sent.error();
    }
    // Not before: the word may still hold the beat with which an earlier holder ended its jog.
    jog.renew();
    return jog;
}

Result<HeldJog> HeldJog::by(MachineLink& link, JogAxis axis, double distance, double speed,
                            std::chrono::milliseconds lease) {
    return begin(link, jog_command(CommandKind::jog, axis, distance, speed), lease);
}

Result<HeldJog> HeldJog::on(MachineLink& link, JogAxis axis, bool up, double speed,
                            std::chrono::milliseconds lease) {
    return begin(link, jog_command(CommandKind::jog_on, axis, up ? 1.0 : -1.0, speed), lease);
}

Result<HeldJog> HeldJog::test(MachineLink& link, Signal output, std::uint32_t pulses, double rate_hz,
                              std::chrono::milliseconds lease) {
    Command command{};
    command.kind = CommandKind::test_pin;
    command.axis = static_cast<std::uint32_t>(index_of(output));
    command.value = 1.0;
    command.value2 = pulses;
    command.speed = rate_hz;
    return begin(link, command, lease);
}

HeldJog::HeldJog(HeldJog&& other) noexcept
    : link_(other.link_),
      token_(other.token_),
      beat_(other.beat_),
      is_released_(std::exchange(other.is_released_, true)),
      renewed_(other.renewed_) {}

void HeldJog::renew() noexcept {
    const auto now = std::chrono::steady_clock::now();
    if (is_released_ || now - renewed_ < kJogRenewal / 2) return;
    renewed_ = now;
    // 0 would end the jog.
    if (++beat_ == 0) ++beat_;
    write_jog_lease(link_->segment(), token_, beat_);
}

void HeldJog::release() noexcept {
    if (std::exchange(is_released_, true)) return;
    write_jog_lease(link_->segment(), token_, 0);
}

}  // namespace psicarve::machine
