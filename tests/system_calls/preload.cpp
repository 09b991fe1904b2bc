// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded into a core. See tick_calls.hpp.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "tests/system_calls/call_filter.hpp"
#include "tests/system_calls/tick_calls.hpp"

namespace psicarve::system_calls {
namespace {

TickCalls* map_calls() {
    const char* const path = std::getenv(kCallsVariable);
    const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CLOEXEC);
    if (file < 0) return nullptr;
    void* const address =
        mmap(nullptr, sizeof(TickCalls), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, file, 0);
    close(file);
    return address == MAP_FAILED ? nullptr : static_cast<TickCalls*>(address);
}

TickCalls* const g_calls = map_calls();

void count(long number) noexcept {
    constexpr auto kLast = static_cast<long>(kMostNumbers) - 1;
    g_calls->by_number[static_cast<std::size_t>(std::clamp(number, 0L, kLast))].fetch_add(1);
}

void watch_once() {
    thread_local bool is_known = false;
    if (is_known || g_calls == nullptr) return;
    is_known = true;
    (watch_this_thread(count) ? g_calls->threads_watched : g_calls->threads_unwatched).fetch_add(1);
}

}  // namespace
}  // namespace psicarve::system_calls

extern "C" int clock_nanosleep(clockid_t clock, int flags, const timespec* until, timespec* left) {
    using Sleep = int (*)(clockid_t, int, const timespec*, timespec*);
    static const auto next = reinterpret_cast<Sleep>(dlsym(RTLD_NEXT, "clock_nanosleep"));
    if ((flags & TIMER_ABSTIME) != 0) psicarve::system_calls::watch_once();
    return next(clock, flags, until, left);
}
