// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/replay/replay_script.hpp"
#include "rtcore/supervisor/core_parts.hpp"
#include "rtcore/supervisor/supervisor.hpp"

namespace psicarve::supervisor {

/// Runs a published job whole: start, start interpolation, until the machine is ready again.
class JobDirector {
public:
    enum class Progress : std::uint8_t { going_on, done, alarm };
    /// Supervisor's thread, after each of its polls.
    Progress poll(Supervisor& supervisor);

private:
    enum class Stage : std::uint8_t { wait_for_job, starting, carving, ended };
    Stage stage_ = Stage::wait_for_job;
};

/// Applies a recorded script to the tick. The base thread's, before each tick: it writes to no ring that
/// another thread writes to. RT: yes.
class RecordDirector {
public:
    RecordDirector(const ReplayScript& script, std::uint64_t end_tick)
        : script_(script), end_tick_(end_tick) {}

    /// From here on, tick 0 of the script is the tick that comes next.
    void begin(std::uint64_t next_tick) noexcept;
    void before_tick(std::uint64_t next_tick, CoreParts& parts) noexcept;
    bool has_begun() const noexcept { return has_begun_; }
    bool is_over(std::uint64_t next_tick) const noexcept {
        return has_begun_ && next_tick > origin_tick_ + end_tick_;
    }

private:
    void apply(const ReplayStep& step, CoreParts& parts) noexcept;

    const ReplayScript script_;
    const std::uint64_t end_tick_;
    std::uint64_t origin_tick_ = 0;
    std::size_t next_step_ = 0;
    bool has_begun_ = false;
};

}  // namespace psicarve::supervisor
