// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/standard_streams.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "hmi/model/source_name.hpp"

namespace psicarve::cli {
namespace {

Error wrong_input(const char* what) {
    return bad_input(std::string{"standard input: "} + what + ": " + std::strerror(errno));
}

/// As much as the largest table that is read; a computer that carves must have room for it.
constexpr std::uint64_t kMostInputBytes = std::uint64_t{1} << 30U;

bool write_whole(int descriptor, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t done = write(descriptor, bytes, count);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes += done;
        count -= static_cast<std::size_t>(done);
    }
    return true;
}

}  // namespace

Result<std::string> file_of_standard_input() {
    const int memory = memfd_create("standard input", 0);  // a core of our own reads it, too
    if (memory < 0) return wrong_input("no memory for it");
    std::array<char, 1U << 16U> bytes;
    std::uint64_t count = 0;
    for (;;) {
        const ssize_t got = read(STDIN_FILENO, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got == 0) break;
        if (got > 0) count += static_cast<std::uint64_t>(got);
        if (count > kMostInputBytes) {
            close(memory);
            return bad_input("standard input: more than 1 GiB, which is all that is read of it; name a file");
        }
        const bool is_kept = got > 0 && write_whole(memory, bytes.data(), static_cast<std::size_t>(got));
        if (is_kept) continue;
        const Error error = wrong_input("cannot be read");
        close(memory);
        return error;
    }
    // Stays open until the program ends: the name leads to it.
    return std::string{model::kDescriptorFolder} + std::to_string(memory);
}

bool is_standard_output(const std::string& name) {
    return name == "-";
}

Result<void> check_standard_output(const std::string& name, bool as_json) {
    if (!is_standard_output(name)) return {};
    if (as_json)
        return Error{ErrorCode::bad_usage,
                     "- and --json: standard output takes one of them, the file or the report"};
    if (isatty(STDOUT_FILENO) == 1)
        return Error{ErrorCode::bad_usage,
                     "-: standard output is a terminal, and what is written is not for it"};
    return {};
}

}  // namespace psicarve::cli
