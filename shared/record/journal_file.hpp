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

/// The two files of one segment and one kind of machine: what is written goes to the newer, which takes the
/// older's name when it is full. No other segment's and no other kind's has one of these names.
struct JournalFiles {
    explicit JournalFiles(const StateNames& names);
    std::string newer;
    std::string older;
};

/// Each of the two is at most so large.
inline constexpr std::uint64_t kMostJournalBytes = std::uint64_t{4} << 20;

/// Reads a journal while a core may be writing it, from the oldest record on; and what has come since, again
/// and again, whether the files were exchanged meanwhile or the core is another. One owner's thread; waits
/// for a disk that hangs.
class JournalTail {
public:
    explicit JournalTail(JournalFiles files) : files_(std::move(files)) {}

    /// What was not read yet, in its order. A file that cannot be read hides nothing of the other.
    std::vector<JournalRecord> read_more();
    /// Of files that are there but cannot be read, so far; each once, however often it is tried again.
    const std::vector<Error>& errors() const noexcept { return errors_; }
    /// There is, or was, a file.
    bool has_found_file() const noexcept { return open_ != nullptr; }
    /// Lines that are no records, so far. What the newer file ends with may become one yet, and is not.
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
    Opened before_;  ///< read to its end; open, so that no other gets its inode
    std::uint64_t damaged_count_ = 0;
    std::vector<Error> errors_;
};

/// Both files at once. An error: none of them can be read, and there is one.
Result<std::vector<JournalRecord>> read_journal(const JournalFiles& files);

}  // namespace psicarve
