// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/forget_piece.hpp"

#include <chrono>
#include <optional>
#include <thread>

#include "hmi/machine/machine_link.hpp"
#include "shared/saved_checkpoint.hpp"
#include "shared/shared_record.hpp"

namespace psicarve::machine {
namespace {

constexpr std::chrono::seconds kForgettingLimit{5};
constexpr std::chrono::milliseconds kForgettingLook{20};

Error still_there(const FoundCheckpoint& found) {
    return Error{ErrorCode::machine_refused,
                 found.path + ": is still there; see what psicarve-rtcore says, and remove it"};
}

bool is_still_there(const FoundCheckpoint& found) {
    const auto standing = load_saved_checkpoint(found.path);
    return standing && standing->name() == found.saved.name();
}

/// The record on the disk, or what the segment alone knows. Nothing: there is none.
std::optional<RecordName> record_of(MachineLink& link, const std::optional<FoundCheckpoint>& found,
                                    bool is_simulator) {
    if (found) return found->saved.name();
    const auto checkpoint = link.checkpoint();
    if (!checkpoint || !is_checkpoint(*checkpoint)) return std::nullopt;
    return RecordName{link.segment_name(), is_simulator, checkpoint->job_checksum, 0};
}

/// The core's thread takes the file away, or says why it cannot.
Result<void> forget_by_core(MachineLink& link, const std::string& folder) {
    const auto status = link.last_status();
    const bool is_simulator = status && status->is_simulator != 0;
    const auto found =
        find_unfinished(link.segment_name(), is_simulator, folder, link.segment().core_keeping());
    const auto record = record_of(link, found, is_simulator);
    // That the machine is not at rest comes before that there is none.
    // Nor does this core know another folder's records: it only says whether one may be forgotten.
    const bool is_elsewhere = found && found->keeper == Keeper::other_core;
    const bool is_asked_only = !record || (is_elsewhere && link.segment().core_keeping().is_somewhere());
    const RecordName asked = is_asked_only ? RecordName{} : *record;
    if (auto sent = link.send(command_to_forget(asked)); !sent) return sent.error();
    if (!record) return bad_input("no unfinished piece is known of segment " + link.segment_name());
    if (!found) return {};
    if (is_elsewhere) return psicarve::forget_piece(*found);
    const auto give_up = std::chrono::steady_clock::now() + kForgettingLimit;
    while (is_still_there(*found)) {
        if (std::chrono::steady_clock::now() >= give_up) return still_there(*found);
        std::this_thread::sleep_for(kForgettingLook);
    }
    return {};
}

/// As a core would, for as long as it takes: none can begin meanwhile.
Result<void> clear_record(MachineLink& link) {
    if (auto locked = link.segment().take_core_lock(); !locked) return locked.error();
    write_record(link.segment().header().checkpoint, Checkpoint{});
    link.segment().release_core();
    return {};
}

}  // namespace

Result<void> forget_piece(const std::string& segment_name, const std::string& group,
                          const std::string& folder) {
    auto link = MachineLink::attach(segment_name, group);
    if (link && link->core_pid()) return forget_by_core(*link, folder);
    if (!link && link.error().code != ErrorCode::no_core) return link.error();
    const bool is_in_segment = link && link->checkpoint();
    const auto found = find_unfinished(segment_name, {}, folder);
    if (!found && !is_in_segment) return bad_input("no unfinished piece is known of segment " + segment_name);
    if (is_in_segment) {
        if (auto cleared = clear_record(*link); !cleared) return cleared.error();
    }
    return found ? psicarve::forget_piece(*found) : Result<void>{};
}

}  // namespace psicarve::machine
