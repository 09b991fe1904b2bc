// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/journal.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <system_error>

#include "shared/base/printable.hpp"

namespace psicarve {
namespace {

constexpr std::array<std::string_view, kJournalKindCount> kKindNames{"core", "alarm", "command", "job"};
constexpr std::size_t kChecksumLetters = 16;
constexpr std::size_t kMostTextBytes = 200;
constexpr std::size_t kMostFacts = 16;  // each at most four times as long once it is quoted

std::string checksum_text(std::string_view body) {
    std::array<char, kChecksumLetters + 1> digits{};
    (void)std::snprintf(digits.data(), digits.size(), "%016" PRIx64,
                        std::uint64_t{XXH3_64bits(body.data(), body.size())});
    return digits.data();
}

bool is_fact_name(std::string_view name) noexcept {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789_";
    return !name.empty() && name.size() <= 32 && name.find_first_not_of(kLetters) == std::string_view::npos;
}

bool is_plain(char letter) noexcept {
    const auto byte = static_cast<unsigned char>(letter);
    return byte >= 0x20 && byte != 0x7f && letter != '"' && letter != '\\';
}

std::string in_quotes(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string result = "\"";
    for (const char letter : text) {
        if (is_plain(letter)) {
            result += letter;
            continue;
        }
        const auto byte = static_cast<unsigned char>(letter);
        result += "\\x";
        result += kDigits[byte >> 4];
        result += kDigits[byte & 0xF];
    }
    return result + "\"";
}

std::string cut(std::string_view text) {
    if (text.size() <= kMostTextBytes) return std::string{text};
    constexpr std::string_view kCutMark = "...";
    text = text.substr(0, kMostTextBytes - kCutMark.size());
    return std::string{text.substr(0, text.size() - unfinished_letter_bytes(text))}.append(kCutMark);
}

/// Takes facts from the front of a record's body.
class FactScan {
public:
    explicit FactScan(std::string_view body) noexcept : rest_(body) {}

    bool is_at_end() const noexcept { return rest_.empty(); }
    /// Nothing: no fact begins here.
    std::optional<std::pair<std::string, JournalFacts::Value>> next() {
        const std::size_t equals = rest_.find('=');
        if (equals == std::string_view::npos || !is_fact_name(rest_.substr(0, equals))) return std::nullopt;
        std::string name{rest_.substr(0, equals)};
        rest_.remove_prefix(equals + 1);
        auto value = rest_.starts_with('"') ? text() : number();
        if (!value || !ends_here()) return std::nullopt;
        return std::pair{std::move(name), std::move(*value)};
    }

private:
    bool ends_here() noexcept {
        if (rest_.empty()) return true;
        if (rest_.front() != ' ' || rest_.size() == 1) return false;
        rest_.remove_prefix(1);
        return true;
    }
    std::optional<JournalFacts::Value> number() noexcept {
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    std::optional<JournalFacts::Value> text() {
        std::string result;
        for (std::size_t i = 1; i < rest_.size(); ++i) {
            if (rest_[i] == '"') {
                rest_.remove_prefix(i + 1);
                return result;
            }
            if (rest_[i] != '\\') {
                result += rest_[i];
                continue;
            }
            unsigned byte = 0;
            if (rest_.size() < i + 4 || rest_[i + 1] != 'x') return std::nullopt;
            const char* const digits = rest_.data() + i + 2;
            const auto [end, error] = std::from_chars(digits, digits + 2, byte, 16);
            if (error != std::errc{} || end != digits + 2) return std::nullopt;
            result += static_cast<char>(byte);
            i += 3;
        }
        return std::nullopt;
    }

    std::string_view rest_;
};

/// Puts the members of every record into their places, all else into the facts.
void put_into(JournalRecord& record, std::string name, JournalFacts::Value value, bool& has_kind) {
    if (const auto* number = std::get_if<std::int64_t>(&value)) {
        if (name == "seq")
            record.sequence = static_cast<std::uint64_t>(*number);
        else if (name == "run")
            record.run = static_cast<std::uint64_t>(*number);
        else if (name == "ms")
            record.time_ms = *number;
        else if (name == "tick")
            record.tick = static_cast<std::uint64_t>(*number);
        else
            record.facts.add(std::move(name), *number);
        return;
    }
    const std::string& text = std::get<std::string>(value);
    if (name == "kind") {
        const auto kind = journal_kind(text);
        has_kind = kind.has_value();
        record.kind = kind.value_or(JournalKind::core);
    } else if (name == "what") {
        record.what = text;
    } else {
        record.facts.add(std::move(name), text);
    }
}

}  // namespace

std::string_view name_of(JournalKind kind) noexcept {
    return kKindNames[static_cast<std::size_t>(kind)];
}

std::optional<JournalKind> journal_kind(std::string_view name) noexcept {
    const auto found = std::ranges::find(kKindNames, name);
    if (found == kKindNames.end()) return std::nullopt;
    return static_cast<JournalKind>(found - kKindNames.begin());
}

JournalFacts& JournalFacts::add(std::string name, std::int64_t value) {
    all_.emplace_back(std::move(name), value);
    return *this;
}

JournalFacts& JournalFacts::add(std::string name, std::string_view text) {
    all_.emplace_back(std::move(name), cut(text));
    return *this;
}

std::optional<std::int64_t> JournalFacts::number(std::string_view name) const {
    for (const auto& [known, value] : all_)
        if (known == name && std::holds_alternative<std::int64_t>(value))
            return std::get<std::int64_t>(value);
    return std::nullopt;
}

std::string JournalFacts::text(std::string_view name) const {
    for (const auto& [known, value] : all_)
        if (known == name && std::holds_alternative<std::string>(value)) return std::get<std::string>(value);
    return {};
}

std::string journal_line(const JournalRecord& record) {
    std::string body = "seq=" + std::to_string(record.sequence) + " run=" + std::to_string(record.run) +
                       " ms=" + std::to_string(record.time_ms) + " tick=" + std::to_string(record.tick) +
                       " kind=" + in_quotes(name_of(record.kind)) + " what=" + in_quotes(cut(record.what));
    std::size_t left = kMostFacts;
    for (const auto& [name, value] : record.facts.all()) {
        if (!is_fact_name(name) || left == 0) continue;
        const auto* number = std::get_if<std::int64_t>(&value);
        const std::string fact =
            " " + name + "=" +
            (number != nullptr ? std::to_string(*number) : in_quotes(std::get<std::string>(value)));
        if (kChecksumLetters + body.size() + fact.size() + 2 > kMostJournalLineBytes) continue;
        body += fact;
        --left;
    }
    return checksum_text(body) + " " + body + "\n";
}

std::optional<JournalRecord> parse_journal_line(std::string_view line) {
    if (line.size() < kChecksumLetters + 2 || line.size() >= kMostJournalLineBytes) return std::nullopt;
    if (line[kChecksumLetters] != ' ') return std::nullopt;
    const std::string_view body = line.substr(kChecksumLetters + 1);
    if (checksum_text(body) != line.substr(0, kChecksumLetters)) return std::nullopt;
    JournalRecord record;
    bool has_kind = false;
    for (FactScan scan{body}; !scan.is_at_end();) {
        auto fact = scan.next();
        if (!fact) return std::nullopt;
        put_into(record, std::move(fact->first), std::move(fact->second), has_kind);
    }
    if (!has_kind) return std::nullopt;
    return record;
}

}  // namespace psicarve
