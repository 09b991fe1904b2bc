// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "shared/base/result.hpp"
#include "shared/segment/layout.hpp"
#include "shared/segment/segment_object.hpp"

namespace psicarve {

/// What the first bytes of a shared-memory object say about it.
enum class HeaderState {
    usable,
    half_made,        ///< empty, or ours and not ready: its creator is at work, or dead
    earlier_boot,     ///< ours, left over from an earlier boot
    left_behind,      ///< of another layout or build; its creator is dead, and no core serves it
    not_ours,         ///< no magic: another program's, or garbage
    foreign_version,  ///< made by a program with another layout
    foreign_abi,      ///< same version, other sizes: another compiler or word width
    wrong_numbers,    ///< capacities or offsets that are impossible
    wrong_size,       ///< truncated or longer than it says
};

/// The header's fixed part, copied out of the object and checked. Nothing is read twice.
struct HeaderFacts {
    HeaderState state = HeaderState::not_ours;
    std::uint32_t layout_version = 0;
    std::uint32_t capacity_layers = 0;
    std::uint32_t capacity_points = 0;
    std::uint32_t capacity_records = 0;
    SegmentGeometry geometry{};
    std::int64_t size_bytes = 0;
    std::uint32_t creator_pid = 0;
    std::uint64_t creator_start_time = 0;
};

/// Reads through the file descriptor, so that no object, however short, can cause SIGBUS.
HeaderFacts examine_header(const SegmentObject& object);
/// The object has no user any more: a process that needs the name may take it.
constexpr bool is_stale(HeaderState state) noexcept {
    return state == HeaderState::earlier_boot || state == HeaderState::left_behind;
}
/// Its contents are not as this program leaves them.
constexpr bool is_damaged(HeaderState state) noexcept {
    return state == HeaderState::not_ours || state == HeaderState::wrong_numbers ||
           state == HeaderState::wrong_size;
}
/// What is wrong and what to do. For the states from `not_ours` on.
Error refusal_of(const HeaderFacts& facts, const std::string& name);

/// Fills a fresh, mapped, zeroed segment; `ready` last.
Result<void> fill_header(SegmentHeader& header, std::uint32_t capacity_layers, std::uint32_t capacity_points,
                         std::uint32_t capacity_records);

}  // namespace psicarve
