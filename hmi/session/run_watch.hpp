// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/machine/job_run.hpp"
#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The run of a job, observed by a window: from its start to its end, and nothing after it.
class RunWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// Call it at every look at the machine.
    void note(const MachineView& machine, Clock::time_point now);
    /// The last run, also while it goes on; nothing when this core has started none.
    const std::optional<machine::JobRun>& run() const noexcept { return run_; }
    bool is_over() const noexcept { return is_over_; }
    /// The layer, from 0, in which the window first saw the run; nothing: it saw the start.
    std::optional<std::uint32_t> seen_from_layer() const noexcept { return seen_from_layer_; }

private:
    void begin(const CoreStatus& status, Clock::time_point now);

    std::optional<machine::JobRun> run_;
    std::optional<CoreStatus> last_;
    std::uint32_t core_pid_ = 0;
    bool is_over_ = false;
    std::optional<std::uint32_t> seen_from_layer_;
    Clock::time_point began_{};
};

/// One line of a run's report.
struct ReportRow {
    Phrase name;
    Phrase value;
};
/// `is_verified`: nothing when the pins of the run were not recorded. `seen_from_layer`: see RunWatch; what
/// happened before is not known.
std::vector<ReportRow> run_rows(const machine::JobRun& run, bool is_over, std::uint32_t layer_count,
                                std::optional<bool> is_verified = {},
                                std::optional<std::uint32_t> seen_from_layer = {});

}  // namespace psicarve::session
