// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/extended_mode.hpp"

#include <algorithm>
#include <array>

#include "rtcore/port/port_access.hpp"

namespace psicarve::port {
namespace {

constexpr std::uint16_t kIsaOffset = 0x402;
/// The kernel names the first of the three extended registers; the control register is the last.
constexpr std::uint16_t kOffsetInBlock = 2;
// Modes 000 SPP and 001 PS/2 with no error interrupt, no DMA, no service interrupt; as read, with the bit of
// an empty FIFO. Source: IEEE 1284 ECP register set; Linux parport_pc, parport_ECR_present().
constexpr std::uint8_t kPlainMode = 0x14;
constexpr std::uint8_t kProbe = 0x34;
constexpr std::uint8_t kProbeAnswer = 0x35;

}  // namespace

std::optional<std::uint16_t> extended_address(std::uint16_t base, const std::vector<KernelPort>& ports) {
    const auto listed = std::ranges::find(ports, base, &KernelPort::base);
    if (listed == ports.end()) {
        if (!is_classic_base(base)) return std::nullopt;
        return static_cast<std::uint16_t>(base + kIsaOffset);
    }
    if (listed->extended_base == 0) return std::nullopt;
    return static_cast<std::uint16_t>(listed->extended_base + kOffsetInBlock);
}

std::string extended_mode_text(std::uint8_t extended, std::uint8_t control) {
    constexpr std::array kModes{"SPP", "PS/2",     "parallel FIFO", "ECP",
                                "EPP", "reserved", "test",          "configuration"};
    constexpr unsigned kFifoBits = 3;  // full, empty: at rest the FIFO is empty
    constexpr unsigned kEmpty = 1;
    constexpr unsigned kModeShift = 5;
    const bool is_mirror = extended == control;
    if (extended == kNothingThere || is_mirror || (extended & kFifoBits) != kEmpty) return {};
    return kModes[extended >> kModeShift];
}

std::string take_plain_mode(Bus& bus, std::uint16_t base, std::uint16_t extended_address) {
    const std::uint8_t found = bus.read(extended_address);
    const std::string mode =
        extended_mode_text(found, bus.read(static_cast<std::uint16_t>(base + kControlOffset)));
    if (mode.empty()) return "SPP";
    bus.write(extended_address, kProbe);
    if (bus.read(extended_address) != kProbeAnswer) {
        bus.write(extended_address, found);
        return "mode unknown";
    }
    bus.write(extended_address, kPlainMode);
    return "found in mode " + mode;
}

}  // namespace psicarve::port
