// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/tick_threads.hpp"

#include <algorithm>
#include <mutex>

#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/realtime/clock.hpp"

namespace psicarve::supervisor {
namespace {

void before_tick(CoreParts& parts, RecordDirector* record, TickThreads& threads,
                 std::uint64_t missed) noexcept {
    if (missed > 0) parts.cycle->advance_missed(missed);
    // Of a pause at rest the tick itself takes no notice: what it had written, the spindle's bit too, stands
    // no more.
    if (parts.guard != nullptr && parts.guard->guard_has_acted())
        parts.io->urgent.failures.fetch_or(cycle::failure_bits(AlarmCause::tick_gap));
    if (record == nullptr) return;
    const std::uint64_t next_tick = parts.cycle->next_tick();
    if (!record->has_begun() && threads.record_may_begin.load()) record->begin(next_tick);
    record->before_tick(next_tick, parts);
    if (record->is_over(next_tick)) threads.record_is_over.store(true);
}

/// The timer of inputs and pulses. A pulse over ticks ends between two of its turns:
///
///     |take, step ... sleep ... |end .................. |take, step
///     |<---- step_high_ns ----->|<--- step_low_ns --->  |
class IoTimer {
public:
    IoTimer(CoreParts& parts, TickThreads& threads)
        : parts_(&parts), mutex_(&threads.cycle_mutex), low_ns_(parts.profile.port.step_low_ns) {
        const cycle::CycleConfig config = plan::cycle_config_from_profile(parts.profile);
        high_ns_ = config.step_high_ticks * config.period_ns;
        least_high_ns_ = parts.profile.port.step_high_ns;
        period_ns_ = config.io_ticks * config.period_ns;
    }
    std::int64_t period_ns() const noexcept { return period_ns_; }

    template <typename Before>
    void turn(std::int64_t deadline_ns, Before&& before) noexcept {
        bool must_end_pulses = false;
        std::int64_t begun_ns = 0;
        {
            const std::scoped_lock lock(*mutex_);
            before();
            parts_->cycle->take_inputs_and_step();
            must_end_pulses = parts_->cycle->has_pulses_to_end();
            begun_ns = clock_.now_ns();
        }
        if (!must_end_pulses) return;
        clock_.sleep_until_ns(std::max(deadline_ns + high_ns_, begun_ns + least_high_ns_));
        std::int64_t ended_ns = 0;
        {
            const std::scoped_lock lock(*mutex_);
            parts_->cycle->end_pulses();
            ended_ns = clock_.now_ns();
        }
        // So late that the next turn would cut the gap short.
        if (ended_ns + low_ns_ > deadline_ns + period_ns_) clock_.sleep_until_ns(ended_ns + low_ns_);
    }

private:
    CoreParts* parts_;
    rtcore::PriorityMutex* mutex_;
    rtcore::RealClock clock_;
    std::int64_t low_ns_;
    std::int64_t high_ns_ = 0;
    std::int64_t least_high_ns_ = 0;
    std::int64_t period_ns_ = 0;
};

}  // namespace

void run_ticks(CoreParts& parts, RecordDirector* record, TickThreads& threads) noexcept {
    rtcore::RealClock clock;
    const bool has_two_timers = parts.profile.tick.schedule == Schedule::two_timer;
    IoTimer timer{parts, threads};
    const rtcore::PeriodicOptions options{
        .period_ns = has_two_timers ? timer.period_ns() : parts.period_ns,
    };
    guard::GuardLink* const guard = parts.guard.get();
    if (guard != nullptr) guard->set_ticking(true);
    rtcore::run_periodic(clock, options, threads.stats, [&](const rtcore::PeriodicTick& tick) noexcept {
        const auto before = [&] { before_tick(parts, record, threads, tick.missed_before); };
        if (has_two_timers) {
            timer.turn(tick.deadline_ns, before);
        } else {
            before();
            parts.cycle->tick();
        }
        if (guard != nullptr) guard->note_tick();
        return !threads.must_end.load(std::memory_order_relaxed);
    });
    if (guard != nullptr) guard->set_ticking(false);
    const std::scoped_lock lock(threads.cycle_mutex);
    parts.cycle->shut_down();
}

void run_interpolation(CoreParts& parts, TickThreads& threads) noexcept {
    rtcore::RealClock clock;
    const rtcore::PeriodicOptions options{
        .period_ns = plan::cycle_config_from_profile(parts.profile).interpolation_ns()};
    rtcore::run_periodic(clock, options, threads.interpolation_stats,
                         [&](const rtcore::PeriodicTick& tick) noexcept {
                             const std::scoped_lock lock(threads.cycle_mutex);
                             if (tick.missed_before > 0)
                                 parts.cycle->advance_missed_interpolation(tick.missed_before);
                             parts.cycle->interpolate();
                             return !threads.must_end.load(std::memory_order_relaxed);
                         });
}

}  // namespace psicarve::supervisor
