// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/journal_history.hpp"

#include <map>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/session/journal_message.hpp"

namespace psicarve::session {

JournalHistory::JournalHistory(const std::string& segment, const std::string& folder,
                               std::chrono::system_clock::time_point opened, std::size_t most) {
    const auto opened_ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(opened.time_since_epoch()).count();
    work_.begin([=] { return read(segment, folder, opened_ms, most); });
}

/// What happened since then the window sees itself.
JournalHistory::Outcome JournalHistory::read(const std::string& segment, const std::string& folder,
                                             std::int64_t opened_ms, std::size_t most) {
    Outcome outcome;
    history::LogSources sources{segment, folder};
    auto entries = sources.read_first();
    if (!entries) {
        outcome.problem = entries.error().message;
        return outcome;
    }
    std::erase_if(*entries,
                  [&](const history::LogEntry& entry) { return entry.record.time_ms >= opened_ms; });
    std::map<std::pair<bool, std::uint64_t>, std::uint32_t> pids;  // by run
    std::size_t left_out = entries->size() > most ? entries->size() - most : 0;
    for (const history::LogEntry& entry : *entries) {
        std::uint32_t& pid = pids[{entry.is_simulator, entry.record.run}];
        const bool is_start = entry.record.kind == JournalKind::core && entry.record.what == "start";
        if (is_start) pid = static_cast<std::uint32_t>(entry.record.facts.number("pid").value_or(0));
        if (left_out > 0) {
            --left_out;
        } else {
            outcome.messages.push_back(journal_message(entry, pid));
        }
    }
    const std::vector<Error> errors = sources.take_errors();
    if (!errors.empty()) outcome.problem = errors.front().message;
    outcome.damaged_count = sources.damaged_count();
    return outcome;
}

void JournalHistory::poll(MessageLog& log) {
    auto outcome = work_.take();
    if (!outcome) return;
    is_read_ = true;
    messages_ = std::move(outcome->messages);
    if (!outcome->problem.empty()) {
        log.add(Severity::warning,
                joined(phrase("The machine's history is not shown in full"), error_phrase(outcome->problem)));
    } else if (outcome->damaged_count > 0) {
        log.add(Severity::info, phrase("Damaged or torn records of the machine's history are left out: %1",
                                       std::to_string(outcome->damaged_count)));
    }
}

}  // namespace psicarve::session
