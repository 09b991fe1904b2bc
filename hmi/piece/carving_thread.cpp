// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/carving_thread.hpp"

#include <utility>

namespace psicarve::piece {
namespace {

constexpr std::size_t kBatch = 1024;
constexpr std::size_t kMostWaiting = 16;

}  // namespace

CarvingThread::~CarvingThread() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock{mutex_};
        is_dropped_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void CarvingThread::settle(const verify::Positions& positions, bool spindle_on) {
    told_.push_back({positions, spindle_on});
    if (told_.size() == kBatch) hand_over();
}

void CarvingThread::hand_over() {
    {
        std::unique_lock lock{mutex_};
        wake_.wait(lock, [this] { return waiting_.size() < kMostWaiting; });
        waiting_.push_back(std::exchange(told_, {}));
    }
    wake_.notify_all();
    told_.reserve(kBatch);
    if (!thread_.joinable()) thread_ = std::thread([this] { carve(); });
}

void CarvingThread::finish() {
    hand_over();
    {
        const std::lock_guard lock{mutex_};
        is_told_all_ = true;
    }
    wake_.notify_all();
    thread_.join();
    carver_.finish();
}

void CarvingThread::carve() {
    std::unique_lock lock{mutex_};
    while (true) {
        wake_.wait(lock, [this] { return is_dropped_ || is_told_all_ || !waiting_.empty(); });
        if (is_dropped_ || waiting_.empty()) return;
        const Batch batch = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        wake_.notify_all();
        for (const Instant& instant : batch) carver_.settle(instant.positions, instant.spindle_on);
        lock.lock();
    }
}

}  // namespace psicarve::piece
