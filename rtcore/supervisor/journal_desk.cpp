// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/journal_desk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "rtcore/supervisor/state_folder.hpp"
#include "rtcore/words.hpp"
#include "shared/atomic_file.hpp"
#include "shared/process_identity.hpp"

namespace psicarve::supervisor {
namespace {

constexpr int kTries = 3;  ///< to open a file while others exchange it

Error cannot_write(const std::string& path, int error) {
    return Error{error == ENOSPC ? ErrorCode::out_of_room : ErrorCode::bad_input,
                 path + ": cannot be written: " + std::generic_category().message(error)};
}

/// Nothing but a file of ours that has this one name is written to.
bool is_own_file(int file, struct stat& facts) noexcept {
    return ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_uid == ::geteuid() &&
           facts.st_nlink == 1;
}

void sync_folder(const std::string& path) noexcept {
    const OpenFile folder{::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (folder.get() >= 0) static_cast<void>(::fsync(folder.get()));
}

/// A record that was torn at its end, by a power cut or a full disk.
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

JournalDesk::JournalDesk(JournalPlace place, std::uint64_t most_file_bytes)
    : place_(std::move(place)),
      files_(StateNames{place_.folder, place_.segment_name, place_.is_simulator}),
      most_file_bytes_(most_file_bytes) {}

void JournalDesk::look_at_before() {
    if (std::exchange(has_looked_, true)) return;
    // What cannot be read is begun anew behind it; its last numbers nobody knows then.
    const auto before = read_journal(files_);
    if (!before) return;
    for (const JournalRecord& record : *before) {
        sequence_ = std::max(sequence_, record.sequence);
        if (record.kind != JournalKind::core) continue;
        if (record.what == "start") {
            run_ = std::max(run_, record.run);
            run_boot_id_ = record.facts.text("boot");
            has_run_ended_ = false;
        } else if (record.what == "end") {
            has_run_ended_ = true;
        }
    }
}

void JournalDesk::tell_of_before(JournalRecord& start) {
    const std::string boot_id = current_boot_id();
    std::string before = "in order";
    if (run_ == 0) {
        before = "none";
    } else if (!has_run_ended_) {
        before = boot_id == run_boot_id_ ? "killed" : "switched off";
    }
    start.facts.add("before", before).add("boot", boot_id);
    ++run_;
}

void JournalDesk::write(JournalRecord record) {
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
    // Where more waits, that is synced with it.
    const bool is_last = given_.fetch_sub(1) <= 1;
    if (const auto written = append(text, is_last); !written) {
        lost_.fetch_add(1);
        return fail(written.error());
    }
    lost_.fetch_sub(lost);
    has_failed_ = false;
}

/// Either the whole text, or nothing that is a record.
Result<void> JournalDesk::append(const std::string& line, bool must_stay) {
    if (const auto made = make_state_folder(place_.folder); !made) return made.error();
    const auto opened = open_newer(line.size());
    if (!opened) return opened.error();
    const int file = opened->get();
    struct stat facts {};
    if (::fstat(file, &facts) != 0) return cannot_write(files_.newer, errno);
    const bool is_torn = has_torn_end(file, facts.st_size);
    if (!write_whole(file, is_torn ? "\n" + line : line)) {
        const int error = errno;
        // Refused or not: what is left of it is one damaged line.
        [[maybe_unused]] const int cut = ::ftruncate(file, facts.st_size);
        return cannot_write(files_.newer, error);
    }
    if (must_stay && ::fdatasync(file) != 0) return cannot_write(files_.newer, errno);
    if (facts.st_size == 0) sync_folder(files_.newer);
    return {};
}

/// One that is full, or not ours to write to, becomes the older one.
Result<OpenFile> JournalDesk::open_newer(std::uint64_t line_bytes) const {
    constexpr int kFlags = O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    for (int left = kTries; left > 0; --left) {
        OpenFile file{::open(files_.newer.c_str(), kFlags, kForEverybody)};
        const int error = errno;
        const bool is_anothers = file.get() < 0 && (error == EACCES || error == ELOOP || error == ENXIO);
        if (file.get() < 0 && !is_anothers) return cannot_write(files_.newer, error);
        struct stat facts {};
        if (!is_anothers && is_own_file(file.get(), facts)) {
            const auto size = static_cast<std::uint64_t>(facts.st_size);
            if (size == 0) static_cast<void>(::fchmod(file.get(), kForEverybody));
            if (size == 0 || size + line_bytes <= most_file_bytes_) return file;
        }
        if (std::rename(files_.newer.c_str(), files_.older.c_str()) != 0)
            return cannot_write(files_.newer, errno);
    }
    return cannot_write(files_.newer, EBUSY);
}

void JournalDesk::fail(const Error& why) {
    if (std::exchange(has_failed_, true)) return;
    rtcore::try_to_say(why.message + "; what happens to the machine is not written down");
}

}  // namespace psicarve::supervisor
