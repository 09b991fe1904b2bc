// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::session {

/// Where an unfinished piece goes on: with the last point that both heads are known to have carved, so that
/// the parts overlap; else with the layer behind the finished ones. Nothing: nothing of it is known.
std::optional<StartPlace> place_to_go_on(const MachineView& machine) noexcept;

/// Where the heads wait. Requires a status.
StartPlace waiting_place(const MachineView& machine, std::uint32_t layer_count) noexcept;

/// Heads to that place, for `layers` layers (0: all that follow). Where the rest of the piece is begun with
/// the very place of the checkpoint, the core looks at that itself once more.
Command start_command(const MachineView& machine, const StartPlace& from, std::uint32_t layers,
                      bool is_dry) noexcept;

/// Of such an order among the messages: "Start", "Start from layer 132, point 57".
Phrase start_name(const StartPlace& from);

/// "Continue from layer 132", "Continue from layer 132, point 57".
Phrase continue_text(const StartPlace& place);

/// On which way the heads come there, as docs/planning.md describes it. Requires a place of the job.
Phrase approach_text(const cam::PreparedJob& job, const StartPlace& place);

/// Whether the job has that place, and something of its layer is left behind it.
bool is_place_of(const cam::PreparedJob& job, const StartPlace& place) noexcept;

}  // namespace psicarve::session
