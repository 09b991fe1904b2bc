// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/job/job.hpp"
#include "shared/program/program_source.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve {

inline constexpr std::uint64_t kSnapshotMagic = 0x3150414e53435350ULL;  // "PSCSNAP1"
inline constexpr std::uint32_t kSnapshotVersion = 1;
/// Of a snapshot with the source of a program; all others are of kSnapshotVersion, and read by older
/// programs.
inline constexpr std::uint32_t kSnapshotWithSourceVersion = 2;

/// First bytes of a job or snapshot file. Little-endian. Then come, without a gap: the status (CoreStatus or
/// nothing), the flight recorder (FlightRecord, oldest first), the job blob, zeros up to a multiple of 8
/// bytes; with kSnapshotWithSourceVersion a RecordedSource, as far as its profile goes, and zeros likewise.
struct SnapshotHeader {
    std::uint64_t magic;
    std::uint32_t version;
    std::uint32_t layout_version;  ///< checked where there is a status or a record
    std::uint64_t abi_hash;        ///< snapshot_abi_hash
    std::uint64_t total_bytes;
    std::uint64_t checksum;  ///< XXH3 over the whole file with this field 0
    std::uint64_t status_offset;
    std::uint64_t status_bytes;  ///< 0 in a job file
    std::uint64_t recorder_offset;
    std::uint64_t recorder_bytes;
    std::uint64_t job_offset;
    std::uint64_t job_bytes;
    std::uint32_t capacity_layers;  ///< of the segment it was taken from; 0 in a job file
    std::uint32_t capacity_points;
    std::uint64_t generation;      ///< of the job in that segment; 0 in a job file
    std::uint64_t checkpoint_job;  ///< as in Checkpoint; all 0 when there is none
    std::uint32_t checkpoint_next_layer;
    std::uint32_t checkpoint_layer_count;
};
static_assert(sizeof(SnapshotHeader) == 120);

/// A job or snapshot file in memory, checked. Job files have no status and no records.
struct Snapshot {
    std::optional<CoreStatus> status;
    std::vector<FlightRecord> records;  ///< oldest first
    std::vector<std::byte>
        job_blob;  ///< passes JobView::check; empty: nothing was published (never in a job file)
    std::uint32_t capacity_layers = 0;
    std::uint32_t capacity_points = 0;
    std::uint64_t generation = 0;
    std::optional<Checkpoint> checkpoint;  ///< passes is_checkpoint; may be of another job
    /// Of the last program; null: there was none, or an older psicarve ran it. None of it is checked but that
    /// its profile_bytes are there.
    std::shared_ptr<const RecordedSource> source;
};

/// Whether the file begins like a job or snapshot file (so that `carve FILE` can tell a job from a model).
bool looks_like_snapshot(std::span<const std::byte> first_bytes) noexcept;
/// The same for a file's name. False for a file that cannot be read: its reader says why.
bool is_snapshot_file(const std::string& path);

/// Trusts no byte: checks magic, version, ABI hash, sizes, offsets, checksum, then the job blob. Error:
/// "FILE: what is wrong".
Result<Snapshot> parse_snapshot(std::span<const std::byte> bytes, const std::string& file_name);
Result<Snapshot> load_snapshot(const std::string& path);

/// Equal snapshots give equal bytes.
std::vector<std::byte> snapshot_bytes(const Snapshot& snapshot);
/// What the header's checksum must be for these bytes of a file; 0 when they are too few.
std::uint64_t snapshot_checksum(std::span<const std::byte> bytes);
/// Writes as write_file_atomically does (atomic_file.hpp): the old file stays intact whatever happens. A
/// snapshot is for its owner alone (0600), or for a group as well (0660); a job file gets what the umask
/// leaves.
Result<void> save_snapshot(const Snapshot& snapshot, const std::string& path, const std::string& group = {});
/// Writes a blob that is a job to a job file, which all users may read. Needs no memory for another copy of
/// it.
Result<void> save_job_for_everybody(std::span<const std::byte> job_blob, const std::string& path);
/// Writes the bytes of save_snapshot to an open descriptor, which may be a pipe; `name` is for messages.
Result<void> write_snapshot(const Snapshot& snapshot, int descriptor, const std::string& name);

}  // namespace psicarve
