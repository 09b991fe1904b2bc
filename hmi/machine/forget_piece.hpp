// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shared/base/result.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve::machine {

/// What nobody goes on with any more.
struct ForgottenPiece {
    Checkpoint checkpoint{};
    std::string source_name;  ///< of its job; empty: the segment alone knew of it
    std::string path;         ///< where it was kept; likewise
};

/// Nobody goes on with the unfinished piece of this segment any more: what segment and disk know of it goes,
/// and stays away after a power cut. Where there is a core, it does so, and is waited for; it refuses while a
/// job runs. The segment's piece comes first: another core's record goes only where the segment holds none,
/// or where it is `wanted`. Without a core it is done here, if the files are the user's. `folder`: where
/// cores keep it; empty: where they do by themselves. `wanted`: no other than that (sequence 0: whichever of
/// its job). bad_input: there is none, or it cannot be taken away. machine_refused: also where the core keeps
/// it in no folder looked at, or another piece has come there. May wait for a disk.
Result<ForgottenPiece> forget_piece(const std::string& segment_name, const std::string& group,
                                    const std::string& folder, const std::optional<RecordName>& wanted = {});

}  // namespace psicarve::machine
