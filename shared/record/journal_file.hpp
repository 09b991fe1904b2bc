// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/file/partial_file.hpp"
#include "shared/file/state_place.hpp"
#include "shared/record/journal.hpp"

namespace psicarve {

/// The two files of one segment and one kind of machine: the core writes to the newer, which takes the
/// older's name when it is full. No other segment and no other kind of machine uses these names.
struct JournalFiles {
    explicit JournalFiles(const StateNames& names);
    std::string newer;
    std::string older;
};

/// The greatest size of each file.
inline constexpr std::uint64_t kMostJournalBytes = std::uint64_t{4} << 20;

/// Reads a journal, from the oldest record on, while a core may be writing it; each further call reads what
/// has come since, also when the files were exchanged or the core is another. One thread only; waits for a
/// disk that hangs.
class JournalTail {
public:
    explicit JournalTail(JournalFiles files) : files_(std::move(files)) {}

    /// The records that were not read yet, in their order. A file that cannot be read does not hide the
    /// other.
    std::vector<JournalRecord> read_more();
    /// Files that exist but cannot be read, so far; each once, however often it is tried again.
    const std::vector<Error>& errors() const noexcept { return errors_; }
    /// There is, or was, a file.
    bool has_found_file() const noexcept { return open_ != nullptr; }
    /// Lines that are no records, so far. The unfinished line at the newer file's end may become one, and
    /// does not count.
    std::uint64_t damaged_count() const noexcept { return damaged_count_; }

private:
    struct Identity {
        std::uint64_t device = 0;
        std::uint64_t inode = 0;
        bool operator==(const Identity&) const = default;
    };
    struct OpenJournal {
        OpenFile file;
        Identity identity;
        std::string begun_line;
    };
    using Opened = std::unique_ptr<OpenJournal>;
    static Result<Opened> open(const std::string& path);
    Opened open_or_note(const std::string& path);
    Opened open_next();
    void note(const Error& error);
    void read_rest(std::vector<JournalRecord>& records);
    void take_lines(std::string_view text, std::vector<JournalRecord>& records);
    void take_line(std::string_view line, std::vector<JournalRecord>& records);
    void turn_to(Opened next);

    JournalFiles files_;
    Opened open_;
    Opened before_;  ///< read to its end; stays open, so that no other file gets its inode
    std::uint64_t damaged_count_ = 0;
    std::vector<Error> errors_;
};

/// Reads both files. An error: there is one, and none can be read.
Result<std::vector<JournalRecord>> read_journal(const JournalFiles& files);

}  // namespace psicarve
