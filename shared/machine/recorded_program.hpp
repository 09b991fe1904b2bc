// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "shared/machine/program_status.hpp"
#include "shared/machine/status.hpp"

namespace psicarve {

/// What the flight recorder tells of a program: low byte of the code of its records.
enum class ProgramEvent : std::uint8_t {
    begun = 0,  ///< value: the program's number; detail: kProgram... bits of its command
    line = 1,   ///< it is in that line: at most once a second, while it moves
    held = 2,   ///< it rests; detail: ProgramHold, none where a command holds it. starved: it did, axis
                ///< times since it was told so (kNoAxis: once), and goes on without a word
    resumed = 3,
    stopping = 4,  ///< it slows down, and is not gone on with
    ended = 5,     ///< detail: ProgramEnding
};
inline constexpr std::uint8_t kProgramEventCount = 6;

enum class ProgramEnding : std::uint8_t { done = 0, stopped = 1, alarm = 2 };
inline constexpr std::uint8_t kProgramEndingCount = 3;

/// "begun", "line", "held"...
std::string_view name_of(ProgramEvent event) noexcept;
/// "done", "stopped", "alarm"
std::string_view name_of(ProgramEnding ending) noexcept;

// A record of kind program. All but the first: value is the line of the motion at hand, from 1, answer the
// sequence of its motion record, each 0 where none is at hand yet; a larger sequence than fits is the largest
// that does. RT: yes.

constexpr std::uint16_t recorded_code(ProgramEvent event, std::uint8_t detail = 0) noexcept {
    return static_cast<std::uint16_t>(static_cast<unsigned>(event) | unsigned{detail} << 8U);
}
constexpr std::uint32_t recorded_sequence(std::uint64_t sequence) noexcept {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(sequence, kMost));
}
/// A number from a file may be anything.
constexpr ProgramEvent program_event_of(const FlightRecord& record) noexcept {
    return static_cast<ProgramEvent>(record.code & 0xFFU);
}
constexpr std::uint8_t program_detail_of(const FlightRecord& record) noexcept {
    return static_cast<std::uint8_t>(record.code >> 8U);
}
constexpr bool is_of_program(const FlightRecord& record, ProgramEvent event) noexcept {
    return record.kind == RecordKind::program && program_event_of(record) == event;
}

/// How often it has starved by this record: 0 for all others. Records before layout 16 say no number.
constexpr std::uint32_t recorded_starvations(const FlightRecord& record) noexcept {
    const bool is_starved = is_of_program(record, ProgramEvent::held) &&
                            program_detail_of(record) == static_cast<std::uint8_t>(ProgramHold::starved);
    if (!is_starved) return 0;
    return record.axis == kNoAxis ? 1 : record.axis;
}

/// The override that carves as planned, in per cent.
inline constexpr std::uint32_t kFullFeed_percent = 100;

/// It came to its end, and with that an override above 100 % did.
constexpr bool is_program_done(const FlightRecord& record) noexcept {
    return is_of_program(record, ProgramEvent::ended) &&
           program_detail_of(record) == static_cast<std::uint8_t>(ProgramEnding::done);
}

/// Takes what a record tells into what is known of the last program before it. An alarm ends it. Where the
/// recorder has lost its beginning the program has no number.
void take_record(ProgramStatus& program, const FlightRecord& record) noexcept;
/// The last program of a recorder, oldest record first, as the last record has it. program and line 0: there
/// was none.
ProgramStatus recorded_program(std::span<const FlightRecord> records) noexcept;
/// The same as the status at that recorder's end has it; null: none is known. A program that has starved goes
/// on without a word, and the status knows whether it rests.
ProgramStatus recorded_program(std::span<const FlightRecord> records, const CoreStatus* status) noexcept;

}  // namespace psicarve
