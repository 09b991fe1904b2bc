// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/sim/machine.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::sim {

/// A simulated machine and someone who pulls its pins by hand, in logical levels and nanoseconds.
class SimRig {
public:
    explicit SimRig(const Profile& profile = Profile{}) : SimRig(profile, sim_config_from_profile(profile)) {}
    SimRig(const Profile& profile, const SimConfig& config)
        : pin_map_(PinMap::from_profile(profile).value()), machine_(config) {
        write();
    }

    Machine& machine() { return machine_; }
    std::int64_t now_ns() const { return now_ns_; }
    void wait_ns(std::int64_t time_ns) { now_ns_ += time_ns; }
    void wait_until_ns(std::int64_t time_ns) { now_ns_ = time_ns; }
    void set(Signal signal, bool level) {
        levels_ = level ? levels_ | bit_of(signal) : levels_ & ~bit_of(signal);
        write();
    }
    void enable_all() {
        levels_ |= kEnableMask;
        write();
    }
    void aim(Axis axis, bool positive) {
        set(dir_of(axis), positive);
        wait_ns(kQuiet_ns);
    }
    /// One pulse that suits every driver, slow enough for every motor; takes `period_ns`.
    void pulse(Axis axis, std::int64_t period_ns = kSlow_ns) {
        set(step_of(axis), true);
        wait_ns(kQuiet_ns);
        set(step_of(axis), false);
        wait_ns(period_ns - kQuiet_ns);
    }
    void pulses(Axis axis, int count, std::int64_t period_ns = kSlow_ns) {
        for (int i = 0; i < count; ++i) pulse(axis, period_ns);
    }
    SignalWord inputs() { return pin_map_.decode_status(machine_.read_status(now_ns_)); }
    bool shows(Signal signal) { return (inputs() & bit_of(signal)) != 0; }
    std::int64_t position(Axis axis) const { return machine_.position_pulses(axis); }
    AxisReport report(Axis axis) const { return machine_.report().axis(axis); }

    static constexpr std::int64_t kQuiet_ns = 20'000;    ///< longer than any time a driver asks for
    static constexpr std::int64_t kSlow_ns = 4'000'000;  ///< slower than start-stop

private:
    void write() {
        const OutputRegisters registers = pin_map_.encode(levels_);
        machine_.write_registers(registers.data, registers.control, now_ns_);
    }
    PinMap pin_map_;
    Machine machine_;
    SignalWord levels_ = 0;
    std::int64_t now_ns_ = 0;
};

}  // namespace psicarve::sim
