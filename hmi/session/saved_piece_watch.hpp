// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "hmi/machine/forget_piece.hpp"
#include "hmi/machine/loose_work.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/base/result.hpp"

namespace psicarve::session {

/// Looks on disks for a core's record of an unfinished piece while the view wants one, once a second, and has
/// such a record forgotten. A disk that hangs holds up neither the calls nor the window's end. One thread's,
/// the owner's.
class SavedPieceWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// `state_folder`: where cores keep their records; empty: their default folders.
    SavedPieceWatch(std::string segment_name, std::string group, std::string state_folder);

    /// Writes the view's saved piece. `core`: where the core that serves the segment keeps its own.
    void poll(const CoreKeeping& core, MachineView& view, Clock::time_point now);
    /// False: another one is being forgotten, and this one stays.
    bool forget(const RecordName& record);
    /// What came of the last forgetting, once.
    std::optional<Result<machine::ForgottenPiece>> take_forgotten();

private:
    std::string segment_name_;
    std::string group_;
    std::string state_folder_;
    Clock::time_point looked_{};
    std::optional<bool> kind_;  ///< of the machine heard then: simulated; nothing: none was heard
    machine::LooseWork<std::optional<FoundCheckpoint>> search_;       ///< may hang
    machine::LooseWork<Result<machine::ForgottenPiece>> forgetting_;  ///< may hang
};

}  // namespace psicarve::session
