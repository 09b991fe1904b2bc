// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/trace/vcd_header.hpp"

#include <charconv>
#include <limits>

#include "shared/base/units.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::verify {

namespace {

std::string_view next_word(std::string_view& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n\v\f");
    if (begin == std::string_view::npos) return text = {};
    const std::size_t end = std::min(text.find_first_of(" \t\r\n\v\f", begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Tools write "r1_step", "r1_step[0:0]" or "port.r1_step" for the same thing.
std::string_view bare_name(std::string_view name) {
    name = name.substr(0, name.find('['));
    const std::size_t dot = name.find_last_of("./");
    return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

/// "r1=1 r2=2 psi=3 y=4", all four.
template <typename Accepts>
std::optional<std::array<std::int64_t, kAxisCount>> four_axes(std::string_view text, Accepts accepts) {
    std::array<std::int64_t, kAxisCount> pulses{};
    unsigned seen = 0;
    for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos) return std::nullopt;
        const auto axis = axis_from_name(word.substr(0, equals));
        const auto value = whole_number(word.substr(equals + 1));
        if (!axis || !value || !accepts(*value)) return std::nullopt;
        pulses[index_of(*axis)] = *value;
        seen |= 1U << index_of(*axis);
    }
    if (seen != (1U << kAxisCount) - 1) return std::nullopt;
    return pulses;
}

}  // namespace

void VcdWires::declare(std::string_view identifier, std::string_view name, std::string_view bits) {
    std::int8_t wire = kNotOurs;
    if (const auto signal = signal_from_name(bare_name(name)); signal && bits == "1") {
        if ((present_ & bit_of(*signal)) == 0) {
            present_ |= bit_of(*signal);
            wire = static_cast<std::int8_t>(index_of(*signal));
        }
    }
    // One identifier may carry several names (an alias in another scope): ours wins.
    if (find(identifier) >= 0) return;
    if (identifier.size() == 1) {
        short_[at(identifier[0])] = wire;
    } else if (identifier.size() == 2) {
        short_[kFirst + at(identifier[0]) * kFirst + at(identifier[1])] = wire;
    } else {
        long_[std::string(identifier)] = wire;
    }
}

std::optional<VcdTimescale> VcdTimescale::from_text(std::string_view text) {
    std::string squeezed;
    while (true) {
        const std::string_view word = next_word(text);
        if (word.empty()) break;
        squeezed += word;
    }
    const std::size_t unit_at = std::min(squeezed.find_first_not_of("0123456789"), squeezed.size());
    const auto number = whole_number(std::string_view(squeezed).substr(0, unit_at));
    if (!number || (*number != 1 && *number != 10 && *number != 100)) return std::nullopt;
    struct Unit {
        std::string_view name;
        std::int64_t ns;
        std::int64_t per_ns;
    };
    for (const Unit& unit : {Unit{"s", kNsPerS, 1}, Unit{"ms", kNsPerMs, 1}, Unit{"us", kNsPerUs, 1},
                             Unit{"ns", 1, 1}, Unit{"ps", 1, 1'000}, Unit{"fs", 1, 1'000'000}}) {
        if (squeezed.substr(unit_at) == unit.name) return VcdTimescale{*number * unit.ns, unit.per_ns};
    }
    return std::nullopt;
}

std::optional<std::int64_t> VcdTimescale::to_ns(std::uint64_t time) const noexcept {
    constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() / 4);
    if (time > kMost / static_cast<std::uint64_t>(multiply)) return std::nullopt;
    return static_cast<std::int64_t>(time) * multiply / divide;
}

VcdComment VcdComment::from_text(std::string_view text) {
    VcdComment comment;
    const std::string_view kind = next_word(text);
    if (kind == "period_ns") comment.period_ns = whole_number(next_word(text));
    if (comment.period_ns && *comment.period_ns <= 0) comment.period_ns.reset();
    if (kind == "position_pulses") comment.position_pulses = four_axes(text, is_trace_position);
    if (kind == "crossed_pulses") {
        comment.crossed_pulses = four_axes(text, is_trace_gap);
        comment.is_damaged = !comment.crossed_pulses;
    }
    return comment;
}

}  // namespace psicarve::verify
