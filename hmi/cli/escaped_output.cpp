// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/escaped_output.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <string_view>

#include "shared/base/printable.hpp"

namespace psicarve::cli {
namespace {

/// False, with errno, where not all of it went out.
bool write_to_stdout(std::string_view text) noexcept {
    while (!text.empty()) {
        const ssize_t put = ::write(STDOUT_FILENO, text.data(), text.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(put));
    }
    return true;
}

ssize_t write_escaped(void* cookie, const char* bytes, std::size_t size) {
    std::string& held = *static_cast<std::string*>(cookie);
    std::string text = held;
    text.append(bytes, size);
    const std::size_t unfinished = unfinished_letter_bytes(text);
    held = text.substr(text.size() - unfinished);
    text.resize(text.size() - unfinished);
    return write_to_stdout(printable(text)) ? static_cast<ssize_t>(size) : 0;
}

}  // namespace

EscapedOutput::EscapedOutput()
    : before_(stdout), escaped_(::fopencookie(&held_, "w", {nullptr, write_escaped, nullptr, nullptr})) {
    if (escaped_ == nullptr) return;
    (void)std::fflush(before_);
    // As stdout does it by itself.
    (void)std::setvbuf(escaped_, nullptr, ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF, BUFSIZ);
    stdout = escaped_;
}

EscapedOutput::~EscapedOutput() {
    if (escaped_ == nullptr) return;
    stdout = before_;
    (void)std::fclose(escaped_);
    (void)write_to_stdout(printable(held_));
}

void print_as_it_is(const std::string& text) {
    (void)std::fflush(stdout);
    (void)write_to_stdout(text);
}

}  // namespace psicarve::cli
