// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/journal_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace psicarve {
namespace {

Error cannot_read(const std::string& path) {
    return bad_input(path + ": cannot be read: " + std::generic_category().message(errno));
}

}  // namespace

// No ending is the end of another one: so none of these names can be that of another segment or kind.
JournalFiles::JournalFiles(const StateNames& names)
    : newer(names.base + (names.is_simulator ? ".simulated-journal" : ".journal")),
      older(names.base + (names.is_simulator ? ".older-simulated-journal" : ".older-journal")) {}

/// Null: there is none. Follows no link; waits for no pipe, device or folder.
Result<JournalTail::Opened> JournalTail::open(const std::string& path) {
    OpenFile file{::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
    if (file.get() < 0 && errno == ENOENT) return Opened{};
    if (file.get() < 0 && errno == ELOOP) return bad_input(path + ": is a link, and not followed");
    struct stat facts {};
    if (file.get() < 0 || ::fstat(file.get(), &facts) != 0) return cannot_read(path);
    if (!S_ISREG(facts.st_mode)) return bad_input(path + ": is no file");
    const Identity identity{static_cast<std::uint64_t>(facts.st_dev),
                            static_cast<std::uint64_t>(facts.st_ino)};
    return Opened{new OpenJournal{std::move(file), identity, {}}};
}

void JournalTail::note(const Error& error) {
    const bool is_known =
        std::ranges::any_of(errors_, [&](const Error& known) { return known.message == error.message; });
    if (!is_known) errors_.push_back(error);
}

/// Null also for a file that cannot be read.
JournalTail::Opened JournalTail::open_or_note(const std::string& path) {
    auto opened = open(path);
    if (opened) return std::move(*opened);
    note(opened.error());
    return {};
}

/// Null: the open file is the newest. Looks for the newer one first: if the files are exchanged before the
/// second look, that finds it under the older name.
JournalTail::Opened JournalTail::open_next() {
    auto newer = open_or_note(files_.newer);
    const bool is_newest = newer != nullptr && open_ != nullptr && open_->identity == newer->identity;
    if (is_newest) return {};
    auto older = open_or_note(files_.older);
    const auto is_read = [&](const Opened& known) {
        return known != nullptr && known->identity == older->identity;
    };
    if (older != nullptr && !is_read(open_) && !is_read(before_)) return older;
    return newer;
}

/// A line that has begun in the old file will have no end.
void JournalTail::turn_to(Opened next) {
    if (open_ != nullptr && !open_->begun_line.empty()) ++damaged_count_;
    before_ = std::exchange(open_, std::move(next));
}

void JournalTail::take_line(std::string_view line, std::vector<JournalRecord>& records) {
    if (line.empty()) return;  // written after a line that may have been torn
    if (auto record = parse_journal_line(line)) {
        records.push_back(std::move(*record));
    } else {
        ++damaged_count_;
    }
}

void JournalTail::take_lines(std::string_view text, std::vector<JournalRecord>& records) {
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        std::string& begun = open_->begun_line;
        if (begun.empty()) {
            take_line(text.substr(0, end), records);
        } else {
            begun += text.substr(0, end);
            take_line(std::exchange(begun, {}), records);
        }
        text.remove_prefix(end + 1);
    }
    // Garbage without a line feed is not collected: a longer line is no record.
    if (open_->begun_line.size() <= kMostJournalLineBytes) open_->begun_line += text;
}

void JournalTail::read_rest(std::vector<JournalRecord>& records) {
    std::vector<char> buffer(std::size_t{1} << 16);
    // Twice the size that a core writes: a writer that keeps filling the file does not hold us up.
    for (std::uint64_t left = 2 * kMostJournalBytes; left > 0;) {
        const ssize_t got = ::read(open_->file.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return note(cannot_read(files_.newer));
        if (got == 0) return;
        take_lines({buffer.data(), static_cast<std::size_t>(got)}, records);
        left -= std::min<std::uint64_t>(left, static_cast<std::uint64_t>(got));
    }
}

std::vector<JournalRecord> JournalTail::read_more() {
    std::vector<JournalRecord> records;
    for (;;) {
        if (open_ != nullptr) read_rest(records);
        auto next = open_next();
        if (next == nullptr) return records;
        // Reads the rest that was written before the files were exchanged.
        if (open_ != nullptr) read_rest(records);
        turn_to(std::move(next));
    }
}

Result<std::vector<JournalRecord>> read_journal(const JournalFiles& files) {
    JournalTail tail{files};
    auto records = tail.read_more();
    if (!tail.has_found_file() && !tail.errors().empty()) return tail.errors().front();
    return records;
}

}  // namespace psicarve
