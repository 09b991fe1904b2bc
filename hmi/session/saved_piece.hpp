// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_sight.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::session {

/// Whether a piece is worth a look for that neither core nor segment knows, as after the computer was
/// switched off: there is no core, or it has had no job.
bool may_be_saved(const MachineSight& machine) noexcept;

/// Whether whoever goes on with the published job's piece is to be asked first: how far it is carved is known
/// from a disk alone.
bool is_from_disk_alone(const MachineSight& machine, std::uint32_t layer) noexcept;
/// Memory and disk said different layers when the core accepted the job, and nothing was carved since.
std::optional<Phrase> disagreement(const MachineSight& machine);
/// Sentences that ask: which piece, since when, with which tool and profile.
std::vector<Phrase> disk_question(const MachineSight& machine);

/// "Unfinished: 131 of 200 layers of vase.stl are carved".
Phrase saved_title(const SavedCheckpoint& saved);
/// Sentences for the operator: since when, with which tool, what to do, and where the run before came to.
std::vector<Phrase> saved_details(const FoundCheckpoint& found, const MachineSight& machine);
/// In few words what nobody may miss.
std::vector<Phrase> saved_needs(const FoundCheckpoint& found, const MachineSight& machine);

/// What a question about forgetting is about.
struct ForgettablePiece {
    RecordName record{};
    Phrase title{};
};
/// The piece that forgetting would take away as the machine is seen now; nothing: there is none.
std::optional<ForgettablePiece> forgettable_piece(const MachineSight& machine);

}  // namespace psicarve::session
