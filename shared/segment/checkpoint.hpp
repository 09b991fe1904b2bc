// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "shared/base/result.hpp"

namespace psicarve {

/// The origin of a checkpoint, as bits.
inline constexpr std::uint32_t kCheckpointSimulated = 1;  ///< of a simulated machine: no real piece belongs
                                                          ///< to it
inline constexpr std::uint32_t kCheckpointFromDisk = 2;   ///< read from a disk; nothing was carved by it
                                                          ///< since

/// How far the last carving has come, so that it can go on after whatever ended it. Stands in the segment,
/// outlives the core that wrote it; its own checksum tells it from garbage.
struct Checkpoint {
    std::uint64_t job_checksum;  ///< XXH3 over the job's blob
    std::uint32_t next_layer;    ///< all layers before it, from where the run began, are carved
    std::uint32_t layer_count;   ///< of the job
    /// next_layer of the run before, which this run began anew and has not passed yet; 0: none. Which of the
    /// two pieces is on the table, only the person who mounted it knows.
    std::uint32_t earlier_layer;
    std::uint32_t origin;  ///< kCheckpoint... bits
    std::uint64_t check;   ///< XXH3 over the fields before it; all 0: no checkpoint

    bool is_simulated() const noexcept { return (origin & kCheckpointSimulated) != 0; }
    bool is_from_disk() const noexcept { return (origin & kCheckpointFromDisk) != 0; }
    /// How many layers of the piece a run of the whole job leaves carved: of this run, even if another came
    /// further; where this run has finished none, of the one before it. 0: none, or all.
    std::uint32_t left_behind() const noexcept {
        if (next_layer == layer_count) return 0;
        return next_layer != 0 ? next_layer : earlier_layer;
    }
    /// Never written. A damaged one is not empty.
    bool is_empty() const noexcept;
};
static_assert(sizeof(Checkpoint) == 32 && std::is_trivially_copyable_v<Checkpoint>, "bump kLayoutVersion");

Checkpoint checkpoint_at(std::uint64_t job_checksum, std::uint32_t next_layer, std::uint32_t layer_count,
                         std::uint32_t earlier_layer = 0, std::uint32_t origin = 0) noexcept;

/// Whether it is valid: neither empty nor damaged.
bool is_checkpoint(const Checkpoint& checkpoint) noexcept;

/// The carving began, and has not come to its end.
bool is_unfinished(const Checkpoint& checkpoint) noexcept;

/// Whether both mean the same place in the same job, whatever their origin.
bool is_same_place(const Checkpoint& one, const Checkpoint& other) noexcept;

/// The layer with which this job goes on. Refuses (machine_refused) with the reason: nothing was carved,
/// damaged, of another job, no layer finished, all finished. Where the run before came further, the message
/// says so, and the layer is still this run's. `copied` is a copy that no other process can change; nothing:
/// the checkpoint could not be read.
Result<std::uint32_t> layer_to_resume(const std::optional<Checkpoint>& copied, std::uint64_t job_checksum,
                                      std::uint32_t layer_count);

}  // namespace psicarve
