// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/wording/argument_words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "shared/base/decimals.hpp"
#include "shared/base/message_text.hpp"
#include "shared/machine/message_argument.hpp"

namespace psicarve {
namespace {

bool is_number(double value) noexcept {
    constexpr double kMost = 1e39;  // as decimals() can write
    return std::isfinite(value) && std::fabs(value) < kMost;
}

bool are_states(std::uint64_t bits) noexcept {
    for (; bits != 0; bits >>= 4U)
        if ((bits & 0xFU) == 0 || (bits & 0xFU) > kMachineStateCount) return false;
    return true;
}

std::string speed_text(double speed, const char* unit) {
    std::array<char, 64> text{};
    (void)std::snprintf(text.data(), text.size(), "%g %s", speed, unit);
    return text.data();
}

std::string signals_text(std::uint64_t signals) {
    std::string names;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        if ((signals >> i & 1U) == 0) continue;
        names += (names.empty() ? "" : ", ");
        names += name_of(static_cast<Signal>(i));
    }
    return names;
}

std::string states_text(std::uint64_t bits) {
    std::string names;
    for (; bits != 0; bits >>= 4U) {
        names += (names.empty() ? "" : " or ");
        names += name_of(static_cast<MachineState>((bits & 0xFU) - 1));
    }
    return names;
}

std::string way_out_text(MachineState state) {
    using S = MachineState;
    switch (state) {
        case S::off:
            return "home first";
        case S::ready:
            return "start first";
        case S::waiting:
            return "start interpolation, or stop";
        case S::held:
            return "resume, or stop";
        case S::alarm:
            return "reset the alarm first";
        default:
            return "wait, or stop";
    }
}

std::string alarm_remedy_text(std::uint64_t cause) {
    return std::string{cause == kSilentPortCause ? kSilentPortRemedy
                                                 : remedy_of(static_cast<AlarmCause>(cause))};
}

}  // namespace

bool is_sound(const Argument& argument) noexcept {
    using K = ArgumentKind;
    const std::uint64_t bits = argument.bits;
    switch (argument.kind) {
        case K::none:
            return false;
        case K::count:
        case K::pulses:
        case K::layer:
        case K::point:
        case K::ms:
        case K::text:
            return true;
        case K::mm:
        case K::mm_s:
        case K::deg_s:
            return is_number(argument.number());
        case K::axis:
            return bits < kAxisCount;
        case K::signal:
            return bits < kSignalCount;
        case K::signals:
            return bits >> kSignalCount == 0;
        case K::state:
        case K::way_out:
            return bits < kMachineStateCount;
        case K::states:
            return are_states(bits);
        case K::command:
            return bits < kCommandKindCount;
        case K::alarm_cause:
            return bits < kAlarmCauseCount;
        case K::alarm_remedy:
            return bits < kAlarmCauseCount || bits == kSilentPortCause;
    }
    return false;  // a number from shared memory may be anything
}

std::string words_of(const Argument& argument, const Message& message, int mm_digits) {
    using K = ArgumentKind;
    const std::uint64_t bits = argument.bits;
    switch (argument.kind) {
        case K::none:
            break;
        case K::count:
        case K::layer:
        case K::point:
        case K::ms:
            return std::to_string(bits);
        case K::pulses:
            return std::to_string(argument.signed_number());
        case K::mm:
            return mm_text(argument.number(), mm_digits);
        case K::mm_s:
            return speed_text(argument.number(), "mm/s");
        case K::deg_s:
            return speed_text(argument.number(), "deg/s");
        case K::axis:
            return std::string{name_of(static_cast<Axis>(bits))};
        case K::signal:
            return std::string{name_of(static_cast<Signal>(bits))};
        case K::signals:
            return signals_text(bits);
        case K::state:
            return std::string{name_of(static_cast<MachineState>(bits))};
        case K::states:
            return states_text(bits);
        case K::way_out:
            return way_out_text(static_cast<MachineState>(bits));
        case K::command:
            return std::string{name_of(static_cast<CommandKind>(bits))};
        case K::alarm_cause:
            return std::string{name_of(static_cast<AlarmCause>(bits))};
        case K::alarm_remedy:
            return alarm_remedy_text(bits);
        case K::text:
            return text_of(message);
    }
    return {};
}

}  // namespace psicarve
