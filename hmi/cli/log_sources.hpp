// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cli/log_text.hpp"
#include "hmi/machine/loose_work.hpp"
#include "shared/base/result.hpp"
#include "shared/record/journal_file.hpp"

namespace psicarve::cli {

/// The journals of a segment, of the real machine and of a simulated one, wherever cores keep them, as one:
/// in each of them the order of its records, between them that of their times. A disk that hangs is waited
/// for only so long.
class LogSources {
public:
    /// `folder`: where cores keep them; empty: where they do by themselves.
    LogSources(const std::string& segment, const std::string& folder);

    /// All that is there. An error: the disk does not answer.
    Result<std::vector<LogEntry>> read_first();
    /// What has come since; nothing yet where the disk takes longer than this.
    std::vector<LogEntry> read_more(std::chrono::milliseconds patience);
    /// Of what was read so far.
    bool has_found_file() const noexcept { return has_found_file_; }
    std::uint64_t damaged_count() const noexcept { return damaged_count_; }
    /// Files that cannot be read, each told of once; they hide none of the others.
    std::vector<Error> take_errors() { return std::exchange(errors_, {}); }
    Error nothing_found() const;

private:
    struct Source {
        JournalTail tail;
        bool is_simulator;
        std::size_t told_errors = 0;
    };
    /// The sources go along with the thread that reads them, and come back.
    struct Outcome {
        std::shared_ptr<std::vector<Source>> sources;
        std::vector<LogEntry> entries;
    };
    static Outcome read(std::shared_ptr<std::vector<Source>> sources);
    std::optional<std::vector<LogEntry>> take(std::chrono::milliseconds patience);

    std::string segment_;
    std::vector<std::string> folders_;
    std::shared_ptr<std::vector<Source>> sources_;
    machine::LooseWork<Outcome> work_;
    bool has_found_file_ = false;
    std::uint64_t damaged_count_ = 0;
    std::vector<Error> errors_;
};

/// Ctrl-C ends it sooner.
void sleep_unless_asked(std::chrono::milliseconds limit);

}  // namespace psicarve::cli
