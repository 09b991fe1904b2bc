// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/refusal_text.hpp"

namespace psicarve::supervisor {
namespace {

std::string remedy_in(MachineState state) {
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

std::string tripped_inputs(SignalWord signals) {
    std::string names;
    for (std::size_t i = kOutputSignalCount; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        if (signal == Signal::psi_index || (signals & bit_of(signal)) == 0) continue;
        names += (names.empty() ? "" : ", ");
        names += name_of(signal);
    }
    return names;
}

}  // namespace

std::string refusal_text(cycle::Refusal refusal, CommandKind command, const cycle::Sample& sample) {
    using R = cycle::Refusal;
    const std::string state{name_of(sample.state)};
    switch (refusal) {
        case R::none:
            return {};
        case R::not_in_this_state:
            if (command == CommandKind::reset_alarm || command == CommandKind::back_off) {
                return std::string{name_of(command)} + ": there is no alarm";
            }
            return std::string{name_of(command)} + ": not while " + state + "; " + remedy_in(sample.state);
        case R::no_job:
            return "no job is published; publish one first";
        case R::not_homed:
            return "the machine is not homed; home first";
        case R::still_tripped:
            return "still tripped: " + tripped_inputs(sample.signals) + "; release it or back off";
        case R::sensor_not_tripped:
            return "the axis' sensor is not tripped; nothing to back off from";
        case R::no_sensor:
            return "the axis has no sensor";
    }
    return "refused";
}

}  // namespace psicarve::supervisor
