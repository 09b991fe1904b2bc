// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/journal/journal_writer.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "rtcore/process/state_folder.hpp"
#include "rtcore/process/words.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::supervisor {
namespace {

constexpr int kTries = 3;  ///< to open a file while other cores exchange it

Error cannot_write(const std::string& path, int error) {
    return Error{error == ENOSPC ? ErrorCode::out_of_room : ErrorCode::bad_input,
                 path + ": cannot be written: " + std::generic_category().message(error)};
}

/// Whether a file may be written: one of ours with this name alone.
bool is_own_file(int file, struct stat& facts) noexcept {
    return ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_uid == ::geteuid() &&
           facts.st_nlink == 1;
}

void sync_folder(const std::string& path) noexcept {
    const OpenFile folder{::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (folder.get() >= 0) static_cast<void>(::fsync(folder.get()));
}

/// A record that a power cut or a full disk has torn at its end.
bool has_torn_end(int file, off_t size) noexcept {
    char last = '\n';
    return size > 0 && ::pread(file, &last, 1, size - 1) == 1 && last != '\n';
}

bool write_whole(int file, const std::string& text) noexcept {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            if (written == 0) errno = ENOSPC;
            return false;
        }
        done += static_cast<std::size_t>(written);
    }
    return true;
}

}  // namespace

JournalWriter::JournalWriter(JournalPlace place, std::uint64_t most_file_bytes)
    : place_(std::move(place)),
      files_(StateNames{place_.folder, place_.segment_name, place_.is_simulator}),
      most_file_bytes_(most_file_bytes) {}

void JournalWriter::look_at_before() {
    if (std::exchange(has_looked_, true)) return;
    JournalTail before{files_};
    for (const JournalRecord& record : before.read_more()) {
        sequence_ = std::max(sequence_, record.sequence);
        // Also where an exchange of files has removed the run's start.
        run_ = std::max(run_, record.run);
        if (record.kind != JournalKind::core) continue;
        if (record.what == "start" && record.run >= started_run_) {
            started_run_ = record.run;
            started_run_boot_id_ = record.facts.text("boot");
        } else if (record.what == "end") {
            ended_run_ = std::max(ended_run_, record.run);
        }
    }
    is_before_unread_ = !before.errors().empty();
}

/// How the run before this one ended, if that is known.
std::string JournalWriter::before_text(const std::string& boot_id) const {
    if (is_before_unread_) return "unknown";
    if (sequence_ == 0 && run_ == 0) return "none";
    if (ended_run_ == run_) return "in order";
    if (started_run_ != run_ || started_run_boot_id_.empty() || boot_id.empty()) return "no end";
    return boot_id == started_run_boot_id_ ? "killed" : "no end, started again";
}

void JournalWriter::tell_of_before(JournalRecord& start) {
    const std::string boot_id = current_boot_id();
    start.facts.add("before", before_text(boot_id)).add("boot", boot_id);
    ++run_;
}

void JournalWriter::write(JournalRecord record) {
    look_at_before();
    if (record.kind == JournalKind::core && record.what == "start") tell_of_before(record);
    std::string text;
    const std::uint64_t lost = lost_.load();
    if (lost > 0) {
        JournalRecord gap;
        gap.sequence = ++sequence_;
        gap.run = run_;
        gap.time_ms = record.time_ms;
        gap.what = "not written";
        gap.facts.add("count", static_cast<std::int64_t>(lost));
        text = journal_line(gap);
    }
    record.sequence = ++sequence_;
    record.run = run_;
    text += journal_line(record);
    // Where more records wait, this one is synced with them.
    const bool is_last = given_.fetch_sub(1) <= 1;
    if (const auto written = append(text, is_last); !written) {
        lost_.fetch_add(1);
        return fail(written.error());
    }
    lost_.fetch_sub(lost);
    has_failed_ = false;
}

/// Appends either the whole text, or nothing that counts as a record.
Result<void> JournalWriter::append(const std::string& line, bool must_stay) {
    if (const auto made = make_state_folder(place_.folder); !made) return made.error();
    const auto opened = open_newer(line.size());
    if (!opened) return opened.error();
    const int file = opened->get();
    struct stat facts {};
    if (::fstat(file, &facts) != 0) return cannot_write(files_.newer, errno);
    const bool is_torn = has_torn_end(file, facts.st_size);
    if (!write_whole(file, is_torn ? "\n" + line : line)) {
        const int error = errno;
        // If this fails, the rest is one damaged line.
        [[maybe_unused]] const int cut = ::ftruncate(file, facts.st_size);
        return cannot_write(files_.newer, error);
    }
    if (must_stay) sync(file);
    if (facts.st_size == 0) sync_folder(files_.newer);
    return {};
}

/// The record is written either way, and readers find it.
void JournalWriter::sync(int file) {
    if (::fdatasync(file) == 0) {
        has_sync_failed_ = false;
        return;
    }
    const int error = errno;
    if (std::exchange(has_sync_failed_, true)) return;
    rtcore::try_to_say(files_.newer + ": " + std::generic_category().message(error) +
                       "; what is written there may be lost at a power cut");
}

/// Makes it the older file. A file that is not ours must not replace history.
Result<void> JournalWriter::put_aside(bool is_own) const {
    struct stat facts {};
    const bool is_kept = ::lstat(files_.older.c_str(), &facts) == 0 && S_ISREG(facts.st_mode);
    if (!is_own && is_kept && facts.st_size > 0)
        return bad_input(files_.newer + ": is not this core's to write to, and " + files_.older +
                         " has its place; take one of them away");
    if (std::rename(files_.newer.c_str(), files_.older.c_str()) != 0)
        return cannot_write(files_.newer, errno);
    return {};
}

/// Opens the newer file; one that is full, or not ours to write to, becomes the older one.
Result<OpenFile> JournalWriter::open_newer(std::uint64_t line_bytes) {
    constexpr int kFlags = O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    for (int left = kTries; left > 0; --left) {
        OpenFile file{::open(files_.newer.c_str(), kFlags, kForEverybody)};
        const int error = errno;
        const bool is_anothers = file.get() < 0 && (error == EACCES || error == ELOOP || error == ENXIO);
        if (file.get() < 0 && !is_anothers) return cannot_write(files_.newer, error);
        struct stat facts {};
        const bool is_own = !is_anothers && is_own_file(file.get(), facts);
        if (is_own) {
            const auto size = static_cast<std::uint64_t>(facts.st_size);
            if (size == 0) static_cast<void>(::fchmod(file.get(), kForEverybody));
            if (size == 0 || size + line_bytes <= most_file_bytes_) return file;
            sync(file.get());
        }
        if (const auto aside = put_aside(is_own); !aside) return aside.error();
    }
    return cannot_write(files_.newer, EBUSY);
}

void JournalWriter::fail(const Error& why) {
    if (std::exchange(has_failed_, true)) return;
    rtcore::try_to_say(why.message + "; what happens to the machine is not written down");
}

}  // namespace psicarve::supervisor
