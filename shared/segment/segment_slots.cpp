// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "shared/segment/segment.hpp"
#include "shared/segment/segment_mapping.hpp"

namespace psicarve {
namespace {

constexpr std::uint64_t kSegmentSlotsPageBytes = 4096;

Error slot_error(const std::string& name, const std::string& what, int error_number) {
    if (error_number == ENOSPC) {
        return Error{ErrorCode::out_of_room, "segment " + name + ": /dev/shm is full"};
    }
    return bad_input("segment " + name + ": " + what + ": " + std::generic_category().message(error_number));
}

}  // namespace

Result<void> Segment::reserve_slot(std::uint32_t index, std::uint64_t bytes) {
    const SegmentGeometry& geometry = mapping_->geometry;
    if (index > 1 || bytes == 0 || bytes > geometry.slot_bytes) {
        return bad_input("segment " + name() + ": no room for " + std::to_string(bytes) +
                         " bytes in a slot of " + std::to_string(geometry.slot_bytes));
    }
    if (mapping_->object.size_bytes() != static_cast<std::int64_t>(geometry.total_bytes)) {
        return bad_input("segment " + name() + ": was truncated by another process");
    }
    const std::uint64_t offset = geometry.slot_offset[index];
    if (auto reserved = mapping_->object.reserve(name(), offset, bytes); !reserved) return reserved;
    const std::uint64_t used =
        (bytes + kSegmentSlotsPageBytes - 1) / kSegmentSlotsPageBytes * kSegmentSlotsPageBytes;
    if (used < geometry.slot_bytes) {
        // The memory of an earlier, larger job. Failing to free it does no harm.
        ::fallocate(mapping_->object.descriptor(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                    static_cast<off_t>(offset + used), static_cast<off_t>(geometry.slot_bytes - used));
    }
    return {};
}

Result<void> Segment::write_slot(std::uint32_t index, std::span<const std::byte> bytes) {
    if (auto reserved = reserve_slot(index, bytes.size()); !reserved) return reserved;
    std::uint64_t offset = mapping_->geometry.slot_offset[index];
    while (!bytes.empty()) {
        const ssize_t put =
            ::pwrite(mapping_->object.descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return slot_error(name(), "cannot be written", put < 0 ? errno : ENOSPC);
        bytes = bytes.subspan(static_cast<std::size_t>(put));
        offset += static_cast<std::uint64_t>(put);
    }
    return {};
}

Result<void> Segment::read_slot(std::uint32_t index, std::span<std::byte> bytes) const {
    const SegmentGeometry& geometry = mapping_->geometry;
    if (index > 1 || bytes.size() > geometry.slot_bytes) {
        return bad_input("segment " + name() + ": a slot holds no " + std::to_string(bytes.size()) +
                         " bytes");
    }
    std::uint64_t offset = geometry.slot_offset[index];
    while (!bytes.empty()) {
        const ssize_t got =
            ::pread(mapping_->object.descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return slot_error(name(), "cannot be read", errno);
        if (got == 0) return bad_input("segment " + name() + ": was truncated by another process");
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return {};
}

}  // namespace psicarve
