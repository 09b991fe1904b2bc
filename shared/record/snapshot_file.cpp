// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/snapshot_file.hpp"

#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include "shared/file/atomic_file.hpp"
#include "shared/segment/segment_object.hpp"

namespace psicarve {
namespace {

using Bytes = std::span<const std::byte>;

std::uint64_t round_up_to_8(std::uint64_t bytes) noexcept {
    return (bytes + 7) / 8 * 8;
}

Error wrong(const std::string& file_name, const std::string& what) {
    return bad_input(file_name + ": " + what);
}

constexpr std::size_t kSourceBytesBeforeProfile =
    offsetof(RecordedSource, source) + offsetof(ProgramSource, profile);

/// Of a source in a file: the profile is as long as it is.
Bytes bytes_of(const RecordedSource& recorded) noexcept {
    const std::uint64_t profile_bytes =
        std::min<std::uint64_t>(recorded.source.profile_bytes, kSourceProfileBytes);
    return std::as_bytes(std::span{&recorded, 1})
        .first(round_up_to_8(kSourceBytesBeforeProfile + profile_bytes));
}

SnapshotHeader header_of(const Snapshot& snapshot, std::uint64_t job_bytes) noexcept {
    SnapshotHeader header{};
    const bool has_status = snapshot.status.has_value() || !snapshot.records.empty();
    header.magic = kSnapshotMagic;
    header.version = snapshot.source ? kSnapshotWithSourceVersion : kSnapshotVersion;
    header.layout_version = kLayoutVersion;
    header.abi_hash = snapshot_abi_hash(has_status);
    header.status_offset = sizeof(SnapshotHeader);
    header.status_bytes = snapshot.status ? sizeof(CoreStatus) : 0;
    header.recorder_offset = header.status_offset + header.status_bytes;
    header.recorder_bytes = snapshot.records.size() * sizeof(FlightRecord);
    header.job_offset = header.recorder_offset + header.recorder_bytes;
    header.job_bytes = job_bytes;
    header.total_bytes = header.job_offset + round_up_to_8(header.job_bytes) +
                         (snapshot.source ? bytes_of(*snapshot.source).size() : 0);
    header.capacity_layers = snapshot.capacity_layers;
    header.capacity_points = snapshot.capacity_points;
    header.generation = snapshot.generation;
    if (snapshot.checkpoint) {
        header.checkpoint_job = snapshot.checkpoint->job_checksum;
        header.checkpoint_next_layer = snapshot.checkpoint->next_layer;
        header.checkpoint_layer_count = snapshot.checkpoint->layer_count;
    }
    return header;
}

SnapshotHeader header_of(const Snapshot& snapshot) noexcept {
    return header_of(snapshot, snapshot.job_blob.size());
}

struct HashState {
    HashState() : state(XXH3_createState()) { XXH3_64bits_reset(state); }
    ~HashState() { XXH3_freeState(state); }
    HashState(const HashState&) = delete;
    HashState& operator=(const HashState&) = delete;
    void add(Bytes bytes) { XXH3_64bits_update(state, bytes.data(), bytes.size()); }
    XXH3_state_t* state;
};

/// Over the whole file, the header's own checksum taken as 0.
std::uint64_t checksum_of(SnapshotHeader header, std::span<const Bytes> rest) {
    header.checksum = 0;
    HashState hash;
    hash.add(std::as_bytes(std::span{&header, 1}));
    for (const Bytes part : rest) hash.add(part);
    return XXH3_64bits_digest(hash.state);
}

Bytes padding_behind(std::uint64_t job_bytes) noexcept {
    static constexpr std::array<std::byte, 8> kPadding{};
    return Bytes{kPadding}.first(round_up_to_8(job_bytes) - job_bytes);
}

/// The file's parts behind the header, in their order; point into the snapshot.
std::array<Bytes, 5> parts_of(const Snapshot& snapshot) noexcept {
    return {snapshot.status ? std::as_bytes(std::span{&*snapshot.status, 1}) : Bytes{},
            std::as_bytes(std::span{snapshot.records}), Bytes{snapshot.job_blob},
            padding_behind(snapshot.job_blob.size()), snapshot.source ? bytes_of(*snapshot.source) : Bytes{}};
}

/// Sizes and offsets: the parts follow each other without a gap, so nothing can overlap or overflow.
Result<void> check_sizes(const SnapshotHeader& header, std::uint64_t file_bytes,
                         const std::string& file_name) {
    if (header.total_bytes > file_bytes) {
        return wrong(file_name, "truncated: " + std::to_string(file_bytes) + " of " +
                                    std::to_string(header.total_bytes) + " bytes");
    }
    if (header.total_bytes < file_bytes) {
        return wrong(file_name, "has " + std::to_string(file_bytes - header.total_bytes) + " bytes too many");
    }
    const bool is_each_possible = (header.status_bytes == 0 || header.status_bytes == sizeof(CoreStatus)) &&
                                  header.recorder_bytes <= file_bytes &&
                                  header.recorder_bytes % sizeof(FlightRecord) == 0 &&
                                  header.job_bytes <= file_bytes;
    const std::uint64_t end_of_job = header.job_offset + round_up_to_8(header.job_bytes);
    const bool has_source = header.version == kSnapshotWithSourceVersion;
    const bool do_follow_each_other =
        is_each_possible && header.status_offset == sizeof(SnapshotHeader) &&
        header.recorder_offset == header.status_offset + header.status_bytes &&
        header.job_offset == header.recorder_offset + header.recorder_bytes &&
        (has_source ? header.total_bytes >= end_of_job + kSourceBytesBeforeProfile
                    : header.total_bytes == end_of_job);
    if (!do_follow_each_other) return wrong(file_name, "damaged: sizes and offsets do not fit each other");
    return {};
}

Result<void> check_kind(const SnapshotHeader& header, const std::string& file_name) {
    if (header.magic != kSnapshotMagic) return wrong(file_name, "is no psicarve job or snapshot file");
    if (header.version != kSnapshotVersion && header.version != kSnapshotWithSourceVersion) {
        return wrong(file_name, "file version " + std::to_string(header.version) + ", this program knows " +
                                    std::to_string(kSnapshotVersion) + " and " +
                                    std::to_string(kSnapshotWithSourceVersion) + ": make the file anew");
    }
    const bool has_status = header.status_bytes != 0 || header.recorder_bytes != 0;
    const bool is_known_status =
        header.layout_version >= kOldestStatusVersion && header.layout_version <= kLayoutVersion;
    if (has_status && !is_known_status) {
        return wrong(file_name, "status of layout version " + std::to_string(header.layout_version) +
                                    ", this program knows " + std::to_string(kOldestStatusVersion) + " to " +
                                    std::to_string(kLayoutVersion));
    }
    if (header.abi_hash != snapshot_abi_hash(has_status)) {
        return wrong(file_name,
                     "was written by a psicarve of another build (its structures have other sizes)");
    }
    return {};
}

Result<std::optional<Checkpoint>> take_checkpoint(const SnapshotHeader& header,
                                                  const std::string& file_name) {
    if (header.checkpoint_layer_count == 0 && header.checkpoint_next_layer == 0)
        return std::optional<Checkpoint>{};
    const Checkpoint checkpoint =
        checkpoint_at(header.checkpoint_job, header.checkpoint_next_layer, header.checkpoint_layer_count);
    if (!is_checkpoint(checkpoint)) return wrong(file_name, "damaged: its checkpoint is beyond the job");
    return std::optional{checkpoint};
}

/// What follows the job, to the end of the file; requires check_sizes().
Result<std::shared_ptr<const RecordedSource>> take_source(Bytes rest, const std::string& file_name) {
    auto recorded = std::make_shared<RecordedSource>();
    if (rest.size() <= sizeof(RecordedSource)) std::memcpy(recorded.get(), rest.data(), rest.size());
    const ProgramSource& source = recorded->source;
    const bool is_whole =
        source.profile_bytes <= kSourceProfileBytes && bytes_of(*recorded).size() == rest.size();
    if (!is_whole) return wrong(file_name, "damaged: the source of its program has another size");
    return std::shared_ptr<const RecordedSource>{std::move(recorded)};
}

Result<void> check_contents(const Snapshot& snapshot, const std::string& file_name) {
    const bool is_job_file = !snapshot.status && snapshot.records.empty();
    if (snapshot.job_blob.empty()) {
        if (is_job_file) return wrong(file_name, "holds no job");
        return {};
    }
    const Result<JobView> job = JobView::check(snapshot.job_blob);
    if (!job) return wrong(file_name, job.error().message);
    return {};
}

Result<std::optional<FileRights>> rights_of(const Snapshot& snapshot, const std::string& group) {
    constexpr mode_t kOwnerAlone = 0600;
    constexpr mode_t kOwnerAndGroup = 0660;
    const bool is_job_file = !snapshot.status && snapshot.records.empty();
    if (is_job_file) return std::optional<FileRights>{};
    if (group.empty()) return std::optional{FileRights{kOwnerAlone, {}}};
    const Result<gid_t> id = group_id(group);
    if (!id) return id.error();
    return std::optional{FileRights{kOwnerAndGroup, *id}};
}

}  // namespace

bool looks_like_snapshot(std::span<const std::byte> first_bytes) noexcept {
    std::uint64_t magic = 0;
    if (first_bytes.size() < sizeof(magic)) return false;
    std::memcpy(&magic, first_bytes.data(), sizeof(magic));
    return magic == kSnapshotMagic;
}

bool is_snapshot_file(const std::string& path) {
    const auto start = read_file_start(path, sizeof(kSnapshotMagic));
    return start && looks_like_snapshot(*start);
}

Result<Snapshot> parse_snapshot(std::span<const std::byte> bytes, const std::string& file_name) {
    if (!looks_like_snapshot(bytes)) return wrong(file_name, "is no psicarve job or snapshot file");
    SnapshotHeader header{};
    if (bytes.size() < sizeof(header)) return wrong(file_name, "truncated: its header is not complete");
    std::memcpy(&header, bytes.data(), sizeof(header));
    if (auto kind = check_kind(header, file_name); !kind) return kind.error();
    if (auto sizes = check_sizes(header, bytes.size(), file_name); !sizes) return sizes.error();
    const std::array rest{bytes.subspan(sizeof(header))};
    if (checksum_of(header, rest) != header.checksum)
        return wrong(file_name, "damaged: its checksum is wrong");

    Snapshot snapshot;
    if (header.status_bytes != 0) {
        std::memcpy(&snapshot.status.emplace(), bytes.data() + header.status_offset, sizeof(CoreStatus));
    }
    snapshot.records.resize(header.recorder_bytes / sizeof(FlightRecord));
    if (!snapshot.records.empty()) {
        std::memcpy(snapshot.records.data(), bytes.data() + header.recorder_offset, header.recorder_bytes);
    }
    const Bytes job = bytes.subspan(header.job_offset, header.job_bytes);
    snapshot.job_blob.assign(job.begin(), job.end());
    snapshot.capacity_layers = header.capacity_layers;
    snapshot.capacity_points = header.capacity_points;
    snapshot.generation = header.generation;
    const auto checkpoint = take_checkpoint(header, file_name);
    if (!checkpoint) return checkpoint.error();
    snapshot.checkpoint = *checkpoint;
    if (header.version == kSnapshotWithSourceVersion) {
        auto source =
            take_source(bytes.subspan(header.job_offset + round_up_to_8(header.job_bytes)), file_name);
        if (!source) return source.error();
        snapshot.source = std::move(*source);
    }
    if (auto contents = check_contents(snapshot, file_name); !contents) return contents.error();
    return snapshot;
}

std::uint64_t snapshot_checksum(std::span<const std::byte> bytes) {
    SnapshotHeader header{};
    if (bytes.size() < sizeof(header)) return 0;
    std::memcpy(&header, bytes.data(), sizeof(header));
    const std::array rest{bytes.subspan(sizeof(header))};
    return checksum_of(header, rest);
}

std::vector<std::byte> snapshot_bytes(const Snapshot& snapshot) {
    const auto parts = parts_of(snapshot);
    SnapshotHeader header = header_of(snapshot);
    header.checksum = checksum_of(header, parts);
    std::vector<std::byte> bytes;
    bytes.reserve(header.total_bytes);
    const Bytes first = std::as_bytes(std::span{&header, 1});
    bytes.insert(bytes.end(), first.begin(), first.end());
    for (const Bytes part : parts) bytes.insert(bytes.end(), part.begin(), part.end());
    return bytes;
}

Result<void> save_snapshot(const Snapshot& snapshot, const std::string& path, const std::string& group) {
    const auto rights = rights_of(snapshot, group);
    if (!rights) return rights.error();
    const auto parts = parts_of(snapshot);
    SnapshotHeader header = header_of(snapshot);
    header.checksum = checksum_of(header, parts);
    // Written part by part: there may be no memory for another copy of a job.
    const std::array all{
        std::as_bytes(std::span{&header, 1}), parts[0], parts[1], parts[2], parts[3], parts[4]};
    return write_parts_atomically(path, all, *rights);
}

Result<void> save_job_for_everybody(std::span<const std::byte> job_blob, const std::string& path) {
    const std::array rest{job_blob, padding_behind(job_blob.size())};
    SnapshotHeader header = header_of(Snapshot{}, job_blob.size());
    header.checksum = checksum_of(header, rest);
    const std::array all{std::as_bytes(std::span{&header, 1}), rest[0], rest[1]};
    return write_parts_atomically(path, all, FileRights{kForEverybody, {}});
}

Result<void> write_snapshot(const Snapshot& snapshot, int descriptor, const std::string& name) {
    const auto parts = parts_of(snapshot);
    SnapshotHeader header = header_of(snapshot);
    header.checksum = checksum_of(header, parts);
    const std::array all{
        std::as_bytes(std::span{&header, 1}), parts[0], parts[1], parts[2], parts[3], parts[4]};
    for (std::span<const std::byte> part : all) {
        while (!part.empty()) {
            const ssize_t done = ::write(descriptor, part.data(), part.size());
            if (done < 0 && errno == EINTR) continue;
            if (done <= 0) return Error{ErrorCode::out_of_room, name + ": " + std::strerror(errno)};
            part = part.subspan(static_cast<std::size_t>(done));
        }
    }
    return {};
}

Result<Snapshot> load_snapshot(const std::string& path) {
    const Result<std::vector<std::byte>> bytes = read_whole_file(path);
    if (!bytes) return bytes.error();
    return parse_snapshot(*bytes, path);
}

}  // namespace psicarve
