// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hmi/machine/unique_fd.hpp"
#include "shared/base/result.hpp"
#include "shared/segment/layout.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::machine {

/// How to start a core of our own, on the simulated machine. It keeps no state on a disk: there is no real
/// piece on its table.
struct CoreLaunch {
    std::string segment_name = kDefaultSegmentName;
    bool on_real_clock = false;
    std::string profile_path;              ///< TOML or a job file; empty: the built-in profile
    std::vector<std::string> trace_paths;  ///< files, or fd:N of an inherited descriptor
    std::string replay_path;       ///< job or snapshot to run from the home positions; empty: serve commands
    bool replays_program = false;  ///< its program, with the records that a writer gives
    std::uint32_t capacity_layers = kDefaultCapacityLayers;
    std::uint32_t capacity_points = kDefaultCapacityPoints;
    std::string group;
    std::string layer_times_path;    ///< file for the layers' planned times; empty: not written
    std::string point_times_path;    ///< likewise for the points'
    bool no_estimate = false;        ///< the time left is not calculated: all processor time is for the
                                     ///< carving
    std::vector<int> inherited_fds;  ///< keep their numbers in the child
    /// The core carves on and serves its segment when this process is killed; else it ends with it.
    bool outlives_us = false;
    bool is_private = false;  ///< the segment is removed when the core has ended
};

/// The path of a program of ours: beside the running program, else in PATH. Nothing when there is none.
std::optional<std::string> find_program(const std::string& name);
/// The path of psicarve-rtcore: beside the running program, else in PATH. Nothing when there is none.
std::optional<std::string> find_core_program();

/// A core that is our child. It has a process group of its own: Ctrl-C in the terminal reaches this process
/// alone, which ends the core in order. Unless it is to outlive us it also ends by itself when this process
/// dies, whatever kills it.
///
/// A child that ends with us watches the *thread* that started it: call start() on a thread that lives as
/// long as the core.
class CoreProcess {
public:
    /// Starts it and waits until it serves its segment. A failure has the text of the core's standard error.
    static Result<CoreProcess> start(const CoreLaunch& launch);

    CoreProcess(CoreProcess&& other) noexcept;
    CoreProcess& operator=(CoreProcess&&) = delete;
    ~CoreProcess() { end(); }

    pid_t pid() const noexcept { return pid_; }
    bool is_running() { return !exit_code_ && !poll_exit(); }
    /// Nothing when it still runs after `limit`. 128 + the signal's number when a signal ended it.
    std::optional<int> wait_exit(std::chrono::milliseconds limit);
    /// Asks it by a signal to end in order; does not wait.
    void terminate() noexcept;
    /// Ends it: by command, else SIGTERM, else SIGKILL, each with a time limit. Removes a private segment.
    void end() noexcept;
    /// Asks it by command to end and waits as long as `goes_on` returns true; false when it still runs.
    bool end_while(const std::function<bool()>& goes_on);
    /// The last few kilobytes of its standard error, without the final line end.
    std::string messages() const;

private:
    CoreProcess(pid_t pid, UniqueFd output, const CoreLaunch& launch);
    bool poll_exit();
    bool agrees_to_end();
    Result<void> wait_until_it_serves();
    Error failure() const;

    pid_t pid_ = -1;
    std::optional<int> exit_code_;
    UniqueFd output_;
    std::string segment_name_;
    bool is_private_ = false;
    bool is_replay_ = false;
};

}  // namespace psicarve::machine
