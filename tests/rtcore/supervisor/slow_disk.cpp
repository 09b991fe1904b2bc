// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rtcore/supervisor/slow_disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

namespace psicarve::supervisor::test {
namespace {

std::atomic<bool> is_slow{false};
std::atomic<int> waiting_calls{0};
std::atomic<long> favoured_thread{0};

}  // namespace

SlowDisk::SlowDisk() noexcept {
    favoured_thread.store(syscall(SYS_gettid));
    is_slow.store(true);
}

SlowDisk::~SlowDisk() {
    is_slow.store(false);
    is_slow.notify_all();
}

void SlowDisk::wait_for_somebody() const noexcept {
    waiting_calls.wait(0);
}

namespace {

void wait_for_disk() noexcept {
    if (!is_slow.load() || favoured_thread.load() == syscall(SYS_gettid)) return;
    ++waiting_calls;
    waiting_calls.notify_all();
    is_slow.wait(true);
    --waiting_calls;
}

}  // namespace
}  // namespace psicarve::supervisor::test

// They stand before the C library's.
extern "C" int fsync(int file) {
    psicarve::supervisor::test::wait_for_disk();
    return static_cast<int>(syscall(SYS_fsync, file));
}

extern "C" int fstat(int file, struct stat* facts) noexcept {
    psicarve::supervisor::test::wait_for_disk();
    return fstatat(file, "", facts, AT_EMPTY_PATH);
}
