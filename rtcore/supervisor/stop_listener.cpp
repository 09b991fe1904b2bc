// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/stop_listener.hpp"

#include <chrono>
#include <utility>

#include "rtcore/process/handler_stack.hpp"
#include "rtcore/realtime/clock.hpp"
#include "rtcore/realtime/promptness.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::microseconds kUsualInterval{2000};
constexpr std::chrono::microseconds kCrowdedInterval{40};
/// After the last crowd.
constexpr std::chrono::nanoseconds kCrowded{200'000'000};

constexpr unsigned kNumberShift = 32;

/// Any change of `word` goes into `mirrored`, unless that is another segment's by now. What is mirrored is
/// read first: then the word that is read later is no older than it, and if another thread has mirrored it
/// meanwhile, both are read again. A thread that is kept between any two steps keeps no other from it.
bool mirror(const AtomicWord32& word, std::uint32_t number, std::uint32_t added,
            std::atomic<std::uint64_t>& mirrored) noexcept {
    std::uint64_t before = mirrored.load();
    while (before >> kNumberShift == number) {
        const std::uint32_t now = word.load() + added;
        if (now == static_cast<std::uint32_t>(before)) return false;
        if (mirrored.compare_exchange_weak(before, std::uint64_t{number} << kNumberShift | now)) return true;
    }
    return false;
}

/// From here on only the segment `number` is mirrored. What was mirrored last stays.
std::uint32_t renumber(std::atomic<std::uint64_t>& mirrored, std::uint32_t number) noexcept {
    std::uint64_t before = mirrored.load();
    std::uint32_t word = 0;
    do {
        word = static_cast<std::uint32_t>(before);
    } while (!mirrored.compare_exchange_weak(before, std::uint64_t{number} << kNumberShift | word));
    return word;
}

}  // namespace

StopListener::StopListener(std::shared_ptr<Segment> segment, cycle::UrgentWords& urgent) noexcept
    : urgent_(&urgent) {
    const StopsSeen so_far = stops_seen(*segment);
    source_.segment = std::move(segment);
    source_.added = {.stops = 0U - so_far.stops, .emergency_stops = 0U - so_far.emergency_stops};
}

StopListener::~StopListener() {
    if (!thread_.joinable()) return;
    must_end_.store(true);
    thread_.join();
}

bool StopListener::look_at(const Source& source, cycle::UrgentWords& urgent) noexcept {
    const SegmentHeader& header = source.segment->header();
    const bool has_emergency =
        mirror(header.estop_requests, source.number, source.added.emergency_stops, urgent.estop_word);
    return mirror(header.stop_requests, source.number, source.added.stops, urgent.stop_word) || has_emergency;
}

bool StopListener::look() noexcept {
    return look_at(source_, *urgent_);
}

void StopListener::listen() {
    thread_ = std::thread{[this, source = source_]() mutable { run(std::move(source)); }};
}

void StopListener::note_crowd() noexcept {
    crowded_until_ns_.store(rtcore::RealClock{}.now_ns() + kCrowded.count(), std::memory_order_relaxed);
}

void StopListener::turn_to(std::shared_ptr<Segment> segment) noexcept {
    // The last look at the old one: afterwards its words count no more.
    look();
    source_.segment = std::move(segment);
    ++source_.number;
    source_.added = {.stops = renumber(urgent_->stop_word, source_.number),
                     .emergency_stops = renumber(urgent_->estop_word, source_.number)};
    look();
    if (!thread_.joinable()) return;
    const std::lock_guard lock{next_mutex_};
    next_ = source_;
    next_number_.store(source_.number);
}

void StopListener::note_stops_seen(const ReceivedCommand& command, cycle::Request& request) noexcept {
    look();
    request.has_sender = 1;
    request.stops_seen = command.stops_seen.stops + source_.added.stops;
    request.emergency_stops_seen = command.stops_seen.emergency_stops + source_.added.emergency_stops;
}

void StopListener::run(Source source) noexcept {
    const rtcore::HandlerStack handler_stack;
    rtcore::Promptness promptness{true};
    promptness.raise();
    while (!must_end_.load()) {
        if (next_number_.load() != source.number) {
            // The lock's holder is an ordinary thread, and may be kept: then it is the next look's.
            const std::unique_lock lock{next_mutex_, std::try_to_lock};
            if (lock.owns_lock()) source = std::move(next_);
        }
        look_at(source, *urgent_);
        const bool is_crowded =
            rtcore::RealClock{}.now_ns() < crowded_until_ns_.load(std::memory_order_relaxed);
        std::this_thread::sleep_for(is_crowded ? kCrowdedInterval : kUsualInterval);
    }
}

}  // namespace psicarve::supervisor
