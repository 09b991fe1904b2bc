// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/replay/entry.hpp"
#include "hmi/replay/job_place.hpp"
#include "hmi/replay/trace_index.hpp"
#include "hmi/session/level_history.hpp"
#include "hmi/session/preflight.hpp"
#include "hmi/verify/asked_carving.hpp"

namespace psicarve::replay {

using JobPointer = std::shared_ptr<const cam::PreparedJob>;

/// What a recording shows at one instant.
struct Shown {
    std::int64_t time_ns = 0;
    CoreStatus status{};                            ///< 0 where the recording does not hold it
    std::optional<JobPlace> place;                  ///< while a job is carved, if known
    std::int64_t carving_time = 0;                  ///< of the carving timeline
    std::deque<session::LevelHistory::Look> looks;  ///< if they were asked for
};

/// A trace or a snapshot.
class Recording {
public:
    enum class Kind : std::uint8_t { trace, snapshot };
    struct Facts {
        Kind kind = Kind::trace;
        std::string path;
        std::int64_t end_ns = 0;  ///< it begins at 0
        // For a snapshot: the core's tick then, and the length of each.
        std::uint64_t first_tick = 0;
        std::int64_t period_ns = 0;
        JobPointer job;   ///< may be missing
        Profile profile;  ///< the job's; else the one assumed for the machine
        /// What the flight recorder of a trace's run says that was to be carved.
        std::optional<verify::AskedCarving> asked;
        bool knows_states = false;
        bool knows_every_pulse = false;
        std::vector<Entry> entries;            ///< by time
        std::vector<float> activity;           ///< pulses over time, in equal parts of it; greatest: 1; may
                                               ///< be empty
        std::vector<session::Check> contents;  ///< what it contains and what it lacks
        std::vector<session::Phrase> warnings;
    };

    virtual ~Recording() = default;
    const Facts& facts() const noexcept { return facts_; }
    /// May read the file. One thread at a time; not the window's. 0 <= time_ns <= end_ns.
    virtual Result<Shown> at(std::int64_t time_ns, bool with_looks) = 0;
    /// The pulses, if it has any.
    virtual std::shared_ptr<const TraceIndex> index() const { return nullptr; }

protected:
    Facts facts_;
};

/// Whether the file is a binary trace or a snapshot with more than a job in it. False for one that cannot be
/// read.
bool is_recording(const std::string& path);

struct OpenOptions {
    std::string path;
    /// For a trace: its job or snapshot; refused where the trace carries another. Empty: the job that it
    /// carries; else FILE.job, .psi, .snap beside it, if any.
    std::string job_path;
    Profile profile;  ///< for a trace without a job
};
/// Reads the whole file. "FILE: what is wrong".
Result<std::unique_ptr<Recording>> open_recording(const OpenOptions& options, const Progress& progress);

}  // namespace psicarve::replay
