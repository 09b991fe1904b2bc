// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/planner.hpp"

#include <utility>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/carving.hpp"
#include "rtcore/plan/homing.hpp"
#include "rtcore/plan/move.hpp"
#include "rtcore/plan/record_program.hpp"
#include "rtcore/plan/stepped_program.hpp"

namespace psicarve::plan {

using cycle::MotionBlock;
using cycle::PlanKind;
using cycle::PlanRequest;

Planner::Planner(const Profile& profile, cycle::CycleIo& io) : limits_(machine_limits(profile)), io_(&io) {}

void Planner::set_job(std::shared_ptr<const JobView> job, std::uint64_t generation) {
    reference_seconds_.store(-1.0, std::memory_order_relaxed);
    const double blank_radius_mm = job != nullptr ? limits_for({}, *job).blank_radius_mm : 0.0;
    KnownJob forgotten{std::move(job), generation, blank_radius_mm};
    const std::lock_guard<std::mutex> lock(job_mutex_);
    std::swap(known_[0], known_[1]);
    std::swap(known_[0], forgotten);
}

Planner::KnownJob Planner::known(std::uint64_t generation) {
    const std::lock_guard<std::mutex> lock(job_mutex_);
    for (const KnownJob& job : known_) {
        if (job.job != nullptr && job.generation == generation) return job;
    }
    return {};
}

void Planner::set_source(std::shared_ptr<StepSource> source, std::uint64_t program) {
    // Destroyed after the lock is given back.
    KnownSource forgotten{std::move(source), program};
    const std::lock_guard<std::mutex> lock(job_mutex_);
    std::swap(known_source_, forgotten);
}

std::unique_ptr<Program> Planner::program_of_records(const PlanRequest& request) {
    std::shared_ptr<StepSource> source;
    {
        const std::lock_guard<std::mutex> lock(job_mutex_);
        if (known_source_.program == request.program) source = std::exchange(known_source_.source, nullptr);
    }
    if (source == nullptr) return nullptr;
    source->begin(request.position_pulses);
    return std::make_unique<RecordProgram>(limits_, std::move(source), request.position_pulses,
                                           request.is_single != 0);
}

bool Planner::wants_poll() const noexcept {
    if (io_->plan_requests.size() > 0) return true;
    return program_ != nullptr && io_->blocks.size() <= cycle::kGroupStartBlocks;
}

void Planner::poll(const std::function<bool()>& has_time) {
    take_requests();
    while (program_ != nullptr) {
        if (!has_pending_) has_pending_ = program_->next(pending_);
        if (!has_pending_ && program_->is_waiting()) return;
        if (!has_pending_) {
            if (const PlannedSoFar all = program_->planned(); all.is_reference) {
                reference_seconds_.store(all.seconds, std::memory_order_relaxed);
            }
            program_.reset();
            return;
        }
        pending_.epoch = epoch_;
        if (!io_->blocks.push(pending_)) return;
        has_pending_ = false;
        if (has_time && !has_time()) return;
    }
}

void Planner::take_requests() {
    PlanRequest request{};
    bool has_request = false;
    // Every one but the newest has been overtaken: its epoch is gone. But a job is fixed by its approach.
    while (io_->plan_requests.pop_into(request)) {
        has_request = true;
        if (request.kind != PlanKind::position) continue;
        KnownJob asked_for = known(request.job_generation);
        job_ = std::move(asked_for.job);
        limits_.blank_radius_mm = asked_for.blank_radius_mm;
    }
    if (!has_request) return;
    epoch_ = request.epoch;
    has_pending_ = false;
    program_ = program_for(request);
}

std::unique_ptr<Program> Planner::program_for(const PlanRequest& request) {
    const auto first_layer = static_cast<std::uint32_t>(request.first_layer);
    const auto first_step = static_cast<std::uint32_t>(request.first_step);
    const auto list = [](std::vector<MotionBlock> blocks) {
        return std::make_unique<ListProgram>(std::move(blocks));
    };
    points_total_.store(0, std::memory_order_relaxed);
    switch (request.kind) {
        case PlanKind::home:
            return list(homing_blocks(limits_, request.axis));
        case PlanKind::reset_height:
            return list(reset_height_blocks(limits_));
        case PlanKind::finish:
            return list(finish_blocks(limits_, request.position_pulses));
        case PlanKind::back_off:
            return list(back_off_blocks(limits_, static_cast<Axis>(request.axis)));
        case PlanKind::move:
            if (request.order.shape != cycle::OrderShape::straight) {
                return std::make_unique<SteppedProgram>(limits_, request.order, request.position_pulses);
            }
            return list(move_blocks(limits_, request.order, request.position_pulses));
        case PlanKind::position:
            if (job_ == nullptr) return nullptr;
            return list((request.is_dry != 0 ? dry_approach_blocks : approach_blocks)(
                limits_, *job_, request.position_pulses, first_layer, first_step));
        case PlanKind::program:
            return program_of_records(request);
        case PlanKind::carve:
            break;
    }
    if (job_ == nullptr) return nullptr;
    reference_seconds_.store(-1.0, std::memory_order_relaxed);
    const LayerSpan layers{first_layer, static_cast<std::uint32_t>(request.end_layer), first_step};
    points_total_.store(std::uint64_t{layers.end} * job_->point_count(), std::memory_order_relaxed);
    return carving_of(limits_, job_, layers);
}

}  // namespace psicarve::plan
