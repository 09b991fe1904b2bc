// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "shared/machine/program_origin.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve {

inline constexpr std::size_t kSourceNumbers = 120;
inline constexpr std::size_t kSourceProfileBytes = 48UL * 1024UL;

/// Of which text a program's records are, and how it was read: all that is needed to make the same records of
/// the same text. Written by the program's writer. Nothing moves by it; whoever reads it trusts none of it.
struct ProgramSource {
    std::uint64_t program;     ///< its number; 0: nobody has told anything
    std::uint64_t text_bytes;  ///< of a file
    std::uint64_t text_sum;    ///< of a file: TextSum over its bytes
    std::uint64_t from_line;   ///< what lies before made no motion; 0, 1: all was run
    std::uint32_t flags;
    std::uint32_t profile_bytes;                        ///< of `profile` in use
    std::array<std::int64_t, kAxisCount> start_pulses;  ///< by Axis: where the machine stood
    /// Work offsets and references that it began with, in the order of hmi/offsets/source_numbers.hpp.
    std::array<double, kSourceNumbers> kept;
    char name[kSourceNameBytes];        ///< of the file, zero-terminated; a longer one is cut
    char profile[kSourceProfileBytes];  ///< of the machine, as TOML
};
static_assert(sizeof(ProgramSource) % 8 == 0 && std::is_trivially_copyable_v<ProgramSource>,
              "bump kLayoutVersion");

/// A source, and what the core had taken of it when a snapshot was made.
struct RecordedSource {
    std::uint64_t taken;       ///< records
    std::uint64_t record_sum;  ///< with_record() over them
    std::uint32_t end;         ///< ProgramEnd
    std::uint32_t reserved;
    ProgramSource source;
};
static_assert(std::is_trivially_copyable_v<RecordedSource>);

/// A sum over records in their order, each by its check; 0 before the first. A bijection of the sum so far
/// for a fixed check, and of the check for a fixed sum.
constexpr std::uint64_t with_record(std::uint64_t sum, std::uint64_t record_check) noexcept {
    constexpr std::uint64_t kOddFactor = 0x9E37'79B9'7F4A'7C15U;
    constexpr unsigned kHalfWord = 32;
    sum = (sum ^ record_check) * kOddFactor;
    return sum ^ sum >> kHalfWord;
}

}  // namespace psicarve
