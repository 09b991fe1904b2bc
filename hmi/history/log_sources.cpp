// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/history/log_sources.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "shared/file/state_place.hpp"

namespace psicarve::history {
namespace {

constexpr std::chrono::seconds kFirstPatience{5};

/// Records of one journal keep their order, whatever its clock did.
void merge_by_time(std::vector<LogEntry>& all, std::vector<LogEntry> more) {
    std::vector<LogEntry> merged;
    merged.reserve(all.size() + more.size());
    auto next = more.begin();
    for (LogEntry& entry : all) {
        for (; next != more.end() && next->record.time_ms < entry.record.time_ms; ++next)
            merged.push_back(std::move(*next));
        merged.push_back(std::move(entry));
    }
    std::move(next, more.end(), std::back_inserter(merged));
    all = std::move(merged);
}

}  // namespace

LogSources::LogSources(const std::string& segment, const std::string& folder)
    : segment_(segment),
      folders_(folder.empty() ? state_folders_to_read() : std::vector<std::string>{folder}),
      sources_(std::make_shared<std::vector<Source>>()) {
    for (const std::string& place : folders_) {
        for (const bool is_simulator : {false, true}) {
            const StateNames names{place, segment, is_simulator};
            sources_->push_back({.tail = JournalTail{JournalFiles{names}}, .is_simulator = is_simulator});
        }
    }
}

LogSources::Outcome LogSources::read(std::shared_ptr<std::vector<Source>> sources) {
    std::vector<LogEntry> all;
    for (Source& source : *sources) {
        std::vector<LogEntry> entries;
        for (JournalRecord& record : source.tail.read_more())
            entries.push_back({std::move(record), source.is_simulator});
        merge_by_time(all, std::move(entries));
    }
    return {std::move(sources), std::move(all)};
}

std::optional<std::vector<LogEntry>> LogSources::take(std::chrono::milliseconds patience) {
    if (!work_.is_under_way())
        work_.begin([sources = std::exchange(sources_, nullptr)] { return read(sources); });
    auto outcome = work_.take(patience);
    if (!outcome) return std::nullopt;
    sources_ = std::move(outcome->sources);
    damaged_count_ = 0;
    for (Source& source : *sources_) {
        const std::vector<Error>& errors = source.tail.errors();
        for (; source.told_errors < errors.size(); ++source.told_errors)
            errors_.push_back(errors[source.told_errors]);
        has_found_file_ = has_found_file_ || source.tail.has_found_file();
        damaged_count_ += source.tail.damaged_count();
    }
    return std::move(outcome->entries);
}

Result<std::vector<LogEntry>> LogSources::read_first() {
    auto entries = take(kFirstPatience);
    if (entries) return std::move(*entries);
    return bad_input("the disk that keeps the journal does not answer");
}

std::vector<LogEntry> LogSources::read_more(std::chrono::milliseconds patience) {
    auto entries = take(patience);
    if (entries) return std::move(*entries);
    return {};
}

Error LogSources::nothing_found() const {
    std::string places;
    for (const std::string& folder : folders_) places += (places.empty() ? "" : " or ") + folder;
    return bad_input("no journal of " + segment_ + (places.empty() ? "" : " in " + places) +
                     "; cores on the real clock keep one, others with --state FOLDER");
}

}  // namespace psicarve::history
