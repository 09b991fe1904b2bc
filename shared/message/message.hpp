// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "shared/message/message_id.hpp"

namespace psicarve {

// What one part of Psicarve says to another: an identifier with typed arguments. Words are made of it where
// they are shown (shared/wording for English, hmi/phrase for the window). It stands in the segment, so a
// reader takes nothing of it for granted: not the number, the kinds or the values.

/// What an argument is, and its unit. The numbers are part of the segment's layout.
enum class ArgumentKind : std::uint8_t {
    none = 0,
    count = 1,   ///< so many; also a process' number
    pulses = 2,  ///< signed
    layer = 3,
    point = 4,
    ms = 5,
    mm = 6,     ///< a double, as the two below
    mm_s = 7,   ///< mm/s
    deg_s = 8,  ///< deg/s
    axis = 9,
    signal = 10,
    signals = 11,  ///< a set, bit by signal
    state = 12,
    states = 13,   ///< a list, the first in the lowest four bits: state + 1
    way_out = 14,  ///< what to do in this state
    command = 15,
    alarm_cause = 16,
    alarm_remedy = 17,  ///< of this cause
    text = 18,          ///< the message's one text; the value is 0
};
inline constexpr std::uint8_t kArgumentKindCount = 19;

struct Argument {
    ArgumentKind kind;
    std::uint8_t reserved[7];
    std::uint64_t bits;  ///< the number by its kind

    constexpr double number() const noexcept { return std::bit_cast<double>(bits); }
    constexpr std::int64_t signed_number() const noexcept { return static_cast<std::int64_t>(bits); }
};
static_assert(sizeof(Argument) == 16 && std::is_trivially_copyable_v<Argument>, "bump kLayoutVersion");

inline constexpr std::size_t kMessageArguments = 8;
inline constexpr std::size_t kMessageTextBytes = 256;

/// Fixed-size, without pointers. The text is of a segment, a port, a file: set and read it with
/// shared/base/message_text.hpp.
struct Message {
    MessageId id;
    std::uint16_t argument_count;
    std::uint32_t reserved;
    Argument arguments[kMessageArguments];
    char text[kMessageTextBytes];

    constexpr bool is_none() const noexcept { return id == MessageId::none; }
};
static_assert(sizeof(Message) == 392 && std::is_trivially_copyable_v<Message>, "bump kLayoutVersion");

constexpr Argument argument(ArgumentKind kind, std::uint64_t bits) noexcept {
    return {kind, {}, bits};
}
constexpr Argument count_argument(std::uint64_t count) noexcept {
    return argument(ArgumentKind::count, count);
}
constexpr Argument layer_argument(std::uint64_t layer) noexcept {
    return argument(ArgumentKind::layer, layer);
}
constexpr Argument point_argument(std::uint64_t point) noexcept {
    return argument(ArgumentKind::point, point);
}
constexpr Argument pulses_argument(std::int64_t pulses) noexcept {
    return argument(ArgumentKind::pulses, static_cast<std::uint64_t>(pulses));
}
constexpr Argument ms_argument(std::uint64_t duration_ms) noexcept {
    return argument(ArgumentKind::ms, duration_ms);
}
constexpr Argument mm_argument(double length_mm) noexcept {
    return argument(ArgumentKind::mm, std::bit_cast<std::uint64_t>(length_mm));
}
constexpr Argument mm_s_argument(double speed_mm_s) noexcept {
    return argument(ArgumentKind::mm_s, std::bit_cast<std::uint64_t>(speed_mm_s));
}
constexpr Argument deg_s_argument(double speed_deg_s) noexcept {
    return argument(ArgumentKind::deg_s, std::bit_cast<std::uint64_t>(speed_deg_s));
}

/// Its arguments stand in the order of the table of words (shared/wording); a text comes last, by
/// with_text().
template <typename... Arguments>
constexpr Message message_of(MessageId id, Arguments... arguments) noexcept {
    static_assert(sizeof...(Arguments) <= kMessageArguments);
    Message message{};
    message.id = id;
    for (const Argument& one : std::array<Argument, sizeof...(Arguments)>{arguments...})
        message.arguments[message.argument_count++] = one;
    return message;
}

}  // namespace psicarve
