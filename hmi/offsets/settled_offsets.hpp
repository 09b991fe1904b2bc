// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hmi/offsets/offsets_file.hpp"
#include "hmi/offsets/offsets_lock.hpp"
#include "shared/base/result.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::offsets {

/// What has become of a program whose offsets are pending, by what its core says.
enum class ProgramFate : std::uint8_t {
    ended,    ///< in order, all of it run: they are kept
    running,  ///< not known yet
    failed,   ///< stopped, failed, or not known any more: they are dropped
};

/// The run of a program in the core that serves the segment now.
ProgramIdentity identity_of(const Segment& segment, std::uint64_t program);
/// An error where the core's words cannot be read.
Result<ProgramFate> fate_of(const Segment& segment, const ProgramIdentity& program);

/// Whose the offsets are.
struct OffsetsOwner {
    std::string segment;
    std::string group;
};
struct Settled {
    Offsets offsets;      ///< pending: of a program that still runs
    std::string warning;  ///< empty: nothing was dropped
};
/// As read_offsets(), with what a program has left pending kept or dropped, also in the file. The lock is
/// that of the place.
Result<Settled> settle_offsets(const OffsetsPlace& place, const GcodeProfile& letters,
                               const OffsetsOwner& owner, const OffsetsLock& lock);
/// The same without a lock, for who only reads: in the file it is settled where that is possible. While
/// another process has the lock nothing is settled: a program runs.
Result<Settled> settled_offsets(const OffsetsPlace& place, const GcodeProfile& letters,
                                const OffsetsOwner& owner);

}  // namespace psicarve::offsets
