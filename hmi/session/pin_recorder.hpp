// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/machine/job_run.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/pending_saves.hpp"
#include "hmi/verify/verify_report.hpp"

namespace psicarve::session {

/// Lets a running core record its pins into a file, and judges them when a whole job was carved meanwhile. A
/// thread of its own waits for the core's answers, the file and the judgement. All calls come from one
/// thread, the owner's.
class PinRecorder {
public:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;
    enum class State : std::uint8_t { idle, starting, recording, ending };

    PinRecorder(std::string segment_name, std::string group, MessageLog& log, PendingSaves saves = {});
    /// Keeps the recording; waits for it.
    ~PinRecorder();

    /// The core must be at rest and have this job.
    void begin(const std::string& path, const JobPointer& job);
    void end();
    /// Call it at screen rate.
    void poll(const MachineView& machine);

    State state() const noexcept { return state_; }
    const std::string& path() const noexcept { return path_; }
    /// The verification of this run's pins; nothing when it was not recorded completely.
    std::optional<verify::VerifyReport> verdict_on(const machine::JobRun& run) const;

private:
    struct Taken;

    /// Whether the run that began at this tick carves the job from its first layer on, not dry; nothing while
    /// the core has not reported it yet.
    std::optional<bool> began_whole(std::uint64_t start_tick);
    void tell(const Result<verify::VerifyReport>& report, std::optional<Error> no_file);

    std::string segment_name_;
    std::string group_;
    MessageLog& log_;
    PendingSaves saves_;
    State state_ = State::idle;
    bool ends_once_begun_ = false;
    std::string path_;
    std::shared_ptr<Taken> taken_;
    std::optional<CoreStatus> last_;
    std::uint64_t run_start_tick_ = 0;  ///< of the job that was started last; 0: none
    std::size_t runs_ = 0;              ///< runs that began while recording
    bool is_one_whole_run_ = false;
    std::uint64_t judged_start_tick_ = 0;
    std::optional<verify::VerifyReport> verdict_;
    BackgroundQueue queue_;  // last: its thread uses the others
};

/// Why recording cannot begin.
std::optional<Phrase> record_lock(const MachineView& machine, bool has_core_job, PinRecorder::State state);

}  // namespace psicarve::session
