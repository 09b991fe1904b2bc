// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::machine {

/// A file descriptor that closes itself. Never 0, 1 or 2 when made by the functions below, so that handing it
/// to a child cannot collide with the standard streams.
class UniqueFd {
public:
    UniqueFd() = default;
    explicit UniqueFd(int fd) noexcept : fd_(fd) {}
    UniqueFd(UniqueFd&& other) noexcept : fd_(other.release()) {}
    UniqueFd& operator=(UniqueFd&& other) noexcept;
    ~UniqueFd() { reset(); }

    int get() const noexcept { return fd_; }
    bool is_open() const noexcept { return fd_ >= 0; }
    int release() noexcept;
    void reset() noexcept;

private:
    int fd_ = -1;
};

/// Memory that reads and writes like a file; freed with its last descriptor. Closed in a child unless handed
/// on.
Result<UniqueFd> open_memory_file(const char* name);
/// The same, filled and rewound.
Result<UniqueFd> open_memory_file(const char* name, std::span<const std::byte> bytes);

struct Pipe {
    UniqueFd read_end;
    UniqueFd write_end;
};
Result<Pipe> open_pipe();

/// The last `most_bytes` of a file, by its descriptor.
std::string tail_of(int fd, std::size_t most_bytes);

}  // namespace psicarve::machine
