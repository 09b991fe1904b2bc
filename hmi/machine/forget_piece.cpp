// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/forget_piece.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "hmi/machine/machine_link.hpp"
#include "shared/file/state_place.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/shared_record.hpp"

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

/// The record that a caller may mean. Empty: there is none.
struct ForgetChoice {
    std::optional<RecordName> record;
    ForgottenPiece piece;
    std::optional<FoundCheckpoint> file;  ///< the file to be removed; nothing: only the segment knows the
                                          ///< piece
};

/// A caller that has seen a record may not know its place on a disk.
bool is_wanted(const RecordName& record, const std::optional<RecordName>& wanted) {
    return !wanted ||
           (record.is_simulator == wanted->is_simulator && record.job_checksum == wanted->job_checksum &&
            (record.sequence == wanted->sequence || record.sequence == 0 || wanted->sequence == 0));
}

/// The segment's record, which its core uses, comes before a disk's: that may be another core's.
ForgetChoice choose(const std::string& segment, const std::optional<Checkpoint>& checkpoint,
                    const std::optional<FoundCheckpoint>& found, const std::optional<RecordName>& wanted) {
    if (checkpoint && is_checkpoint(*checkpoint) && is_unfinished(*checkpoint)) {
        const RecordName own{segment, checkpoint->is_simulated(), checkpoint->job_checksum, 0};
        const bool is_on_disk =
            found && found->keeper != Keeper::other_core && is_wanted(found->saved.name(), own);
        const RecordName record = is_on_disk ? found->saved.name() : own;
        if (is_wanted(record, wanted)) {
            return {record,
                    {*checkpoint, is_on_disk ? found->saved.source_name : "", is_on_disk ? found->path : ""},
                    is_on_disk ? found : std::nullopt};
        }
    }
    if (!found || !is_wanted(found->saved.name(), wanted)) return {};
    return {found->saved.name(), {found->saved.checkpoint, found->saved.source_name, found->path}, found};
}

Error none_to_forget(const std::string& segment, bool is_another_there) {
    if (is_another_there) {
        return Error{ErrorCode::machine_refused,
                     "another unfinished piece has come into its place; it is left"};
    }
    return bad_input("no unfinished piece is known of segment " + segment);
}

/// The core keeps it in a folder that was not searched.
bool is_kept_elsewhere(const CoreKeeping& core, const std::string& folder) {
    if (!core.is_somewhere()) return false;
    const auto folders = folder.empty() ? state_folders_to_read() : std::vector<std::string>{folder};
    return std::ranges::none_of(folders, [&](const std::string& each) { return core.is_in(each); });
}

/// The core's thread removes the file, or says why it cannot.
Result<ForgottenPiece> forget_by_core(MachineLink& link, const std::string& folder,
                                      const std::optional<RecordName>& wanted) {
    const auto status = link.last_status();
    const bool is_simulator = status && status->is_simulator != 0;
    const CoreKeeping core = link.segment().core_keeping();
    const auto found = find_unfinished(link.segment_name(), is_simulator, folder, core);
    const auto checkpoint = link.checkpoint();
    const auto chosen = choose(link.segment_name(), checkpoint, found, wanted);
    const bool is_others = chosen.file && chosen.file->keeper == Keeper::other_core;
    const bool is_hidden = !is_others && is_kept_elsewhere(core, folder);
    // Report first that the machine is not at rest, then that there is no record. The core does not know
    // another folder's records either: it only says whether one may be forgotten.
    const bool is_asked_only = is_hidden || !chosen.record || (is_others && core.is_somewhere());
    const RecordName sent_name = is_asked_only ? RecordName{} : *chosen.record;
    if (auto sent = link.send(command_to_forget(sent_name)); !sent) return sent.error();
    if (is_hidden) {
        return Error{ErrorCode::machine_refused,
                     "the core keeps its piece in another folder, and nothing was forgotten: give --state "
                     "FOLDER"};
    }
    if (!chosen.record) return none_to_forget(link.segment_name(), found.has_value());
    if (!chosen.file) return chosen.piece;
    if (is_others) {
        if (auto gone = psicarve::forget_piece(*chosen.file); !gone) return gone.error();
        return chosen.piece;
    }
    const auto give_up = std::chrono::steady_clock::now() + kForgettingLimit;
    while (is_still_there(*chosen.file)) {
        if (std::chrono::steady_clock::now() >= give_up) return still_there(*chosen.file);
        std::this_thread::sleep_for(kForgettingLook);
    }
    return chosen.piece;
}

/// Does it as a core would, holding the core's lock: no core can begin meanwhile.
Result<void> clear_record(MachineLink& link) {
    if (auto locked = link.segment().take_core_lock(); !locked) return locked.error();
    write_record(link.segment().header().checkpoint, Checkpoint{});
    link.segment().release_core();
    return {};
}

}  // namespace

Result<ForgottenPiece> forget_piece(const std::string& segment_name, const std::string& group,
                                    const std::string& folder, const std::optional<RecordName>& wanted) {
    auto link = MachineLink::attach(segment_name, group);
    if (link && link->core_pid()) return forget_by_core(*link, folder, wanted);
    if (!link && link.error().code != ErrorCode::no_core) return link.error();
    const auto checkpoint = link ? link->checkpoint() : std::nullopt;
    const auto found = find_unfinished(segment_name, {}, folder);
    const bool is_in_segment =
        checkpoint &&
        is_wanted({segment_name, checkpoint->is_simulated(), checkpoint->job_checksum, 0}, wanted);
    const bool is_on_disk = found && is_wanted(found->saved.name(), wanted);
    if (!is_on_disk && !is_in_segment) return none_to_forget(segment_name, found || checkpoint);
    if (is_in_segment) {
        if (auto cleared = clear_record(*link); !cleared) return cleared.error();
    }
    if (!is_on_disk) return ForgottenPiece{*checkpoint, {}, {}};
    if (auto gone = psicarve::forget_piece(*found); !gone) return gone.error();
    return ForgottenPiece{found->saved.checkpoint, found->saved.source_name, found->path};
}

}  // namespace psicarve::machine
