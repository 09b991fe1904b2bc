// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/persistence.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <thread>

#include "shared/machine/signal.hpp"

namespace psicarve::port {
namespace {

/// The outputs that the kernel's claim switches on, by name; other outputs are not known.
std::string may_be_on(const PinMap& pin_map) {
    constexpr std::uint8_t kControlAfterClaim = 0x0c;  // Source: Linux parport_pc, parport_pc_init_state()
    OutputRegisters registers = pin_map.encode(0);
    registers.control = kControlAfterClaim;
    const SignalWord active = pin_map.outputs_from_registers(registers);
    std::string names;
    using enum Signal;
    for (const Signal signal : {spindle, r1_enable, r2_enable, psi_enable, y_enable, mist, flood, output_0,
                                output_1, output_2, output_3}) {
        if ((active & bit_of(signal)) == 0 || !pin_map.is_wired(signal)) continue;
        names += std::string{name_of(signal)} + ", ";
    }
    return "may be on: " + names + "and whatever was before";
}

}  // namespace

bool write_until_taken(const SafeState& safe_state, std::chrono::milliseconds patience,
                       const std::function<bool()>& gives_up) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kLongestPause{100};
    const auto end = Clock::now() + patience;
    std::chrono::milliseconds pause{1};
    while (!safe_state.write()) {
        if (Clock::now() >= end || (gives_up && gives_up())) return false;
        std::this_thread::sleep_for(pause);
        pause = std::min(2 * pause, kLongestPause);
    }
    return true;
}

Result<void> make_safe_at_opening(const PortAccess& access, const PinMap& pin_map, const std::string& name) {
    constexpr std::chrono::milliseconds kPatience{5'000};
    const std::string silent = name + ": does not take what is written to it; " + may_be_on(pin_map);
    bool is_said = false;
    const auto say_once = [&] {
        if (!is_said) std::fprintf(stderr, "psicarve-rtcore: %s; trying for 5 s\n", silent.c_str());
        is_said = true;
        return false;
    };
    if (!write_until_taken(SafeState{access, pin_map}, kPatience, say_once)) {
        return Error{ErrorCode::machine_refused, silent + "; switch the machine off by its own switch"};
    }
    if (is_said) std::fprintf(stderr, "psicarve-rtcore: %s: it answers again, and is safe\n", name.c_str());
    return {};
}

}  // namespace psicarve::port
