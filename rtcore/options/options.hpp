// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rtcore/port/port_address.hpp"
#include "shared/base/result.hpp"
#include "shared/segment/layout.hpp"
#include "shared/segment/segment.hpp"

namespace CLI {
class App;
}

namespace psicarve::supervisor {

enum class ClockKind : std::uint8_t { real, virtual_time };

/// The command line of psicarve-rtcore.
struct CoreOptions {
    std::string segment_name = kDefaultSegmentName;
    port::PortAddress port;
    ClockKind clock = ClockKind::real;
    std::string profile_path;  ///< TOML, or a job file for the profile in it; empty: built-in default
    /// The profile at the default place, used where none is named; empty: there is none. Looked up as the
    /// user who starts the core.
    std::string unnamed_profile_path;
    std::string machine_path;  ///< profile of the simulated machine; empty: the core's own
    std::string piece_path;    ///< at the end: what the tips left of the blank, CSV; simulated machine
    std::vector<std::string> trace_paths;  ///< file or "fd:N"; ".vcd": value-change dump, else binary
    std::string replay_path;               ///< job or snapshot file; empty: serve commands
    bool replays_program = false;          ///< of the snapshot, with the records of a writer
    std::uint32_t capacity_layers = kDefaultCapacityLayers;
    std::uint32_t capacity_points = kDefaultCapacityPoints;
    std::uint32_t capacity_records = kDefaultRingRecords;  ///< of the ring of a program
    std::string group;
    std::string user;  ///< the user that the core runs as from its start on; empty: the one who started it
    bool exit_with_parent = false;
    bool allow_no_realtime = false;  ///< a real port may be driven without real-time rights
    bool no_guard = false;           ///< no process makes a real port safe when the core dies
    bool assume_homed = false;       ///< a replay on a real port begins at the machine's present position
    std::optional<int> cpu;          ///< of the tick; nothing: an isolated one, if there is one
    bool takes_any_cpu = false;      ///< --cpu any
    bool measures_latency = false;   ///< measures only: neither segment nor port
    std::uint32_t measure_seconds = 10;
    std::uint32_t measure_period_us = 50;
    std::string lateness_path;     ///< at the end: how late ticks were, CSV; real clock
    int priority = 80;             ///< of the tick, SCHED_FIFO
    bool no_estimate = false;      ///< the core does not calculate how long a job takes
    std::string layer_times_path;  ///< written when a job is planned: when each of its layers is over, CSV
    std::string point_times_path;  ///< likewise: what the way to each point takes, a PointPlan's bytes
    std::string state_folder;      ///< for checkpoint, job and journal; empty: nothing is kept
};

/// The options, or the exit code of a run that ends here (help or version was asked for, or the usage was
/// wrong: the message has been printed).
std::variant<CoreOptions, int> parse_options(int argc, char** argv);

/// Shows the parser of parse_options, as --help describes it, to programs that make pages and completion of
/// it.
void show_command_line(const std::function<void(const CLI::App&)>& look);

/// "LxP", both 1 to 1 000 000.
Result<void> parse_capacity(const std::string& text, CoreOptions& options);

}  // namespace psicarve::supervisor
