// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ProgramRule that judges the spindle, coolant and outputs: each is switched at the rest that the
// program asks for, neither on the way before it nor on the one behind.
#include <bit>
#include <string>
#include <utility>

#include "hmi/verify/program/program_rule.hpp"

namespace psicarve::verify {

/// Those that are not as the way has them; at the rest at its end what is switched there may be either.
SignalWord ProgramRule::wrong_switches(const Live& way, SignalWord levels) const noexcept {
    const SwitchDemand& wanted = way.demand.switches;
    SignalWord wrong = (levels ^ wanted.on) & wanted.judged & present_;
    if (way.is_at_end) wrong &= ~wanted.turned_behind;
    return wrong;
}

/// As the path may be on several ways, only what is wrong on all of them is. Each is told once, until it is
/// right again.
void ProgramRule::judge_switches(std::int64_t time_ns, SignalWord levels) {
    SignalWord wrong = ~SignalWord{0};
    const Live* last = nullptr;
    for (const Live& way : window_) {
        if (!way.is_on) continue;
        wrong &= wrong_switches(way, levels);
        last = &way;
    }
    if (last == nullptr) return;
    const SignalWord told = std::exchange(told_switches_, wrong);
    for (SignalWord left = wrong & ~told; left != 0; left &= left - 1) {
        const auto wire = static_cast<Signal>(std::countr_zero(left));
        if (log_.count(1, time_ns))
            report(time_ns, wrong_switch(wire, (levels & bit_of(wire)) != 0, last), last->demand.line);
    }
}

/// Where all drives are off, and where the program is over, nothing is on; but then a spindle that was off
/// may have been switched by hand.
void ProgramRule::judge_last_switches(std::int64_t time_ns, SignalWord levels, bool is_done) {
    const SignalWord enables = present_ & kEnableMask;
    const bool is_off = enables != 0 && (levels & enables) == 0;
    if (!is_done && !is_off) return;
    SignalWord wrong = levels & (kSwitchedMask | bit_of(Signal::spindle)) & present_;
    if (!is_off && was_spindle_off_) wrong &= ~bit_of(Signal::spindle);
    for (SignalWord left = wrong; left != 0; left &= left - 1) {
        const auto wire = static_cast<Signal>(std::countr_zero(left));
        if (log_.count(1, time_ns))
            report(time_ns, wrong_switch(wire, true, nullptr), place_.line.value_or(0));
    }
}

Offence ProgramRule::wrong_switch(Signal wire, bool is_on, const Live* way) const {
    Offence offence;
    offence.fault = wire == Signal::spindle ? "spindle" : "output";
    offence.measured = is_on ? 1.0 : 0.0;
    offence.allowed = is_on ? 0.0 : 1.0;
    offence.bound = Bound::exactly;
    offence.unit = "on";
    offence.sentence = wire == Signal::spindle ? "the spindle" : std::string{name_of(wire)};
    offence.sentence += is_on ? " is on" : " is off";
    if (way == nullptr) {
        offence.sentence += " though the program is over";
        return offence;
    }
    offence.sentence += std::string{" on a way for which the program has it "} + (is_on ? "off" : "on");
    const std::uint64_t line = way->demand.switches.lines[index_of_switch(wire)];
    if (line != 0) offence.sentence += " by line " + std::to_string(line);
    return offence;
}

}  // namespace psicarve::verify
