// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/saved_piece.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "hmi/phrase/message_phrase.hpp"
#include "hmi/report/utc_text.hpp"
#include "hmi/session/going_on.hpp"

namespace psicarve::session {
namespace {

Phrase origin(const SavedCheckpoint& saved) {
    const std::string since = report::utc_text(saved.written_s);
    if (saved.tool.empty()) return phrase("Since %1.", since);
    return phrase("Since %1, tool %2.", since, saved.tool);
}

/// The layer with which the piece continues, counted from 1.
std::string layer_after(const Checkpoint& checkpoint) {
    return std::to_string((checkpoint.next_layer != 0 ? checkpoint.next_layer : checkpoint.earlier_layer) +
                          1);
}

Phrase steps(const FoundCheckpoint& found) {
    const std::string layer = layer_after(found.saved.checkpoint);
    if (found.job_path.empty()) {
        return phrase(
            "No copy of its job is there: open that very job, publish it, Home all, then go on from layer "
            "%1.",
            layer);
    }
    return phrase("Open its job, publish it, Home all, then go on from layer %1.", layer);
}

void add_run_before(std::vector<Phrase>& to, const Checkpoint& checkpoint) {
    if (checkpoint.earlier_layer == 0) return;
    to.push_back(phrase("Run before: to layer %1 (From layer %2).", std::to_string(checkpoint.earlier_layer),
                        std::to_string(checkpoint.earlier_layer + 1)));
}

/// Whether the question is about the disk's record, and not about another piece or run since.
bool is_of_checkpoint(const SavedCheckpoint& saved, const MachineView& machine) noexcept {
    const Checkpoint& checkpoint = saved.checkpoint;
    return checkpoint.job_checksum == machine.checkpoint_job_checksum &&
           checkpoint.layer_count == machine.checkpoint_layer_count &&
           checkpoint.next_layer == machine.resumable_layer.value_or(0) &&
           checkpoint.earlier_layer == machine.earlier_layer.value_or(0);
}

/// Without a core its profile is not known.
bool is_other_profile(const SavedCheckpoint& saved, const MachineView& machine) noexcept {
    return machine.is_heard() && machine.core_profile_hash != 0 &&
           machine.core_profile_hash != saved.profile_hash;
}

/// Only the person who mounted the piece knows whether it is the one on the table.
void add_doubts(std::vector<Phrase>& to, const FoundCheckpoint& found) {
    if (found.keeper == Keeper::other_core)
        to.push_back(phrase("This core keeps pieces elsewhere, or nowhere: it is another core's."));
    for (const std::string& other : found.other_paths)
        to.push_back(phrase("%1 tells of another piece: see which of them is mounted.", other));
}

/// A dry run carves nothing.
bool has_carved_since(const CoreStatus& status) noexcept {
    return status.points_done != 0 && status.is_dry == 0;
}

Phrase other_profile() {
    return phrase("It was begun with another profile of the machine.");
}

}  // namespace

bool is_from_disk_alone(const MachineView& machine, std::uint32_t layer) noexcept {
    return machine.is_heard() && machine.is_checkpoint_from_disk &&
           (machine.resumable_layer == layer || machine.earlier_layer == layer);
}

bool is_contradicted(const Checkpoint& known, const MachineView& machine) noexcept {
    if (machine.is_heard() || !machine.saved_piece) return false;
    const SavedCheckpoint& saved = machine.saved_piece->saved;
    // Of another job, or of the other kind of machine, the disk says nothing of this piece.
    return saved.checkpoint.job_checksum == known.job_checksum &&
           saved.is_simulator == known.is_simulated() && !is_same_place(saved.checkpoint, known);
}

std::optional<Phrase> disagreement(const MachineView& machine) {
    const auto both =
        std::ranges::find(machine.job_remarks, MessageId::segment_and_disk_disagree, &psicarve::Message::id);
    // What was carved since is known.
    if (both == machine.job_remarks.end() || !machine.status || has_carved_since(*machine.status))
        return std::nullopt;
    return message_phrase(*both);
}

std::vector<Phrase> disk_question(const MachineView& machine) {
    std::vector<Phrase> question;
    const auto& found = machine.saved_piece;
    const bool is_known = found && found->keeper != Keeper::other_core;
    if (is_known && is_of_checkpoint(found->saved, machine)) {
        question.push_back(saved_title(found->saved));
        question.push_back(origin(found->saved));
        if (is_other_profile(found->saved, machine)) question.push_back(other_profile());
    } else if (is_known) {
        question.push_back(phrase(
            "Since when, and with which tool, is not known: the disk tells of another piece or layer by "
            "now."));
    } else {
        question.push_back(phrase("Since when, and with which tool, is not known: no disk tells of it."));
    }
    if (auto both = disagreement(machine)) question.push_back(*std::move(both));
    question.push_back(phrase(
        "This is known from the disk alone. Go on only if this very piece is still mounted, as it was, "
        "with this tool."));
    return question;
}

bool may_be_saved(const MachineView& machine) noexcept {
    return !machine.is_heard() || !machine.status || machine.status->job_generation == 0;
}

Phrase saved_title(const SavedCheckpoint& saved) {
    const std::string count = std::to_string(saved.checkpoint.layer_count);
    if (saved.checkpoint.next_layer == 0)
        return phrase("Begun anew: none of %1 layers of %2 is finished", count, saved.source_name);
    return phrase("Unfinished: %1 of %2 layers of %3 are carved", std::to_string(saved.checkpoint.next_layer),
                  count, saved.source_name);
}

std::optional<ForgettablePiece> forgettable_piece(const MachineView& machine) {
    const auto& found = machine.saved_piece;
    const bool is_segments = machine.is_checkpoint_from_disk && (!may_be_saved(machine) || !found);
    if (!is_segments) {
        if (!found) return std::nullopt;
        return ForgettablePiece{found->saved.name(), saved_title(found->saved)};
    }
    if (found && is_of_checkpoint(found->saved, machine))
        return ForgettablePiece{found->saved.name(), saved_title(found->saved)};
    // The disk's record is not known; its job is.
    return ForgettablePiece{
        {{}, machine.is_simulator(), machine.checkpoint_job_checksum, 0},
        unfinished_title({machine.resumable_layer.value_or(0), machine.earlier_layer.value_or(0),
                          machine.checkpoint_layer_count})};
}

std::vector<Phrase> saved_details(const FoundCheckpoint& found, const MachineView& machine) {
    std::vector<Phrase> details{origin(found.saved)};
    if (is_other_profile(found.saved, machine)) details.push_back(other_profile());
    add_doubts(details, found);
    if (!machine.is_heard()) details.push_back(phrase("First start psicarve-rtcore."));
    details.push_back(steps(found));
    add_run_before(details, found.saved.checkpoint);
    return details;
}

std::vector<Phrase> saved_needs(const FoundCheckpoint& found, const MachineView& machine) {
    const Checkpoint& checkpoint = found.saved.checkpoint;
    std::vector<Phrase> needs;
    if (is_other_profile(found.saved, machine)) needs.push_back(other_profile());
    add_doubts(needs, found);
    needs.push_back(phrase("Open its job, then go on from layer %1.", layer_after(checkpoint)));
    add_run_before(needs, checkpoint);
    return needs;
}

}  // namespace psicarve::session
