// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_offsets.hpp"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::cli {
namespace {

/// Who sets offsets by hand has the lock no longer than that.
constexpr std::chrono::milliseconds kOffsetsHoldLimit{2000};

Result<offsets::Offsets> told(Result<offsets::Settled> settled) {
    if (!settled) return settled.error();
    if (!settled->warning.empty()) print_warning(settled->warning);
    return std::move(settled->offsets);
}

Error not_to_be_kept(const Error& why) {
    return Error{ErrorCode::machine_refused,
                 why.message +
                     "; nothing has moved. What a program sets could not be kept: make room or give "
                     "the rights, or keep none with PSICARVE_STATE="};
}

}  // namespace

Result<offsets::OffsetsPlace> offsets_place(const CommonOptions& common) {
    const auto of_machine = offsets::OffsetsPlace::of(common.segment, false);
    auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link && link.error().code == ErrorCode::no_core) return of_machine;
    if (!link) return link.error();
    if (!link->core_pid()) return of_machine;
    // One of the living core: the last one may be that of a core before it.
    const auto status = link->status();
    if (status) return offsets::OffsetsPlace::of(common.segment, status->is_simulator != 0);
    if (!link->core_pid()) return of_machine;
    return status.error();
}

offsets::OffsetsOwner offsets_owner(const CommonOptions& common) {
    return {common.segment, common.group};
}

Result<offsets::Offsets> kept_offsets(const CommonOptions& common, const Profile& profile) {
    const auto place = offsets_place(common);
    if (!place) return place.error();
    return told(offsets::settled_offsets(*place, profile.gcode, offsets_owner(common)));
}

Result<RunOffsets> RunOffsets::read(const CommonOptions& common, const Profile& profile, bool keeps) {
    auto place = offsets_place(common);
    if (!place) return place.error();
    RunOffsets made{std::move(*place), offsets_owner(common), profile, keeps};
    if (const auto read = made.read_again(); !read) return read.error();
    return made;
}

Result<void> RunOffsets::read_again() {
    auto read = told(offsets::settled_offsets(place_, letters_, owner_));
    if (!read) return read.error();
    begin_ = std::move(*read);
    return {};
}

void RunOffsets::tell_begin() const {
    if (begin_.kept == gcode::KeptOffsets{}) return;
    print_note("begins in " + std::string{gcode::kSystemNames[0]} + " with the work offsets of " +
               place_.path);
}

Result<void> RunOffsets::hold() {
    if (!keeps_ || !place_.is_kept()) return {};
    auto lock = offsets::OffsetsLock::take(place_, kOffsetsHoldLimit);
    if (!lock && lock.error().code == ErrorCode::machine_refused) return lock.error();
    if (!lock) return not_to_be_kept(lock.error());
    if (const auto writable = check_writable(place_.path); !writable) return not_to_be_kept(writable.error());
    // A program that begins ends what its core knows of the one before.
    const auto now = told(offsets::settle_offsets(place_, letters_, owner_, *lock));
    if (!now) return now.error();
    if (now->pending || now->kept != begin_.kept)
        return Error{ErrorCode::machine_refused,
                     "the work offsets were changed while the program was checked; nothing has moved, "
                     "run it again"};
    begin_ = *now;
    lock_.emplace(std::move(*lock));
    return {};
}

void RunOffsets::promise(const gcode::KeptOffsets& left, const Segment& segment, std::uint64_t program) {
    if (!lock_ || left == begin_.kept) return;
    offsets::Offsets promised = begin_;
    promised.pending = offsets::Pending{offsets::identity_of(segment, program), left};
    // Where it cannot be written, that is told at the end.
    has_promised_ = offsets::write_offsets(place_, promised, letters_).has_value();
}

Result<void> RunOffsets::finish(const gcode::KeptOffsets& left, bool is_in_order, const Segment& segment,
                                std::uint64_t program) {
    if (!lock_ || left == begin_.kept) return {};
    const auto lock = std::exchange(lock_, std::nullopt);
    if (is_in_order) {
        auto kept = offsets::write_offsets(place_, {left, {}}, letters_);
        if (!kept)
            return Error{ErrorCode::machine_refused,
                         kept.error().message + "; the program has ended, its work offsets are not kept"};
        return {};
    }
    if (has_promised_) {
        // A process that no longer waits leaves it to the next one to see how it ends.
        const auto fate = offsets::fate_of(segment, offsets::identity_of(segment, program));
        if (fate && *fate == offsets::ProgramFate::running) return {};
        if (const auto dropped = offsets::write_offsets(place_, begin_, letters_); !dropped)
            print_warning(dropped.error().message);
    }
    print_note("its work offsets are not kept: it did not end");
    return {};
}

void RunOffsets::write_beside(const std::string& trace_path) const {
    std::error_code none;
    if (trace_path.empty() || !std::filesystem::is_regular_file(trace_path, none)) return;
    offsets::OffsetsPlace beside;
    beside.path = offsets::path_beside_trace(trace_path);
    if (const auto written = offsets::write_offsets(beside, {begin_.kept, {}, made_with_}, letters_);
        !written)
        print_warning(written.error().message);
}

}  // namespace psicarve::cli
