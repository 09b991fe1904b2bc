// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into a program, it sets the clock of the wall forth and back with every reading. Clocks that count
// from the machine's start go on as they do; but once the file that PSICARVE_SUSPENDED names is there, the
// computer has slept for an hour in between. While the file that PSICARVE_HELD_SUPERVISOR names is there, the
// thread that asks how long the computer slept (the supervisor) stands still; PSICARVE_HELD_READ: a thread
// that reads more than a page of a file, such as a job; PSICARVE_HELD_WRITE: a thread that wants a file on
// its disk.
#include <dlfcn.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <ctime>

namespace {

constexpr time_t kDay_s = 24 * 60 * 60;

std::atomic<int> looks{0};

time_t shift_s() {
    const int look = looks.fetch_add(1);
    return look % 2 == 0 ? (look % 50) * kDay_s : -(look % 50) * kDay_s;
}

time_t slept_s() {
    static const char* const path = std::getenv("PSICARVE_SUSPENDED");
    constexpr time_t kHour_s = 60 * 60;
    return path != nullptr && access(path, F_OK) == 0 ? kHour_s : 0;
}

void wait_while_there(const char* path) {
    constexpr useconds_t kLook_us = 2000;
    while (path != nullptr && access(path, F_OK) == 0) usleep(kLook_us);
}

void hold_supervisor() {
    static const char* const path = std::getenv("PSICARVE_HELD_SUPERVISOR");
    wait_while_there(path);
}

void hold_read(size_t bytes) {
    static const char* const path = std::getenv("PSICARVE_HELD_READ");
    constexpr size_t kPage_bytes = 4096;
    if (bytes > kPage_bytes) wait_while_there(path);
}

void hold_write() {
    static const char* const path = std::getenv("PSICARVE_HELD_WRITE");
    wait_while_there(path);
}

template <typename Function>
Function next_of(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {
int clock_gettime(clockid_t clock, timespec* time) noexcept {
    static const auto next = next_of<int (*)(clockid_t, timespec*)>("clock_gettime");
    if (clock == CLOCK_BOOTTIME) hold_supervisor();
    const int result = next(clock, time);
    if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) time->tv_sec += shift_s();
    if (clock == CLOCK_BOOTTIME) time->tv_sec += slept_s();
    return result;
}
time_t time(time_t* out) noexcept {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (out != nullptr) *out = now.tv_sec;
    return now.tv_sec;
}
int gettimeofday(timeval* out, void* /*zone*/) noexcept {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    *out = {now.tv_sec, now.tv_nsec / 1000};
    return 0;
}
int fsync(int file) {
    static const auto next = next_of<int (*)(int)>("fsync");
    hold_write();
    return next(file);
}
ssize_t pread(int file, void* out, size_t bytes, off_t offset) {
    static const auto next = next_of<ssize_t (*)(int, void*, size_t, off_t)>("pread");
    hold_read(bytes);
    return next(file, out, bytes, offset);
}
}
