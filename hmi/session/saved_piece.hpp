// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::session {

/// Whether to look on the disk for a piece that neither core nor segment knows, as after the computer was
/// switched off: there is no core, or it has had no job.
bool may_be_saved(const MachineView& machine) noexcept;

/// Whether the operator must be asked before the published job's piece is continued: its progress is known
/// from a disk alone.
bool is_from_disk_alone(const MachineView& machine, std::uint32_t layer) noexcept;
/// Memory and disk had different layers when the core accepted the job, and nothing was carved since.
std::optional<Phrase> disagreement(const MachineView& machine);
/// Without a core: the disk's record of the segment's piece is of another place, as after a run that was
/// begun anew; the next core takes the lower of the two, and no point within a layer.
bool is_contradicted(const Checkpoint& known, const MachineView& machine) noexcept;
/// The question in sentences: which piece, since when, with which tool and profile.
std::vector<Phrase> disk_question(const MachineView& machine);

/// "Unfinished: 131 of 200 layers of vase.stl are carved".
Phrase saved_title(const SavedCheckpoint& saved);
/// Sentences for the operator: since when, with which tool, what to do, and how far the run before came.
std::vector<Phrase> saved_details(const FoundCheckpoint& found, const MachineView& machine);
/// The essential ones in few words.
std::vector<Phrase> saved_needs(const FoundCheckpoint& found, const MachineView& machine);

/// The piece that a question about forgetting means.
struct ForgettablePiece {
    RecordName record{};
    Phrase title{};
};
/// The piece that forgetting would remove in the machine's present state; nothing: there is none.
std::optional<ForgettablePiece> forgettable_piece(const MachineView& machine);

}  // namespace psicarve::session
