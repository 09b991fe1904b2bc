// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <utility>

#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile_table.hpp"

namespace psicarve {

SwitchedOutputs wired_outputs(const Profile& profile) noexcept {
    unsigned wired = 0;
    for (std::size_t i = 0; i < kSwitchedOutputCount; ++i)
        wired |= static_cast<unsigned>(profile.port.pins[kFirstSwitchedOutput + i] != 0) << i;
    return static_cast<SwitchedOutputs>(wired);
}

std::string names_of_powered(const Profile& profile) {
    std::string names = "drives";
    std::string last = "spindle";
    for (std::size_t i = kFirstSwitchedOutput; i < kFirstSwitchedOutput + kSwitchedOutputCount; ++i) {
        if (profile.port.pins[i] != 0)
            names += ", " + std::exchange(last, std::string{name_of(static_cast<Signal>(i))});
    }
    return names + " and " + last;
}

}  // namespace psicarve

namespace psicarve::profile_detail {
namespace {

constexpr const char* kOutputPins = "1 to 9, 14, 16 or 17";
constexpr const char* kInputPins = "10 to 13 or 15";

std::string key_of(Signal signal) {
    return "port.pins." + std::string(name_of(signal));
}

bool is_enable(Signal signal) noexcept {
    return (bit_of(signal) & kEnableMask) != 0;
}

int pin_of(const Profile& profile, Signal signal) {
    return signal == Signal::charge_pump ? profile.port.charge_pump_pin : profile.port.pins[index_of(signal)];
}

std::optional<Problem> check_pin(const Profile& profile, Signal signal) {
    const int wired = pin_of(profile, signal);
    if (wired == 0) return std::nullopt;
    const int pin = std::abs(wired);
    const auto place = place_of_pin(pin);
    const char* usable = is_output(signal) ? kOutputPins : kInputPins;
    if (!place) {
        return Problem{key_of(signal),
                       {},
                       "the port has no signal pin " + std::to_string(pin) + "; use pin " + usable +
                           ", or 0 for not wired"};
    }
    if (is_input_pin(pin) == is_output(signal)) {
        return Problem{key_of(signal),
                       {},
                       std::string(is_output(signal) ? "an output" : "an input") + " cannot be on pin " +
                           std::to_string(pin) + ", which is an " + (is_output(signal) ? "input" : "output") +
                           "; use pin " + usable};
    }
    return std::nullopt;
}

std::optional<Problem> check_sharing(const Profile& profile, Signal first, Signal second) {
    const int a = pin_of(profile, first);
    const int b = pin_of(profile, second);
    if (a == 0 || std::abs(a) != std::abs(b)) return std::nullopt;
    const std::string pin = "pin " + std::to_string(std::abs(a));
    const std::string both = key_of(first) + " and " + key_of(second);
    const bool is_estop = first == Signal::estop || second == Signal::estop;
    if (is_estop) {
        return Problem{
            key_of(second),
            {key_of(first)},
            both + " share " + pin +
                ": what homing looks for would be an emergency stop; give one of them another pin, or 0",
            true};
    }
    const bool may_share = !is_output(first) || (is_enable(first) && is_enable(second));
    if (!may_share) {
        return Problem{
            key_of(second),
            {key_of(first)},
            both + " are both on output " + pin + "; give one of them another pin (only enables may share)",
            true};
    }
    if (a != b) {
        return Problem{
            key_of(second),
            {key_of(first)},
            both + " share " + pin + ", one active high and one active low; give both the same sign",
            true};
    }
    return std::nullopt;
}

std::optional<Problem> check_motor_pins(const Profile& profile, Axis axis) {
    for (const Signal signal : {step_of(axis), dir_of(axis)}) {
        if (profile.port.pins[index_of(signal)] == 0) {
            return Problem{
                key_of(signal),
                {},
                "is not wired, so axis " + std::string(name_of(axis)) + " cannot move; give its pin"};
        }
    }
    return std::nullopt;
}

std::optional<Problem> check_sensor_pin(const Profile& profile, Axis axis) {
    const HomeSensor home = axis_motion(profile, axis).home;
    const Signal sensor = sensor_of(axis);
    if (home == HomeSensor::none || profile.port.pins[index_of(sensor)] != 0) return std::nullopt;
    const std::string home_key = "axis." + std::string(name_of(axis)) + ".home";
    const std::string home_word = value_as_toml(*find_key(home_key), profile);
    return Problem{key_of(sensor),
                   {home_key},
                   "is not wired, but " + home_key + " = " + home_word + " needs it; give its pin, or set " +
                       home_key + " = \"none\""};
}

}  // namespace

std::optional<Problem> check_pins(const Profile& profile) {
    constexpr std::size_t kAll = index_of(Signal::charge_pump) + 1;
    static_assert(kAll == kSignalCount + 1);
    for (std::size_t i = 0; i < kAll; ++i) {
        if (auto problem = check_pin(profile, static_cast<Signal>(i))) return problem;
    }
    for (std::size_t i = 0; i < kAll; ++i) {
        for (std::size_t j = i + 1; j < kAll; ++j) {
            const auto first = static_cast<Signal>(i);
            if (auto problem = check_sharing(profile, first, static_cast<Signal>(j))) return problem;
        }
    }
    for (const Axis axis : kAllAxes) {
        if (auto problem = check_motor_pins(profile, axis)) return problem;
        if (auto problem = check_sensor_pin(profile, axis)) return problem;
    }
    return std::nullopt;
}

}  // namespace psicarve::profile_detail
