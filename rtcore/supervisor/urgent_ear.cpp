// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/urgent_ear.hpp"

#include <chrono>
#include <utility>

#include "rtcore/clock.hpp"
#include "rtcore/handler_stack.hpp"
#include "rtcore/promptness.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::microseconds kUsualInterval{2000};
constexpr std::chrono::microseconds kCrowdedInterval{40};
/// After the last crowd.
constexpr std::chrono::nanoseconds kCrowded{200'000'000};

/// Adds one to `asked` if `word` has changed since it was looked at last. What was seen is read first: a word
/// that is read later is no older, so of two who look one at most finds it changed.
bool hand_on(const AtomicWord32& word, std::atomic<std::uint32_t>& seen,
             std::atomic<std::uint32_t>& asked) noexcept {
    std::uint32_t before = seen.load();
    const std::uint32_t now = word.load();
    if (now == before || !seen.compare_exchange_strong(before, now)) return false;
    asked.fetch_add(1);
    return true;
}

}  // namespace

UrgentEar::Seen UrgentEar::as_they_stand(const Segment& segment) noexcept {
    return {.stops = segment.header().stop_requests.load(),
            .emergency_stops = segment.header().estop_requests.load()};
}

UrgentEar::UrgentEar(std::shared_ptr<Segment> segment, cycle::UrgentWords& urgent, Seen seen) noexcept
    : segment_(std::move(segment)),
      urgent_(&urgent),
      stops_seen_(seen.stops),
      emergency_stops_seen_(seen.emergency_stops) {}

UrgentEar::~UrgentEar() {
    if (!is_listening()) return;
    must_end_.store(true);
    thread_.join();
}

bool UrgentEar::look() noexcept {
    const bool has_emergency =
        hand_on(segment_->header().estop_requests, emergency_stops_seen_, urgent_->estop_requests);
    return hand_on(segment_->header().stop_requests, stops_seen_, urgent_->stop_requests) || has_emergency;
}

void UrgentEar::listen() {
    thread_ = std::thread{[this] { run(); }};
}

void UrgentEar::note_crowd() noexcept {
    crowded_until_ns_.store(rtcore::RealClock{}.now_ns() + kCrowded.count(), std::memory_order_relaxed);
}

void UrgentEar::run() noexcept {
    const rtcore::HandlerStack handler_stack;
    rtcore::Promptness promptness{true};
    promptness.raise();
    while (!must_end_.load()) {
        look();
        const bool is_crowded =
            rtcore::RealClock{}.now_ns() < crowded_until_ns_.load(std::memory_order_relaxed);
        std::this_thread::sleep_for(is_crowded ? kCrowdedInterval : kUsualInterval);
    }
}

}  // namespace psicarve::supervisor
