// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/log_text.hpp"
#include "hmi/cli/log_time.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/history/log_sources.hpp"
#include "shared/record/journal.hpp"

namespace psicarve::cli {
namespace {

using history::LogSources;

constexpr CommandText kLogText{
    "log", "What happened to the machine, over the restarts of its cores",
    "Alarms, commands with their senders and answers, jobs, starts and ends of cores, the newest last, from "
    "the\njournal that cores keep on a disk. Works without a core. --json: an object on each line.",
    "psicarve log --since 2h\n  psicarve log --kind alarm --kind job --last 20\n  psicarve log --follow"};

constexpr std::uint32_t kMostLast = 1'000'000;

struct LogOptions {
    std::string since;
    std::uint32_t last = 0;  ///< 0: all
    std::vector<std::string> kinds;
    bool follows = false;
    std::string state_folder;
};

struct LogFilter {
    std::int64_t since_ms = INT64_MIN;
    std::vector<JournalKind> kinds;  ///< none: all

    bool takes(const LogEntry& entry) const {
        const bool is_of_kind = kinds.empty() || std::ranges::find(kinds, entry.record.kind) != kinds.end();
        return is_of_kind && entry.record.time_ms >= since_ms;
    }
};

std::int64_t now_ms() {
    using std::chrono::system_clock;
    return std::chrono::duration_cast<std::chrono::milliseconds>(system_clock::now().time_since_epoch())
        .count();
}

Result<LogFilter> filter_of(const LogOptions& options) {
    LogFilter filter;
    if (!options.since.empty()) {
        const auto since = since_ms(options.since, now_ms());
        if (!since) return since.error();
        filter.since_ms = *since;
    }
    for (const std::string& name : options.kinds) {
        const auto kind = journal_kind(name);
        if (!kind) return Error{ErrorCode::bad_usage, "--kind '" + name + "': alarm, command, job or core"};
        filter.kinds.push_back(*kind);
    }
    return filter;
}

Result<void> print(const std::vector<LogEntry>& entries, bool as_json) {
    for (const LogEntry& entry : entries) {
        const std::string line =
            as_json ? log_json(entry).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                          "\n"
                    : log_line(entry);
        std::fputs(line.c_str(), stdout);
    }
    return flush_output();
}

void drop_others(std::vector<LogEntry>& entries, const LogFilter& filter) {
    std::erase_if(entries, [&](const LogEntry& entry) { return !filter.takes(entry); });
}

/// Counts and reports on standard error what is not shown, whenever there is more of it.
class LogWarnings {
public:
    void tell(LogSources& sources) {
        for (const Error& error : sources.take_errors()) print_warning(error.message);
        const std::uint64_t damaged = sources.damaged_count();
        if (damaged > damaged_told_)
            print_warning(std::to_string(damaged) + " damaged or torn records are left out");
        damaged_told_ = damaged;
    }

private:
    std::uint64_t damaged_told_ = 0;
};

/// Ctrl-C ends it early.
void sleep_unless_asked(std::chrono::milliseconds limit) {
    const timespec time{0, static_cast<long>(limit.count()) * 1'000'000};
    // A signal's handler is called in this thread, and ends the sleep.
    static_cast<void>(nanosleep(&time, nullptr));
}

Result<int> follow(LogSources& sources, const LogFilter& filter, LogWarnings& warnings, bool as_json,
                   const OperatorBreak& operator_break) {
    constexpr std::chrono::milliseconds kPeriod{300};
    while (!operator_break.was_asked()) {
        auto news = sources.read_more(kPeriod);
        drop_others(news, filter);
        if (const auto printed = print(news, as_json); !printed) return printed.error();
        warnings.tell(sources);
        sleep_unless_asked(kPeriod);
    }
    return kExitDone;
}

Result<int> show_log(const CommonOptions& common, const LogOptions& options) {
    const auto filter = filter_of(options);
    if (!filter) return filter.error();
    // Before anything is printed: Ctrl-C ends what follows with exit code 0 from its first line on.
    std::optional<OperatorBreak> operator_break;
    if (options.follows) operator_break.emplace();
    LogSources sources{common.segment, options.state_folder};
    auto entries = sources.read_first();
    if (!entries) return entries.error();
    if (!sources.has_found_file() && !options.follows) {
        const std::vector<Error> errors = sources.take_errors();
        return errors.empty() ? sources.nothing_found() : errors.front();
    }
    drop_others(*entries, *filter);
    if (options.last != 0 && entries->size() > options.last)
        entries->erase(entries->begin(), entries->end() - std::ptrdiff_t{options.last});
    if (const auto printed = print(*entries, common.json); !printed) return printed.error();
    LogWarnings warnings;
    warnings.tell(sources);
    if (!operator_break) return kExitDone;
    return follow(sources, *filter, warnings, common.json, *operator_break);
}

}  // namespace

void add_log(CommandSet& commands) {
    const auto options = std::make_shared<LogOptions>();
    commands.add(kLogText, [options](const CommonOptions& common) { return show_log(common, *options); })
        .option("--since", options->since, "TIME",
                "Not before: 30m, 2h, 3d ago, or 2026-11-26, '2026-11-26 19:23', the last 19:23")
        .option("--last", options->last, 1, kMostLast, "Only the newest so many")
        .words("--kind", options->kinds, "alarm|command|job|core", "Only these; may be given again")
        .flag("--follow", options->follows, "Go on with what happens until Ctrl-C")
        .option("--state", options->state_folder, "FOLDER",
                "Where the core keeps its journal, if it was given --state");
}

}  // namespace psicarve::cli
