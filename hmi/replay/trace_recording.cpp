// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/trace_recording.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/replay/replayed_records.hpp"
#include "hmi/session/display_text.hpp"

namespace psicarve::replay {
namespace {

using session::Check;
using session::Phrase;
using session::phrase;
using V = Check::Verdict;

constexpr std::size_t kProbes = 64;
constexpr std::size_t kActivityParts = 256;

std::string name_of_file(const std::string& path) {
    return std::filesystem::path{path}.filename().string();
}

}  // namespace

Result<std::unique_ptr<TraceRecording>> TraceRecording::open(const std::string& path, const Company& company,
                                                             const Profile& profile,
                                                             const Progress& progress) {
    const Profile& taken = company.job ? company.job->profile : profile;
    auto index = TraceIndex::build(path, taken, progress);
    if (!index) return index.error();
    std::unique_ptr<TraceRecording> made{new TraceRecording{std::move(index).value()}};
    Facts& facts = made->facts_;
    facts.kind = Kind::trace;
    facts.path = path;
    facts.end_ns = made->index_->end_ns();
    facts.job = company.job;
    facts.profile = taken;
    facts.knows_every_pulse = true;
    facts.entries = entries_of(made->index_->changes());
    const auto takes = made->takes_job(company);
    if (!takes) return takes.error();
    if (!*takes) return std::unique_ptr<TraceRecording>{};
    if (!made->index_->damage().empty())
        facts.warnings.push_back(session::error_phrase(made->index_->damage()));
    if (made->index_->jobs_begun() > 1 && company.path == path)
        facts.warnings.push_back(
            phrase("%1 carries several jobs; it is shown with the first", name_of_file(path)));
    made->measure_activity();
    made->take_records(company);
    made->list_contents(company);
    return made;
}

/// A name beside the trace's is no proof; the heads' motion is.
Result<bool> TraceRecording::takes_job(const Company& company) {
    if (!company.job) return true;
    const auto geometry = verify::JobGeometry::make(company.job->view, company.job->profile);
    if (!geometry) return company.is_asked_for;
    geometry_ = *geometry;
    const auto fit = job_fit(index_, *geometry_);
    if (!fit) return fit.error();
    fit_ = *fit;
    if (!fit_.is_known() || fit_.is_its_job()) return true;
    if (company.is_asked_for)
        facts_.warnings.push_back(phrase(
            "%1 is not this trace's job: the heads were elsewhere at %2 of %3 places that were looked at",
            name_of_file(company.path), std::to_string(fit_.places - fit_.fitting),
            std::to_string(fit_.places)));
    return company.is_asked_for;
}

void TraceRecording::tell_refused(const std::string& company_path) {
    const std::string name = name_of_file(company_path);
    facts_.warnings.push_back(
        phrase("%1 lies beside this trace, but is of another run: it is not used", name));
    for (Check& row : facts_.contents) {
        if (!facts_.job && row.name == phrase("Job")) row = {row.name, phrase("none: not %1", name), V::fail};
    }
}

void TraceRecording::warn(Phrase warning) {
    auto& said = facts_.warnings;
    if (std::find(said.begin(), said.end(), warning) == said.end()) said.push_back(std::move(warning));
}

/// Whether the entries belong to this run: the axes must have stood where the entries say. Before homing the
/// core counts from anywhere.
bool TraceRecording::records_fit(const std::vector<FlightRecord>& records, const RecordStates& states) {
    const std::int64_t period_ns = index_->start().period_ns;
    const std::size_t stride = std::max<std::size_t>(records.size() / kProbes, 1);
    // The last entry, too: an earlier run may have come as far at the same ticks.
    for (std::size_t i = 0; i < records.size() + stride - 1; i += stride) {
        const FlightRecord& record = records[std::min(i, records.size() - 1)];
        if (record.tick > static_cast<std::uint64_t>(facts_.end_ns / period_ns)) return false;
        CoreStatus before{};
        if (record.tick > 0) states.fill(before, record.tick - 1);
        if (before.homed_mask == 0) continue;
        const auto moment = cursor_.at(static_cast<std::int64_t>(record.tick + 1) * period_ns - 1);
        if (!moment) return false;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            // The entry was made somewhere in the tick.
            if (std::abs(moment->position_pulses[k] - record.position_pulses[k]) > 1) return false;
        }
    }
    return true;
}

void TraceRecording::measure_activity() {
    const auto& frames = index_->keyframes();
    if (frames.size() < 2 || facts_.end_ns <= 0) return;
    const auto pulses_of = [](const TraceIndex::Keyframe& frame) {
        const auto& pulses = frame.follower.moment().pulses;
        return static_cast<double>(pulses[0] + pulses[1] + pulses[2] + pulses[3]);
    };
    std::vector<double> rates(kActivityParts, 0.0);
    double most = 0.0;
    std::size_t frame = 1;
    for (std::size_t part = 0; part < kActivityParts; ++part) {
        const std::int64_t time_ns =
            facts_.end_ns / static_cast<std::int64_t>(kActivityParts) * static_cast<std::int64_t>(part);
        while (frame + 1 < frames.size() && frames[frame].place.time_ns <= time_ns) ++frame;
        const auto passed =
            static_cast<double>(frames[frame].place.time_ns - frames[frame - 1].place.time_ns);
        if (passed > 0.0) rates[part] = (pulses_of(frames[frame]) - pulses_of(frames[frame - 1])) / passed;
        most = std::max(most, rates[part]);
    }
    if (most <= 0.0) return;
    for (const double rate : rates) facts_.activity.push_back(static_cast<float>(rate / most));
}

/// False: they are of another run. `from`: the states, too, that held before them.
bool TraceRecording::show_records(const std::vector<FlightRecord>& records,
                                  const std::vector<FlightRecord>& from) {
    RecordStates states{from};
    if (!records_fit(records, states)) return false;
    states_ = std::move(states);
    facts_.knows_states = !states_.is_empty();
    record_count_ = records.size();
    facts_.entries.clear();
    for (const FlightRecord& record : records)
        facts_.entries.push_back(entry_of(record, time_of_ticks(record.tick, index_->start().period_ns)));
    return true;
}

/// The core of `replay` counts its own ticks, and begins where the machine was at rest.
bool TraceRecording::show_replayed(const std::vector<FlightRecord>& records) {
    const auto ways = replayed_records(records, *index_);
    return std::ranges::any_of(
        ways, [this](const ReplayedRecords& way) { return show_records(way.shown, way.states); });
}

void TraceRecording::take_records(const Company& company) {
    if (company.records.empty()) return;
    if (!show_records(company.records, company.records) && !show_replayed(company.records)) {
        facts_.warnings.push_back(
            phrase("%1: its flight recorder tells of another run; its entries are not shown",
                   name_of_file(company.records_path.empty() ? company.path : company.records_path)));
        return;
    }
    if (company.job) facts_.asked = verify::asked_carving(company.job->view, company.records);
}

Check TraceRecording::job_row(const Company& company) const {
    const Phrase name = phrase("Job");
    if (!company.job) return {name, phrase("none: add it"), V::info};
    const std::string file = name_of_file(company.path);
    if (!fit_.is_known()) return {name, phrase("%1, not checked", file), V::info};
    if (!fit_.is_its_job()) return {name, phrase("%1, of another run", file), V::fail};
    return {name, phrase("%1, checked", file), V::pass};
}

void TraceRecording::list_contents(const Company& company) {
    auto& rows = facts_.contents;
    const auto count = static_cast<std::int64_t>(index_->events());
    rows.push_back({phrase("Every pulse"), phrase("%1 changes", session::count_text(count)), V::pass});
    const bool is_whole = index_->damage().empty();
    rows.push_back(
        {phrase("End"), is_whole ? phrase("whole") : phrase("cut off"), is_whole ? V::pass : V::fail});
    rows.push_back(job_row(company));
    rows.push_back({phrase("Machine profile"), company.job ? phrase("the job's") : phrase("assumed"),
                    company.job ? V::pass : V::info});
    rows.push_back(
        {phrase("Flight recorder"),
         record_count_ > 0 ? phrase("%1 entries", std::to_string(record_count_)) : phrase("not in a trace"),
         record_count_ > 0 ? V::pass : V::info});
    rows.push_back({phrase("States"), facts_.knows_states ? phrase("recorded") : phrase("from the pins"),
                    facts_.knows_states ? V::pass : V::info});
}

void TraceRecording::guess_state(CoreStatus& status) const noexcept {
    const bool is_spinning = (status.signals & bit_of(Signal::spindle)) != 0;
    if ((status.signals & kEnableMask) == 0) {
        status.state = MachineState::off;
    } else {
        status.state = is_spinning ? MachineState::carving : MachineState::ready;
    }
}

Result<Shown> TraceRecording::at(std::int64_t time_ns, bool with_looks) {
    const auto moment = cursor_.at(time_ns);
    if (!moment) return moment.error();
    Shown shown;
    shown.time_ns = time_ns;
    shown.carving_time = time_ns;
    CoreStatus& status = shown.status;
    status.period_ns = index_->start().period_ns;
    status.tick = static_cast<std::uint64_t>(time_ns / status.period_ns);
    status.signals = moment->levels;
    status.alarm_axis = kNoAxis;
    status.seconds_left = -1.0;
    status.reference_seconds = -1.0;
    std::copy(moment->position_pulses.begin(), moment->position_pulses.end(), status.position_pulses);
    std::copy(moment->pulses.begin(), moment->pulses.end(), status.emitted_pulses);
    guess_state(status);
    states_.fill(status, status.tick);
    const bool is_job = is_at_job(status.state) && !states_.runs_program(status.tick);
    if (geometry_ && is_job) shown.place = job_place(*geometry_, moment->position_pulses);
    if (with_looks) {
        auto looks = looks_.until(time_ns);
        if (!looks) return looks.error();
        shown.looks = std::move(looks).value();
    }
    return shown;
}

}  // namespace psicarve::replay
