// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "shared/base/result.hpp"

namespace psicarve {

/// Whose a checkpoint is and whence it came, as bits.
inline constexpr std::uint32_t kCheckpointSimulated = 1;  ///< a simulated machine's: of no piece of wood
inline constexpr std::uint32_t kCheckpointFromDisk = 2;   ///< from a disk; nothing was carved by it since

/// How far the last carving has come, so that it goes on after whatever ended it. Stands in the segment,
/// outlives the core that wrote it, and is told from garbage by its own checksum.
struct Checkpoint {
    std::uint64_t job_checksum;  ///< XXH3 over the job's blob
    std::uint32_t next_layer;    ///< all before it, from where the run began, are carved
    std::uint32_t layer_count;   ///< of the job
    /// The same of the run before, which this one began anew and has not passed yet; 0: none. Whether its
    /// piece or another stands on the table, only who mounted it knows.
    std::uint32_t earlier_layer;
    std::uint32_t origin;  ///< kCheckpoint... bits
    std::uint64_t check;   ///< XXH3 over the fields before; all 0: no checkpoint

    bool is_simulated() const noexcept { return (origin & kCheckpointSimulated) != 0; }
    bool is_from_disk() const noexcept { return (origin & kCheckpointFromDisk) != 0; }
    /// Layers of the piece that a run of the whole job leaves behind: of this run, and not of whichever came
    /// furthest; where it has finished none, of the one before it. 0: none, or all.
    std::uint32_t left_behind() const noexcept {
        if (next_layer == layer_count) return 0;
        return next_layer != 0 ? next_layer : earlier_layer;
    }
    /// Nothing was ever written there; one that is damaged is not empty.
    bool is_empty() const noexcept;
};
static_assert(sizeof(Checkpoint) == 32 && std::is_trivially_copyable_v<Checkpoint>, "bump kLayoutVersion");

Checkpoint checkpoint_at(std::uint64_t job_checksum, std::uint32_t next_layer, std::uint32_t layer_count,
                         std::uint32_t earlier_layer = 0, std::uint32_t origin = 0) noexcept;

/// Whether it is one at all: neither empty nor damaged.
bool is_checkpoint(const Checkpoint& checkpoint) noexcept;

/// Begun, and not carved to its end.
bool is_unfinished(const Checkpoint& checkpoint) noexcept;

/// Whether both tell the same of the same job, whencever they came.
bool is_same_place(const Checkpoint& one, const Checkpoint& other) noexcept;

/// The layer with which this job goes on. Refused (machine_refused) with the reason: nothing was carved,
/// damaged, of another job, no layer finished, all finished. Where the run before came further, that is said,
/// and not taken. `copied` is a copy nobody else can change;
/// nothing: it could not be read.
Result<std::uint32_t> layer_to_resume(const std::optional<Checkpoint>& copied, std::uint64_t job_checksum,
                                      std::uint32_t layer_count);

}  // namespace psicarve
