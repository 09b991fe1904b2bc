// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rtcore/supervisor/slow_disk.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

namespace psicarve::supervisor::test {
namespace {

std::atomic<bool> is_slow{false};
std::atomic<int> waiting_syncs{0};

}  // namespace

SlowDisk::SlowDisk() noexcept {
    is_slow.store(true);
}

SlowDisk::~SlowDisk() {
    is_slow.store(false);
    is_slow.notify_all();
}

void SlowDisk::wait_for_somebody() const noexcept {
    waiting_syncs.wait(0);
}

}  // namespace psicarve::supervisor::test

/// Stands before the C library's.
extern "C" int fsync(int file) {
    using namespace psicarve::supervisor::test;
    ++waiting_syncs;
    waiting_syncs.notify_all();
    is_slow.wait(true);
    --waiting_syncs;
    return static_cast<int>(syscall(SYS_fsync, file));
}
