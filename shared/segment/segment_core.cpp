// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <string>
#include <thread>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/robust_mutex.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/segment_commands.hpp"
#include "shared/segment/segment_mapping.hpp"
#include "shared/segment/segment_program.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve {

Result<void> Segment::claim_core() {
    if (auto taken = take_core_lock(); !taken) return taken;
    sign_core();
    return {};
}

Result<void> Segment::take_core_lock() {
    if (!mapping_->object.try_lock(LockByte::core)) {
        const std::uint32_t first = core_pid().value_or(0);
        const std::string who = first == 0 ? "a core that is just starting or ending has it"
                                           : "a core serves it already (pid " + std::to_string(first) + ")";
        return Error{ErrorCode::machine_refused,
                     "segment " + name() + ": " + who + ": end that one, or choose another --segment"};
    }
    mapping_->core_owner_pid = own_pid();
    SegmentHeader& shared = header();
    if (auto whole = RobustMutex::make_whole(shared.mutex); !whole) return whole;
    shared.core.pid.store(0);
    shared.core.keeping.store(0);
    shared.core_profile_hash.store(0);
    write_record(shared.port, PortName{});
    write_record(shared.verdict, JobVerdict{});
    write_record(shared.status, CoreStatus{});
    begin_ring_anew(shared.increments);
    begin_ring_anew(shared.recorder);
    begin_ring_anew(shared.recording);
    shared.recording_lease.store(0);
    clear_commands_of_dead_core(shared);
    clear_program_of_dead_core(shared);
    return {};
}

// After everything was cleared: a sender that sees the new core may send to it, and its commands are not
// taken for commands to the core before.
void Segment::sign_core() noexcept {
    SegmentHeader& shared = header();
    shared.core.start_time.store(process_start_time(own_pid()));
    shared.core.pid.store(own_pid());
}

void Segment::release_core() noexcept {
    // A forked child has our lock, but must not release it.
    if (mapping_->core_owner_pid != own_pid()) return;
    header().core.pid.store(0);
    mapping_->object.unlock(LockByte::core);
    mapping_->core_owner_pid = 0;
}

std::optional<CoreGlance> Segment::glance_at_core() const noexcept {
    if (mapping_->core_owner_pid != 0) return CoreGlance{mapping_->core_owner_pid, true};
    if (!mapping_->object.is_locked_by_another(LockByte::core)) return std::nullopt;
    const std::uint32_t pid = header().core.pid.load();
    return CoreGlance{pid, is_process_alive(pid, header().core.start_time.load())};
}

std::optional<std::uint32_t> Segment::core_pid() const noexcept {
    const auto deadline = std::chrono::steady_clock::now() + kSigningLimit;
    while (const auto core = glance_at_core()) {
        if (core->is_signed || std::chrono::steady_clock::now() >= deadline) return core->pid;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return std::nullopt;
}

CoreKeeping Segment::core_keeping() const noexcept {
    const auto core = glance_at_core();
    return core && core->is_signed ? CoreKeeping::unpack(header().core.keeping.load()) : CoreKeeping{};
}

}  // namespace psicarve
