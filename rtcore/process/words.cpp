// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/words.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace psicarve::rtcore {
namespace {

/// A line, written in one piece, so that those of several processes do not mix. Longer ones are cut.
class Line {
public:
    explicit Line(std::string_view text) noexcept {
        append("psicarve-rtcore: ");
        append(text.substr(0, text_.size() - size_ - 1));
        append("\n");
    }
    const char* data() const noexcept { return text_.data(); }
    std::size_t size() const noexcept { return size_; }

private:
    void append(std::string_view part) noexcept {
        std::copy(part.begin(), part.end(), text_.begin() + size_);
        size_ += part.size();
    }
    std::array<char, 2048> text_{};  // less than what a pipe takes as a whole
    std::size_t size_ = 0;
};

/// Opens the same pipe or terminal once more, without blocking: the flags of the descriptor that was given to
/// us are shared with its other users.
int open_without_waiting() noexcept {
    return open("/proc/self/fd/2", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

/// A second descriptor of a file would have a position of its own.
bool is_file() noexcept {
    struct stat status {};
    return fstat(STDERR_FILENO, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

void say(std::string_view line) noexcept {
    const Line whole{line};
    for (std::size_t done = 0; done < whole.size();) {
        const ssize_t written = write(STDERR_FILENO, whole.data() + done, whole.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;
        done += static_cast<std::size_t>(written);
    }
}

void try_to_say(std::string_view line) noexcept {
    if (is_file()) return say(line);
    const Line whole{line};
    // The journal's standard error is a socket.
    const ssize_t sent = send(STDERR_FILENO, whole.data(), whole.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent >= 0 || errno != ENOTSOCK) return;
    if (const int own = open_without_waiting(); own >= 0) {
        [[maybe_unused]] const ssize_t written = write(own, whole.data(), whole.size());
        close(own);
        return;
    }
    pollfd place{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
    if (poll(&place, 1, 0) != 1 || (place.revents & POLLOUT) == 0) return;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, whole.data(), whole.size());
}

}  // namespace psicarve::rtcore
