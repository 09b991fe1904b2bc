// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/replay.hpp"

namespace psicarve::supervisor {
namespace {

/// One gap after the other, each as long as they were on an average: none so long as to be an alarm, which
/// only a gap by itself was.
void miss_ticks(const ReplayStep& step, cycle::Cycle& cycle) noexcept {
    std::uint64_t left = step.value;
    for (std::uint64_t gaps = step.gap_count; gaps > 0 && left > 0; --gaps) {
        const std::uint64_t ticks = left / gaps;
        if (ticks > 0) cycle.advance_missed(ticks);
        left -= ticks;
    }
}

}  // namespace

JobDirector::Progress JobDirector::poll(Supervisor& supervisor) {
    const cycle::Sample& sample = supervisor.sample();
    if (sample.state == MachineState::alarm) return Progress::alarm;
    switch (stage_) {
        case Stage::wait_for_job:
            if (sample.job_generation == 0 || sample.state != MachineState::ready) break;
            if (supervisor.request(cycle::RequestKind::start)) stage_ = Stage::starting;
            break;
        case Stage::starting:
            if (sample.state != MachineState::waiting) break;
            if (supervisor.request(cycle::RequestKind::start_interpolation)) stage_ = Stage::carving;
            break;
        case Stage::carving:
            if (sample.state != MachineState::ready || sample.job_end_tick == 0) break;
            stage_ = Stage::ended;
            return Progress::done;
        case Stage::ended:
            return Progress::done;
    }
    return Progress::going_on;
}

void RecordDirector::begin(std::uint64_t next_tick) noexcept {
    origin_tick_ = next_tick;
    has_begun_ = true;
}

void RecordDirector::before_tick(std::uint64_t next_tick, CoreParts& parts) noexcept {
    if (!has_begun_) return;
    while (next_step_ < script_.steps.size() && script_.steps[next_step_].tick + origin_tick_ <= next_tick) {
        apply(script_.steps[next_step_], parts);
        ++next_step_;
    }
}

void RecordDirector::apply(const ReplayStep& step, CoreParts& parts) noexcept {
    switch (step.kind) {
        case ReplayStep::Kind::request: {
            if (step.request == cycle::RequestKind::fail) {
                parts.io->urgent.failures.fetch_or(cycle::failure_bits(static_cast<AlarmCause>(step.value)));
                break;
            }
            cycle::Request request{};
            request.kind = step.request;
            request.axis = step.axis;
            request.value = step.value;
            request.order = step.order;
            request.order.drops_turns = step.request == cycle::RequestKind::move ? 1 : 0;
            parts.io->replayed_requests.push(request);
            break;
        }
        case ReplayStep::Kind::gap:
            miss_ticks(step, *parts.cycle);
            break;
        case ReplayStep::Kind::stop:
            parts.io->urgent.stop_requests.fetch_add(1);
            break;
        case ReplayStep::Kind::emergency_stop:
            parts.io->urgent.estop_requests.fetch_add(1);
            break;
        case ReplayStep::Kind::inputs:
            parts.recorded_inputs->show_inputs(step.inputs);
            break;
    }
}

}  // namespace psicarve::supervisor
