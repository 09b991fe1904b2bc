// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/snapshot_recording.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/replay/pin_looks.hpp"
#include "shared/base/shared_text.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::replay {
namespace {

using session::Check;
using session::phrase;
using V = Check::Verdict;

JobPlace place_in(const CoreStatus& status) noexcept {
    return {status.layer, status.point};
}

}  // namespace

Result<std::unique_ptr<Recording>> SnapshotRecording::open(const std::string& path) {
    auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    std::unique_ptr<SnapshotRecording> made{new SnapshotRecording};
    Facts& facts = made->facts_;
    facts.kind = Kind::snapshot;
    facts.path = path;
    made->snapshot_ = std::move(snapshot).value();
    Snapshot& own = made->snapshot_;
    if (!own.job_blob.empty()) {
        Snapshot with_job;
        with_job.job_blob = std::move(own.job_blob);
        auto job = cam::prepare_snapshot(std::move(with_job), path);
        if (!job) facts.warnings.push_back(session::error_phrase(job.error()));
        if (job) facts.job = std::make_shared<const cam::PreparedJob>(std::move(*job));
    }
    if (facts.job) {
        facts.profile = facts.job->profile;
        const auto geometry = verify::JobGeometry::make(facts.job->view, facts.job->profile);
        if (geometry) made->geometry_ = *geometry;
    }
    const bool has_period = own.status && own.status->period_ns > 0;
    made->period_ns_ = has_period ? own.status->period_ns : tick_period_ns(facts.profile);
    std::uint64_t last_tick = own.status ? own.status->tick : 0;
    made->first_tick_ = own.records.empty() ? last_tick : own.records.front().tick;
    for (const FlightRecord& record : own.records) last_tick = std::max(last_tick, record.tick);
    made->first_tick_ = std::min(made->first_tick_, last_tick);
    facts.first_tick = made->first_tick_;
    facts.period_ns = made->period_ns_;
    facts.end_ns = time_of_ticks(last_tick - made->first_tick_, made->period_ns_);
    for (const FlightRecord& record : own.records) {
        const std::uint64_t tick = std::max(record.tick, made->first_tick_);
        facts.entries.push_back(entry_of(record, time_of_ticks(tick - made->first_tick_, made->period_ns_)));
    }
    made->states_ = RecordStates{own.records};
    facts.knows_states = true;
    made->list_contents();
    return std::unique_ptr<Recording>{std::move(made)};
}

void SnapshotRecording::list_contents() {
    auto& rows = facts_.contents;
    const std::string entries = std::to_string(snapshot_.records.size());
    rows.push_back({phrase("Flight recorder"), phrase("%1 entries", entries),
                    snapshot_.records.empty() ? V::info : V::pass});
    rows.push_back({phrase("State at the end"), snapshot_.status ? phrase("recorded") : phrase("missing"),
                    snapshot_.status ? V::pass : V::info});
    rows.push_back(
        {phrase("Job"), facts_.job ? phrase("in it") : phrase("none"), facts_.job ? V::pass : V::info});
    rows.push_back({phrase("Between entries"), phrase("as at the last"), V::info});
    rows.push_back({phrase("Every pulse"), phrase("only in a trace"), V::info});
    list_program();
    rows.push_back({phrase("Carved piece"), facts_.job ? phrase("as planned") : phrase("unknown"), V::info});
}

/// Its text is not in a snapshot, and its pulses are to be had by that alone.
void SnapshotRecording::list_program() {
    const ProgramStatus last =
        recorded_program(snapshot_.records, snapshot_.status ? &*snapshot_.status : nullptr);
    if (last.program == 0 && last.line == 0) return;
    auto& rows = facts_.contents;
    session::Phrase text = phrase("of an unknown text");
    if (snapshot_.source != nullptr) {
        const ProgramSource& source = snapshot_.source->source;
        text = (source.flags & kSourceIsStream) != 0
                   ? phrase("from standard input")
                   : phrase("%1, %2 bytes", std::string{text_from_field(source.name)},
                            std::to_string(source.text_bytes));
    }
    rows.push_back({phrase("Program"), std::move(text), V::info});
    rows.push_back({phrase("Its line at the end"),
                    last.line == 0 ? phrase("not reached") : phrase("%1", std::to_string(last.line)),
                    V::info});
    rows.push_back({phrase("To run it again"), phrase("replay --program FILE"), V::info});
}

void SnapshotRecording::fill_from_entry(std::int64_t time_ns, Shown& shown) const {
    CoreStatus& status = shown.status;
    status.period_ns = period_ns_;
    status.tick = first_tick_ + static_cast<std::uint64_t>(time_ns / period_ns_);
    status.alarm_axis = kNoAxis;
    status.seconds_left = -1.0;
    const int last = entry_at(facts_.entries, time_ns);
    if (last >= 0) {
        const FlightRecord& record = snapshot_.records[static_cast<std::size_t>(last)];
        status.signals = record.signals;
        std::copy(std::begin(record.position_pulses), std::end(record.position_pulses),
                  status.position_pulses);
    }
    states_.fill(status, status.tick);
}

/// The levels at the entries of the last seconds; steps are not known.
void SnapshotRecording::look_back(Shown& shown) const {
    constexpr std::int64_t kBack_ns = std::chrono::nanoseconds{session::LevelHistory::kLength}.count();
    const std::int64_t from_ns = shown.time_ns - kBack_ns;
    const int last = entry_at(facts_.entries, shown.time_ns);
    for (int i = std::max(entry_at(facts_.entries, from_ns), 0); i <= last; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const std::int64_t time_ns = std::max(facts_.entries[n].time_ns, from_ns);
        shown.looks.push_back({PinLooks::time_point(time_ns), snapshot_.records[n].signals & ~kStepMask, {}});
    }
    shown.looks.push_back({PinLooks::time_point(shown.time_ns), shown.status.signals & ~kStepMask, {}});
}

Result<Shown> SnapshotRecording::at(std::int64_t time_ns, bool with_looks) {
    Shown shown;
    shown.time_ns = time_ns;
    const bool is_end = time_ns >= facts_.end_ns && snapshot_.status;
    if (is_end) {
        shown.status = *snapshot_.status;
        if (shown.status.points_done > 0) shown.place = place_in(shown.status);
        const bool is_complete = shown.status.points_done == shown.status.points_total;
        if (shown.place) shown.carving_time = shown.place->layer + (is_complete ? 1 : 0);
    } else {
        fill_from_entry(time_ns, shown);
        verify::Positions positions{};
        std::copy_n(std::begin(shown.status.position_pulses), kAxisCount, positions.begin());
        const bool is_job = is_at_job(shown.status.state) && !states_.runs_program(shown.status.tick);
        if (geometry_ && is_job) shown.place = job_place(*geometry_, positions);
        if (shown.place) shown.carving_time = shown.place->layer;
    }
    // A dry run carves nothing, however far it has come.
    if (shown.status.is_dry != 0) shown.carving_time = 0;
    if (with_looks) look_back(shown);
    return shown;
}

}  // namespace psicarve::replay
