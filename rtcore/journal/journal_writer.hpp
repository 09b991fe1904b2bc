// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "shared/base/result.hpp"
#include "shared/file/state_place.hpp"
#include "shared/record/journal.hpp"
#include "shared/record/journal_file.hpp"

namespace psicarve::supervisor {

/// Which journal is kept, and where.
struct JournalPlace {
    std::string folder;  ///< made when something is first kept; empty: nothing is kept
    std::string segment_name;
    bool is_simulator = false;
};

/// Appends to the journal's files, in a thread that may hang for good. Records that cannot be written are
/// counted; the journal reports the count once it can be written again, and standard error reports it once.
class JournalWriter {
public:
    explicit JournalWriter(JournalPlace place, std::uint64_t most_file_bytes = kMostJournalBytes);

    // --- any thread
    /// Call it before one more record is given to `write`.
    void note_given() noexcept { given_.fetch_add(1); }
    /// A record, noted as given or not, that will never be written.
    void note_lost(bool was_given) noexcept {
        lost_.fetch_add(1);
        if (was_given) given_.fetch_sub(1);
    }

    // --- the thread that writes
    /// Gives the record its number and writes it. The "start" of a core begins a run, and gets the end of the
    /// run before as a fact.
    void write(JournalRecord record);

private:
    void look_at_before();
    std::string before_text(const std::string& boot_id) const;
    void tell_of_before(JournalRecord& start);
    Result<void> append(const std::string& line, bool must_stay);
    Result<OpenFile> open_newer(std::uint64_t line_bytes);
    Result<void> put_aside(bool is_own) const;
    void sync(int file);
    void fail(const Error& why);

    JournalPlace place_;
    JournalFiles files_;
    std::uint64_t most_file_bytes_;
    std::atomic<std::uint64_t> given_{0};  ///< given, and not written yet
    std::atomic<std::uint64_t> lost_{0};
    bool has_looked_ = false;
    std::uint64_t sequence_ = 0;
    std::uint64_t run_ = 0;
    bool is_before_unread_ = false;    ///< some of the earlier records could not be read
    std::uint64_t ended_run_ = 0;      ///< the last one that has an end
    std::uint64_t started_run_ = 0;    ///< the last one that has a start
    std::string started_run_boot_id_;  ///< the boot of that run
    bool has_failed_ = false;
    bool has_sync_failed_ = false;
};

}  // namespace psicarve::supervisor
