// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/replay/job_fit.hpp"
#include "hmi/replay/pin_looks.hpp"
#include "hmi/replay/record_states.hpp"
#include "hmi/replay/recording.hpp"

namespace psicarve::replay {

/// A trace as a recording: every pin at every time. The machine's states are derived from the pins, unless a
/// snapshot of the same run lies beside the trace.
class TraceRecording final : public Recording {
public:
    /// The file that belongs to the trace.
    struct Company {
        std::string path;  ///< empty: nothing was found
        JobPointer job;
        std::vector<FlightRecord> records;
        std::string records_path;   ///< empty: `path`
        bool is_asked_for = false;  ///< used whatever the pins say, with a warning
    };
    /// Null: the company is of another run, and the user has not asked for it by name.
    static Result<std::unique_ptr<TraceRecording>> open(const std::string& path, const Company& company,
                                                        const Profile& profile, const Progress& progress);
    /// Notes a company that lay beside the trace and was not used.
    void tell_refused(const std::string& company_path);
    /// Adds a warning, unless it is there already.
    void warn(session::Phrase warning);

    Result<Shown> at(std::int64_t time_ns, bool with_looks) override;
    std::shared_ptr<const TraceIndex> index() const override { return index_; }

private:
    explicit TraceRecording(std::shared_ptr<const TraceIndex> index)
        : index_(std::move(index)), cursor_(index_), looks_(index_) {}
    bool records_fit(const std::vector<FlightRecord>& records, const RecordStates& states);
    Result<bool> takes_job(const Company& company);
    void measure_activity();
    void take_records(const Company& company);
    bool show_records(const std::vector<FlightRecord>& records, const std::vector<FlightRecord>& states);
    bool show_replayed(const std::vector<FlightRecord>& records);
    session::Check job_row(const Company& company) const;
    void list_contents(const Company& company);
    void guess_state(CoreStatus& status) const noexcept;

    std::shared_ptr<const TraceIndex> index_;
    TraceCursor cursor_;
    PinLooks looks_;
    std::optional<verify::JobGeometry> geometry_;
    JobFit fit_;
    RecordStates states_;
    std::size_t record_count_ = 0;
};

}  // namespace psicarve::replay
