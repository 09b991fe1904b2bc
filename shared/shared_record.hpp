// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <optional>

#include "shared/layout.hpp"

namespace psicarve {

inline constexpr int kRecordRetries = 1000;

/// One writer only. Never waits.
template <typename T>
void write_record(SharedRecord<T>& record, const T& value) noexcept;
/// Any process. Nothing when the writer kept it odd or changing for all retries (it died halfway, or writes
/// without a pause): the caller keeps its last good copy.
template <typename T>
std::optional<T> read_record(const SharedRecord<T>& record, int retries = kRecordRetries) noexcept;

/// One writer only. Never waits; overwrites the oldest.
template <typename T, std::size_t kEntries>
void append_to_ring(SharedRing<T, kEntries>& ring, const T& value) noexcept;

/// Reads a ring from where it stands; several readers do not know of each other.
template <typename T, std::size_t kEntries>
class RingReader {
public:
    /// Starts at the oldest entry still there, or (from_now) behind the newest.
    explicit RingReader(const SharedRing<T, kEntries>& ring, bool from_now = false) noexcept;
    /// The next entry; nothing when there is none yet.
    std::optional<T> next() noexcept;
    /// Entries that were overwritten before they could be read.
    std::uint64_t lost() const noexcept { return lost_; }

private:
    const SharedRing<T, kEntries>* ring_;
    std::uint64_t position_ = 0;
    std::uint64_t lost_ = 0;
};

}  // namespace psicarve
