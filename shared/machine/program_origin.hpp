// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace psicarve {

inline constexpr std::size_t kSourceNameBytes = 256;

/// Flags of a program's source, one bit each.
inline constexpr std::uint32_t kSourceIsStream = 1;  ///< it came once: neither size nor sum of its text
inline constexpr std::uint32_t kSourceStopsAtOptional = 2;
inline constexpr std::uint32_t kSourceSkipsDeleted = 4;
inline constexpr std::uint32_t kSourceIsDry = 8;
inline constexpr std::uint32_t kSourceIsIso = 16;
inline constexpr std::uint32_t kSourceIsSingle = 32;
inline constexpr std::uint32_t kSourceIsTyped = 64;  ///< a block that the operator typed, in a file
/// Each M1 is a record that the switch decides at the machine; without it those that stop are records alone.
inline constexpr std::uint32_t kSourceHasOptionalStops = 128;

/// What its writer told of a program's text: which it is, and how it is read. Trusted as little as all that
/// another process wrote.
struct ProgramOrigin {
    std::uint64_t from_line = 0;       ///< what lies before made no motion; 0, 1: all is run
    std::uint32_t flags = 0;           ///< kSource... bits
    char name[kSourceNameBytes] = {};  ///< of its file, as it was given; it may lack its zero
};

}  // namespace psicarve
