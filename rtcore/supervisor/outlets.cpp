// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/outlets.hpp"

#include <chrono>
#include <utility>

#include "rtcore/process/words.hpp"
#include "rtcore/supervisor/end_request.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::milliseconds kOutletLook{20};
constexpr std::chrono::seconds kStandstill{2};   ///< so long nothing was taken
constexpr std::chrono::seconds kLongestEnd{10};  ///< on the real clock

void say_errors(CoreParts& parts) {
    for (std::string& line : parts.traces.take_errors()) say_later(parts, std::move(line));
}

/// Asks until it is done, as long as what is written is still taken.
template <typename Done>
bool wait_while_taken(CoreParts& parts, std::chrono::seconds longest, Done&& is_done) {
    using Clock = std::chrono::steady_clock;
    // What is in a writer's buffer is in no ring any more.
    const auto reached_now = [&] {
        return std::pair{parts.trace_ring->size() + parts.traces.left(), parts.traces.written_bytes()};
    };
    const auto begun = Clock::now();
    auto last_progress = begun;
    auto reached = reached_now();
    while (!is_done()) {
        const auto now = Clock::now();
        if (const auto before = std::exchange(reached, reached_now()); reached != before) last_progress = now;
        if (now - last_progress > kStandstill || now - begun > longest) return false;
    }
    return true;
}

/// On the virtual clock: without end, but for orders to end.
template <typename Done>
bool wait_for_reader(CoreParts& parts, Done&& is_done) {
    while (EndRequest::orders() == 0) {
        if (is_done()) return true;
    }
    return wait_while_taken(parts, std::chrono::hours{1}, is_done);
}

}  // namespace

void say_later(CoreParts& parts, std::string line) {
    parts.words.do_later([said = std::move(line)] { rtcore::say(said); });
}

void move_traces(CoreParts& parts) {
    parts.traces.drain(*parts.trace_ring);
    say_errors(parts);
}

void finish_traces_in_time(CoreParts& parts) {
    move_traces(parts);
    parts.traces.finish(parts.cycle->next_tick(), parts.cycle->sample().trace_lost);
    const auto is_done = [&] { return parts.traces.wait_until_finished(kOutletLook); };
    if (!wait_while_taken(parts, kLongestEnd, is_done)) parts.traces.give_up();
    say_errors(parts);
}

void finish_whole_traces(CoreParts& parts) {
    move_traces(parts);
    const auto is_drained = [&] {
        if (parts.trace_ring->size() == 0) return true;
        parts.traces.wait_until_finished(kOutletLook);  // not yet: a pause
        move_traces(parts);
        return parts.trace_ring->size() == 0;
    };
    wait_for_reader(parts, is_drained);
    parts.traces.finish(parts.cycle->next_tick(), parts.trace_ring->size());
    const auto is_done = [&] { return parts.traces.wait_until_finished(kOutletLook); };
    if (!wait_for_reader(parts, is_done)) parts.traces.give_up();
    say_errors(parts);
}

}  // namespace psicarve::supervisor
