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

#include "hmi/machine/loose_work.hpp"
#include "shared/base/result.hpp"
#include "shared/record/journal.hpp"
#include "shared/record/journal_file.hpp"

namespace psicarve::history {

/// A record of a machine's journal, with the kind of machine.
struct LogEntry {
    JournalRecord record;
    bool is_simulator = false;
};

/// The journals of a segment, of the real machine and of a simulated one, from all folders in which cores
/// keep them, merged: within each the order of its records, between them that of their times. Waits for a
/// disk that hangs only for a limited time.
class LogSources {
public:
    /// `folder`: where cores keep them; empty: their default folders.
    LogSources(const std::string& segment, const std::string& folder);

    /// Reads all records. An error: the disk does not answer.
    Result<std::vector<LogEntry>> read_first();
    /// The records since the last call; nothing yet where the disk takes longer than `patience`.
    std::vector<LogEntry> read_more(std::chrono::milliseconds patience);
    /// In what was read so far.
    bool has_found_file() const noexcept { return has_found_file_; }
    std::uint64_t damaged_count() const noexcept { return damaged_count_; }
    /// Files that cannot be read, each reported once; the others are read all the same.
    std::vector<Error> take_errors() { return std::exchange(errors_, {}); }
    Error nothing_found() const;

private:
    struct Source {
        JournalTail tail;
        bool is_simulator;
        std::size_t told_errors = 0;
    };
    /// The sources move to the thread that reads them, and come back.
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

}  // namespace psicarve::history
