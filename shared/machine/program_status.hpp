// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace psicarve {

/// Why a program waits though no hold was asked for.
enum class ProgramHold : std::uint8_t {
    none = 0,
    program = 1,      ///< M0, M60
    optional = 2,     ///< M1
    tool_change = 3,  ///< M6
    single = 4,       ///< one block at a time: this one is done
    starved = 5,      ///< its next records have not come; it goes on when they do
    feeder_lost = 6,  ///< who wrote its records is gone: nothing is left but to stop
    refused = 7,      ///< the core did not take a record: nothing is left but to stop
};
inline constexpr std::uint8_t kProgramHoldCount = 8;
/// Nothing is left of the program: it can only be stopped.
constexpr bool is_for_good(ProgramHold hold) noexcept {
    return hold == ProgramHold::feeder_lost || hold == ProgramHold::refused;
}
/// "program stop", "tool change", "starved"...; nothing for none.
std::string_view name_of(ProgramHold hold) noexcept;

/// The program that runs, or the last that ran, as the tick has it.
struct ProgramStatus {
    std::uint64_t program;      ///< its number; 0: there was none
    std::uint64_t line;         ///< of the motion at hand, from 1; 0: none yet
    std::uint64_t sequence;     ///< of the motion record at hand, from 1; 0: none yet
    std::uint64_t starvations;  ///< how often the machine has waited for its records
    std::uint32_t is_running;   ///< 1: it was started and has not ended
    ProgramHold hold;           ///< none: it moves, or a command holds it
    std::uint8_t is_single;
    std::uint8_t is_done;  ///< 1: all of it that the core took is run; not so after a stop or an alarm
    std::uint8_t stops_at_optional;  ///< 1: it waits at the M1 that the machine comes to next
};
static_assert(sizeof(ProgramStatus) == 40 && std::is_trivially_copyable_v<ProgramStatus>);

}  // namespace psicarve
