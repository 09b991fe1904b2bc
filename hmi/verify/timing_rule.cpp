// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/timing_rule.hpp"

namespace psicarve::verify {

void TimingRule::check(Axis axis, std::int64_t time_ns, std::int64_t since_ns, std::int64_t least_ns,
                       const Fault& fault, const CarvePlace& place) {
    const std::int64_t measured_ns = time_ns - since_ns;
    if (measured_ns >= least_ns || !log_.count(2, time_ns)) return;
    Offence offence;
    offence.rule = 2;
    offence.fault = fault.name;
    offence.axis = axis;
    offence.time_ns = time_ns;
    offence.measured = static_cast<double>(measured_ns);
    offence.allowed = static_cast<double>(least_ns);
    offence.bound = Bound::at_least;
    offence.unit = "ns";
    offence.sentence = shown_name(axis) + fault.text;
    log_.describe(std::move(offence), place);
}

void TimingRule::rising(Axis axis, std::int64_t time_ns, const CarvePlace& place) {
    Wires& wires = wires_[index_of(axis)];
    check(axis, time_ns, wires.fell_ns, port_.step_low_ns, {"step-low", " steps again after too short a gap"},
          place);
    check(axis, time_ns, wires.turned_ns, port_.dir_setup_ns,
          {"direction-setup", " steps too soon after its direction changed"}, place);
    wires.rose_ns = time_ns;
}

void TimingRule::falling(Axis axis, std::int64_t time_ns, const CarvePlace& place) {
    Wires& wires = wires_[index_of(axis)];
    check(axis, time_ns, wires.rose_ns, port_.step_high_ns, {"step-high", "'s step pulse is too short"},
          place);
    wires.fell_ns = time_ns;
}

void TimingRule::direction_changed(Axis axis, std::int64_t time_ns, const CarvePlace& place) {
    Wires& wires = wires_[index_of(axis)];
    check(axis, time_ns, wires.rose_ns, port_.dir_hold_ns,
          {"direction-hold", " changes its direction too soon after a step"}, place);
    wires.turned_ns = time_ns;
}

}  // namespace psicarve::verify
