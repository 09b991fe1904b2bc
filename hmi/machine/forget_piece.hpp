// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shared/base/result.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve::machine {

/// An unfinished piece that is not to be continued.
struct ForgottenPiece {
    Checkpoint checkpoint{};
    std::string source_name;  ///< of its job; empty: only the segment knew of it
    std::string path;         ///< where it was kept; empty: as above
};

/// Forgets the unfinished piece of this segment, in the segment and on the disk, for good, also after a power
/// cut. Where there is a core, the core does it, and this waits for it; the core refuses while a job runs.
/// The segment's piece comes first: another core's record is removed only where the segment holds none, or
/// where it is `wanted`. Without a core it is done here, if the files are the user's. `folder`: where cores
/// keep it; empty: their default folders. `wanted`: only that record (sequence 0: any of its job). bad_input:
/// there is none, or it cannot be removed. machine_refused: also where the core keeps it in no folder looked
/// at, or another piece has come there. May wait for a disk.
Result<ForgottenPiece> forget_piece(const std::string& segment_name, const std::string& group,
                                    const std::string& folder, const std::optional<RecordName>& wanted = {});

}  // namespace psicarve::machine
