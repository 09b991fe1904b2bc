// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace psicarve {

// The journal: what happened to a machine, over the restarts of its cores, as lines of text on a disk:
//
//   3f9a1c0e5d7b2468 seq=12 run=3 ms=1764204185123 tick=120 kind=alarm what="limit" axis="r1" layer=12
//
// First the XXH3 of all that follows the blank, in hexadecimal; then facts, a number or a text in quotes
// each. A line feed ends a record, and stands nowhere else: damage or a torn write spoils one line, and
// readers go on behind the next line feed.

enum class JournalKind : std::uint8_t { core, alarm, command, job };
inline constexpr std::size_t kJournalKindCount = 4;
std::string_view name_of(JournalKind kind) noexcept;  ///< "core", "alarm", "command", "job"
std::optional<JournalKind> journal_kind(std::string_view name) noexcept;

/// Values by name, in their order. A text that would make the record longer than kMostJournalLineBytes is
/// cut, and ends in "..." then.
class JournalFacts {
public:
    using Value = std::variant<std::int64_t, std::string>;

    JournalFacts& add(std::string name, std::int64_t value);
    JournalFacts& add(std::string name, std::string_view text);
    /// Nothing: no fact has this name and this type.
    std::optional<std::int64_t> number(std::string_view name) const;
    std::string text(std::string_view name) const;  ///< empty: no such fact
    const std::vector<std::pair<std::string, Value>>& all() const noexcept { return all_; }

private:
    std::vector<std::pair<std::string, Value>> all_;
};

struct JournalRecord {
    std::uint64_t sequence = 0;  ///< grows from record to record, whatever the clock does
    std::uint64_t run = 0;       ///< counts the cores
    std::int64_t time_ms = 0;    ///< since 1970, by the computer's clock, which may be set back
    std::uint64_t tick = 0;      ///< of that core; 0 where it has none
    JournalKind kind = JournalKind::core;
    std::string what;  ///< by kind: "start", "limit", "home", "loaded"
    JournalFacts facts;
};

inline constexpr std::size_t kMostJournalLineBytes = 4096;

/// The record as a line, with its line feed. Names of facts are a-z, 0-9 and _; others are left out.
std::string journal_line(const JournalRecord& record);
/// Reads a line without its line feed. Nothing: torn, damaged, or of a kind that this program does not know.
/// Trusts no byte.
std::optional<JournalRecord> parse_journal_line(std::string_view line);

}  // namespace psicarve
