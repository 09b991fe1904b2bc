// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_header.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/robust_mutex.hpp"

namespace psicarve {
namespace {

constexpr std::size_t kFixedBytes = offsetof(SegmentHeader, core);
using FixedPart = std::array<std::byte, kFixedBytes>;

template <typename T>
T field_at(const FixedPart& bytes, std::size_t offset) noexcept {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

bool is_all_zero(const FixedPart& bytes) noexcept {
    return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
}

/// Unknown boots (no /proc) count as the present one.
bool is_from_this_boot(const FixedPart& bytes) {
    constexpr std::size_t kIdBytes = sizeof(SegmentHeader::boot_id);
    const auto id = field_at<std::array<char, kIdBytes>>(bytes, offsetof(SegmentHeader, boot_id));
    const std::string_view found{id.data(), ::strnlen(id.data(), kIdBytes)};
    const std::string ours = current_boot_id();
    return ours.empty() || found.empty() || found == ours;
}

bool has_possible_numbers(const FixedPart& bytes, const HeaderFacts& facts) noexcept {
    if (facts.capacity_layers < 1 || facts.capacity_layers > kMaxCapacityLayers) return false;
    if (facts.capacity_points < 1 || facts.capacity_points > kMaxCapacityPoints) return false;
    if (!is_ring_capacity(facts.capacity_records)) return false;
    const SegmentGeometry& wanted = facts.geometry;
    return field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, ring_offset)) == wanted.ring_offset &&
           field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, slot_offset)) == wanted.slot_offset[0] &&
           field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, slot_offset) + sizeof(std::uint64_t)) ==
               wanted.slot_offset[1] &&
           field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, slot_bytes)) == wanted.slot_bytes &&
           field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, total_bytes)) == wanted.total_bytes;
}

HeaderState judge(const FixedPart& bytes, HeaderFacts& facts) {
    if (is_all_zero(bytes)) return HeaderState::half_made;
    if (field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, magic)) != kSegmentMagic) {
        return HeaderState::not_ours;
    }
    const auto ready = field_at<std::uint32_t>(bytes, offsetof(SegmentHeader, ready));
    if (ready == 0) return HeaderState::half_made;
    if (ready != kSegmentReady) return HeaderState::not_ours;
    facts.layout_version = field_at<std::uint32_t>(bytes, offsetof(SegmentHeader, layout_version));
    if (facts.layout_version != kLayoutVersion) return HeaderState::foreign_version;
    if (field_at<std::uint64_t>(bytes, offsetof(SegmentHeader, abi_hash)) != segment_abi_hash()) {
        return HeaderState::foreign_abi;
    }
    facts.capacity_layers = field_at<std::uint32_t>(bytes, offsetof(SegmentHeader, capacity_layers));
    facts.capacity_points = field_at<std::uint32_t>(bytes, offsetof(SegmentHeader, capacity_points));
    facts.capacity_records = field_at<std::uint32_t>(bytes, offsetof(SegmentHeader, capacity_records));
    facts.geometry = segment_geometry(facts.capacity_layers, facts.capacity_points, facts.capacity_records);
    if (!has_possible_numbers(bytes, facts)) return HeaderState::wrong_numbers;
    if (static_cast<std::uint64_t>(facts.size_bytes) != facts.geometry.total_bytes) {
        return HeaderState::wrong_size;
    }
    return is_from_this_boot(bytes) ? HeaderState::usable : HeaderState::earlier_boot;
}

std::string what_is_wrong(const HeaderFacts& facts) {
    switch (facts.state) {
        case HeaderState::foreign_version:
            return "has layout version " + std::to_string(facts.layout_version) + ", this program knows " +
                   std::to_string(kLayoutVersion);
        case HeaderState::foreign_abi:
            return "was made by a psicarve of another build (its structures have other sizes)";
        case HeaderState::wrong_numbers:
            return "is damaged (capacities and offsets do not fit each other)";
        case HeaderState::wrong_size:
            return "has a wrong size: " + std::to_string(facts.size_bytes) + " bytes instead of " +
                   std::to_string(facts.geometry.total_bytes);
        default:
            return "is no psicarve segment";
    }
}

}  // namespace

HeaderFacts examine_header(const SegmentObject& object) {
    HeaderFacts facts;
    facts.size_bytes = object.size_bytes();
    if (facts.size_bytes == 0) {
        facts.state = HeaderState::half_made;
        return facts;
    }
    FixedPart bytes{};
    const ssize_t got = ::pread(object.descriptor(), bytes.data(), bytes.size(), 0);
    if (got != static_cast<ssize_t>(bytes.size())) return facts;
    facts.creator_pid =
        field_at<std::uint32_t>(bytes, offsetof(SegmentHeader, creator) + offsetof(ProcessIdentity, pid));
    facts.creator_start_time = field_at<std::uint64_t>(
        bytes, offsetof(SegmentHeader, creator) + offsetof(ProcessIdentity, start_time));
    facts.state = judge(bytes, facts);
    const bool is_foreign =
        facts.state == HeaderState::foreign_version || facts.state == HeaderState::foreign_abi;
    if (is_foreign && !object.is_locked_by_another(LockByte::core) &&
        !is_process_alive(facts.creator_pid, facts.creator_start_time)) {
        facts.state = HeaderState::left_behind;
    }
    return facts;
}

Error refusal_of(const HeaderFacts& facts, const std::string& name) {
    // A segment of another version is taken over as soon as no program uses it.
    const std::string remedy =
        is_damaged(facts.state) ? "or end what uses it and remove /dev/shm" + name
                                : "or end the programs of the other version that use it: the core, and pid " +
                                      std::to_string(facts.creator_pid);
    return bad_input("segment " + name + ": " + what_is_wrong(facts) +
                     ": choose another name with --segment, " + remedy);
}

Result<void> fill_header(SegmentHeader& header, std::uint32_t capacity_layers, std::uint32_t capacity_points,
                         std::uint32_t capacity_records) {
    const SegmentGeometry geometry = segment_geometry(capacity_layers, capacity_points, capacity_records);
    // With the magic and without `ready`, the object is recognised as half made, and as ours.
    header.magic = kSegmentMagic;
    header.layout_version = kLayoutVersion;
    header.abi_hash = segment_abi_hash();
    header.total_bytes = geometry.total_bytes;
    header.capacity_layers = capacity_layers;
    header.capacity_points = capacity_points;
    header.capacity_records = capacity_records;
    header.ring_offset = geometry.ring_offset;
    std::copy(std::begin(geometry.slot_offset), std::end(geometry.slot_offset),
              std::begin(header.slot_offset));
    header.slot_bytes = geometry.slot_bytes;
    current_boot_id().copy(header.boot_id, sizeof(header.boot_id) - 1);
    header.creator.start_time.store(process_start_time(own_pid()));
    header.creator.pid.store(own_pid());
    if (auto made = RobustMutex::initialise(header.mutex); !made) return made.error();
    header.ready.store(kSegmentReady, std::memory_order_release);
    return {};
}

}  // namespace psicarve
