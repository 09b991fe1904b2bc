// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rtcore/cycle/cycle.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/layer_times.hpp"
#include "rtcore/options/options.hpp"
#include "rtcore/plan/job_estimator.hpp"
#include "rtcore/plan/planner.hpp"
#include "rtcore/port/port.hpp"
#include "rtcore/process/side_thread.hpp"
#include "rtcore/replay/recorded_inputs_port.hpp"
#include "rtcore/sim/machine.hpp"
#include "rtcore/supervisor/guarded_port.hpp"
#include "rtcore/trace/trace_outlet.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/recorded_gaps.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// Where a replay begins: every axis homed and standing here.
using HomedStart = std::optional<std::array<std::int64_t, kAxisCount>>;

/// The machine and everything between it and the segment, built in the order in which they depend on each
/// other. One owner; members are used by the threads that their own headers name.
struct CoreParts {
    rtcore::SideThread words;  ///< what is said while the machine works; first, for others use it to the end
    rtcore::SideThread files;  ///< what others asked to be written meanwhile
    Profile profile;
    std::int64_t period_ns = 0;
    std::string port_name;                  ///< as --port says it
    std::unique_ptr<sim::Machine> machine;  ///< behind the simulated port; null: a real one
    std::unique_ptr<port::Port> port;
    std::unique_ptr<guard::GuardLink> guard;        ///< of a real port; null: there is none
    RecordedInputsPort* recorded_inputs = nullptr;  ///< the port, when a replay plays inputs from a recorder
    std::unique_ptr<trace::TraceRing> trace_ring;
    std::unique_ptr<cycle::CycleIo> io;
    std::unique_ptr<cycle::Cycle> cycle;
    std::unique_ptr<plan::Planner> planner;
    std::unique_ptr<plan::JobEstimator> estimator;  ///< null in a replay: no use for how long it will take
    TraceOutlet traces;                             ///< on the real clock one that loses what does not fit
    PlannedFiles planned_files;                     ///< of a job that is planned
    std::string state_folder;                       ///< for what outlasts the computer's end; empty: none
};

struct PartsRequest {
    Profile machine;  ///< of the simulated machine
    HomedStart homed_start;
    SignalWord start_levels = 0;  ///< with homed_start: as directions were left
    GapsLeft start_gaps{};        ///< likewise: of the screws' gaps
    bool plays_recorded_inputs = false;
    std::optional<GuardedPort> real_port;  ///< nothing: the simulated one
};

/// Opens the traces, and puts the parts together.
Result<std::unique_ptr<CoreParts>> build_core(const CoreOptions& options, const Profile& profile,
                                              PartsRequest request);

/// Where every axis stands when it is homed and at its home position.
std::array<std::int64_t, kAxisCount> home_positions(const Profile& profile);

}  // namespace psicarve::supervisor
