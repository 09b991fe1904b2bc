// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/pending_saves.hpp"

#include <pthread.h>
#include <time.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace psicarve::session {
namespace {

constexpr std::int64_t kNanoseconds = 1'000'000'000;
/// Threshold for the whole process, which always uses a little.
constexpr std::int64_t kProcessStep_ns = 5'000'000;

std::int64_t used_ns(clockid_t clock) {
    timespec used{};
    if (::clock_gettime(clock, &used) != 0) return 0;
    return static_cast<std::int64_t>(used.tv_sec) * kNanoseconds + used.tv_nsec;
}

std::optional<clockid_t> clock_of_this_thread() {
    clockid_t clock{};
    if (::pthread_getcpuclockid(::pthread_self(), &clock) != 0) return std::nullopt;
    return clock;
}

}  // namespace

struct PendingSaves::Book {
    struct Line {
        std::string path;
        std::optional<clockid_t> clock;  ///< none: it waits
    };
    std::mutex mutex;
    std::uint64_t last = 0;
    std::map<std::uint64_t, Line> lines;

    std::uint64_t add(const std::string& path, std::optional<clockid_t> clock) {
        const std::lock_guard lock{mutex};
        lines[++last] = {path, clock};
        return last;
    }
    void set_clock(std::uint64_t number, std::optional<clockid_t> clock) {
        const std::lock_guard lock{mutex};
        lines[number].clock = clock;
    }
    void remove(std::uint64_t number) {
        const std::lock_guard lock{mutex};
        lines.erase(number);
    }
};

PendingSaves::PendingSaves() : book_(std::make_shared<Book>()) {}

BackgroundQueue::Task PendingSaves::noted(const std::string& path, BackgroundQueue::Task task) {
    const std::uint64_t number = book_->add(path, std::nullopt);
    const std::shared_ptr<void> entry{nullptr,
                                      [book = book_, number](std::nullptr_t) { book->remove(number); }};
    return [book = book_, number, entry, task = std::move(task)] {
        book->set_clock(number, clock_of_this_thread());
        BackgroundQueue::Finish finish = task();
        book->set_clock(number, std::nullopt);  // the thread may end before the task is gone
        return finish;
    };
}

PendingSaves::Entry PendingSaves::begin(const std::string& path) {
    const std::uint64_t number = book_->add(path, CLOCK_PROCESS_CPUTIME_ID);
    return {nullptr, [book = book_, number](std::nullptr_t) { book->remove(number); }};
}

std::vector<SaveUnderWay> PendingSaves::under_way() const {
    std::vector<SaveUnderWay> saves;
    const std::lock_guard lock{book_->mutex};
    for (const auto& [number, line] : book_->lines) {
        const bool is_process = line.clock == CLOCK_PROCESS_CPUTIME_ID;
        const std::int64_t used = line.clock ? used_ns(*line.clock) : 0;
        saves.push_back({number, line.path, is_process ? used / kProcessStep_ns : used});
    }
    return saves;
}

}  // namespace psicarve::session
