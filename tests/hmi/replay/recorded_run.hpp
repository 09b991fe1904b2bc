// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/verify/trace_reader.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::replay::test {

/// A run of a real core on the virtual clock, recorded: homed, then a small job carved to its end.
class RecordedRun : public two_process::CoreRig {
protected:
    static constexpr std::uint32_t kLayers = 6;
    static constexpr std::uint32_t kPoints = 41;

    /// Leaves run.trace, and apart from it other.job and other.snap.
    void record();
    std::string trace() const { return file("run.trace"); }
    std::string job() const { return file("other.job"); }
    std::string snapshot() const { return file("other.snap"); }

    CoreStatus end_;  ///< of the run
};

/// All of a trace, read from its begin, and what follows from it by a plain count.
struct PlainTrace {
    explicit PlainTrace(const std::string& path);
    struct At {
        std::int64_t time_ns;
        SignalWord levels;
        std::array<std::int64_t, kAxisCount> position_pulses;
        std::array<std::uint64_t, kAxisCount> pulses;
    };
    /// After everything up to and with this time.
    const At& at(std::int64_t time_ns) const;

    std::vector<At> states;  ///< the first before all events
};

}  // namespace psicarve::replay::test
