// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/trace/trace_output.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <ctime>
#include <thread>
#include <utility>

namespace psicarve {
namespace {

/// How long a pipe may be without a reader: both may just have been started. Shorter than a recording's
/// lease.
constexpr std::chrono::milliseconds kReaderLimit{1000};
constexpr std::chrono::milliseconds kReaderPoll{5};

/// Keeps SIGPIPE from this thread while it writes to a pipe, whatever the program does about signals.
class NoPipeSignal {
public:
    NoPipeSignal() noexcept {
        sigemptyset(&pipe_signal_);
        sigaddset(&pipe_signal_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        was_pending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &pipe_signal_, &mask_before_);
    }
    ~NoPipeSignal() {
        const timespec at_once{};
        if (!was_pending_) {
            while (sigtimedwait(&pipe_signal_, nullptr, &at_once) < 0 && errno == EINTR) {
            }
        }
        pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
    }
    NoPipeSignal(const NoPipeSignal&) = delete;
    NoPipeSignal& operator=(const NoPipeSignal&) = delete;

private:
    sigset_t pipe_signal_;
    sigset_t mask_before_;
    bool was_pending_;
};

Error cannot_open(const std::string& name, const std::string& why) {
    return bad_input("trace " + name + ": " + why);
}

std::string words_for(int error) {
    return std::generic_category().message(error);
}

Result<int> open_inherited(const std::string& path) {
    int fd = -1;
    const char* const end = path.data() + path.size();
    const auto [stopped, error] = std::from_chars(path.data() + 3, end, fd);
    if (error != std::errc{} || stopped != end || fd < 0) {
        return Error{ErrorCode::bad_usage,
                     "trace " + path + ": write fd:N, N being an open descriptor's number"};
    }
    const int flags = fcntl(fd, F_GETFL);
    if (flags < 0) return cannot_open(path, words_for(errno));
    if ((flags & O_ACCMODE) == O_RDONLY) return cannot_open(path, "it is open for reading only");
    if (fcntl(fd, F_SETFD, FD_CLOEXEC) < 0) return cannot_open(path, words_for(errno));
    return fd;
}

bool is_pipe(const std::string& path) noexcept {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

/// A file with another name as well belongs to another user, who put it in our way.
Result<void> empty_file(int fd, const std::string& path) {
    struct stat status {};
    if (fstat(fd, &status) != 0) return cannot_open(path, words_for(errno));
    if (!S_ISREG(status.st_mode)) return {};
    if (status.st_nlink > 1)
        return cannot_open(path, "the file has other names (hard links); remove this one");
    if (ftruncate(fd, 0) == 0) return {};
    return cannot_open(path, words_for(errno));
}

/// Gives up a pipe without a reader after a time limit; a pipe with a reader may make us wait.
Result<int> open_named(const std::string& path) {
    constexpr int kFlags = O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    const auto give_up = std::chrono::steady_clock::now() + kReaderLimit;
    int fd = ::open(path.c_str(), kFlags, 0666);
    while (fd < 0 && errno == ENXIO && is_pipe(path)) {
        if (std::chrono::steady_clock::now() >= give_up)
            return cannot_open(path, "nobody reads this pipe; start its reader first");
        std::this_thread::sleep_for(kReaderPoll);
        fd = ::open(path.c_str(), kFlags, 0666);
    }
    if (fd >= 0) {
        if (const auto emptied = empty_file(fd, path); !emptied) {
            ::close(fd);
            return emptied.error();
        }
        fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) & ~O_NONBLOCK);
        return fd;
    }
    if (errno == ELOOP) return cannot_open(path, "it is a symbolic link; name the file itself");
    return cannot_open(path, words_for(errno));
}

Result<int> open_any(const std::string& path) {
    if (path.starts_with("fd:")) return open_inherited(path);
    if (path != "-") return open_named(path);
    const int fd = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (fd >= 0) return fd;
    return cannot_open(path, words_for(errno));
}

}  // namespace

Result<TraceOutput> TraceOutput::open(const std::string& path) {
    const Result<int> fd = open_any(path);
    if (!fd) return fd.error();
    return TraceOutput{*fd, path};
}

TraceOutput::TraceOutput(int fd, std::string name)
    : fd_(fd), name_(std::move(name)), buffer_(std::make_unique<std::uint8_t[]>(kBufferBytes)) {
    struct stat status {};
    const bool is_known = fstat(fd, &status) == 0;
    may_break_ = !is_known || S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
    is_named_ = is_known && S_ISREG(status.st_mode) && name_ != "-" && !name_.starts_with("fd:");
}

TraceOutput::TraceOutput(Taker taker)
    : taker_(std::move(taker)), buffer_(std::make_unique<std::uint8_t[]>(kBufferBytes)) {}

TraceOutput::TraceOutput(TraceOutput&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      taker_(std::exchange(other.taker_, {})),
      may_break_(other.may_break_),
      is_named_(other.is_named_),
      is_removed_(other.is_removed_),
      failed_errno_(other.failed_errno_),
      error_taken_(other.error_taken_),
      name_(std::move(other.name_)),
      buffer_(std::move(other.buffer_)),
      used_(std::exchange(other.used_, 0)),
      written_(std::move(other.written_)) {}

TraceOutput::~TraceOutput() {
    flush();
    if (fd_ >= 0) ::close(fd_);
}

void TraceOutput::write(std::string_view text) noexcept {
    while (!text.empty()) {
        const std::size_t count = std::min(text.size(), kLongestPiece);
        std::uint8_t* const place = room(count);
        std::memcpy(place, text.data(), count);
        commit(place + count);
        text.remove_prefix(count);
    }
}

void TraceOutput::flush() noexcept {
    const std::size_t count = std::exchange(used_, 0);
    if (count == 0 || failed_errno_ != 0) return;
    if (taker_) {
        taker_({buffer_.get(), count});
    } else if (may_break_) {
        const NoPipeSignal no_signal;
        write_out(buffer_.get(), count);
    } else {
        write_out(buffer_.get(), count);
    }
}

void TraceOutput::write_out(const std::uint8_t* bytes, std::size_t count) noexcept {
    while (count > 0) {
        // A pipe's reader may be slow: shows what it takes before it takes all.
        const ssize_t written =
            ::write(fd_, bytes, may_break_ ? std::min<std::size_t>(count, PIPE_BUF) : count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            failed_errno_ = written < 0 ? errno : EIO;
            if (is_named_) remove_file();
            return;
        }
        written_->fetch_add(static_cast<std::uint64_t>(written), std::memory_order_relaxed);
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

/// Unless the name leads to another file by now.
void TraceOutput::remove_file() noexcept {
    struct stat ours {};
    struct stat named {};
    const bool is_ours = fstat(fd_, &ours) == 0 && ::lstat(name_.c_str(), &named) == 0 &&
                         ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
    is_removed_ = is_ours && ::unlink(name_.c_str()) == 0;
    if (is_removed_) ::close(std::exchange(fd_, -1));  // else its disk space would stay taken
}

void TraceOutput::discard() noexcept {
    used_ = 0;
    if (failed_errno_ == 0 && is_named_) remove_file();
    failed_errno_ = failed_errno_ == 0 ? ECANCELED : failed_errno_;
    error_taken_ = true;
}

std::optional<Error> TraceOutput::take_error() {
    if (failed_errno_ == 0 || error_taken_) return std::nullopt;
    error_taken_ = true;
    const bool is_full = failed_errno_ == ENOSPC || failed_errno_ == EDQUOT || failed_errno_ == EFBIG;
    return Error{is_full ? ErrorCode::out_of_room : ErrorCode::bad_input,
                 "trace " + name_ + ": " + words_for(failed_errno_) +
                     (is_removed_ ? "; what there was of it is not complete and was removed"
                                  : "; it ends there and is not complete")};
}

}  // namespace psicarve
