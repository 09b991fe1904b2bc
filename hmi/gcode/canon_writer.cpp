// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/canon_writer.hpp"

#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

namespace psicarve::gcode {
namespace {

constexpr std::size_t kFirstSecondary = 6;  // U
constexpr int kDecimals = 6;

void append_number(std::string& text, double value) {
    std::array<char, 400> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                            std::chars_format::fixed, kDecimals);
    if (error != std::errc{}) {
        text += "null";
        return;
    }
    std::string_view shown(digits.data(), static_cast<std::size_t>(end - digits.data()));
    while (shown.back() == '0') shown.remove_suffix(1);
    if (shown.back() == '.') shown.remove_suffix(1);
    text += shown == "-0" ? std::string_view{"0"} : shown;
}

void append_member(std::string& text, std::string_view name, double value) {
    text += ",\"";
    text += name;
    text += "\":";
    append_number(text, value);
}

void append_word(std::string& text, std::string_view name, std::string_view value) {
    text += ",\"";
    text += name;
    text += "\":\"";
    text += value;
    text += '"';
}

void append_flag(std::string& text, std::string_view name, bool value) {
    text += ",\"";
    text += name;
    text += value ? "\":true" : "\":false";
}

void append_axes(std::string& text, const Position& position, std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) {
        text += axis == begin ? '[' : ',';
        append_number(text, position[axis]);
    }
    text += ']';
}

void append_motion(std::string& text, const CanonRecord& record) {
    text += ",\"end\":";
    append_axes(text, record.end, 0, kFirstSecondary);
    if (record.end[6] != 0.0 || record.end[7] != 0.0 || record.end[8] != 0.0) {
        text += ",\"uvw\":";
        append_axes(text, record.end, kFirstSecondary, kLetterCount);
    }
    if (record.kind != CanonKind::rapid) append_member(text, "f", record.feed_per_min);
    if (record.ends_within) append_flag(text, "within", true);
    if (record.kind != CanonKind::arc) return;
    append_word(text, "plane", record.plane->name);
    text += ",\"ctr\":[";
    append_number(text, record.centre_first_mm);
    text += ',';
    append_number(text, record.centre_second_mm);
    text += ']';
    append_member(text, "rot", record.turns);
}

std::string_view spindle_word(int code) noexcept {
    return code == 3 ? "cw" : (code == 4 ? "ccw" : "off");
}

std::string_view path_word(int code) noexcept {
    return code == 610 ? "exact_path" : (code == 611 ? "exact_stop" : "blend");
}

std::string_view stop_word(int code) noexcept {
    return code == 0 ? "program" : (code == 1 ? "optional" : "pallet");
}

void append_output(std::string& text, const CanonRecord& record) {
    append_member(text, "n", record.value);
    append_flag(text, "on", record.code == 62 || record.code == 64);
    append_flag(text, "with_motion", record.code == 62 || record.code == 63);
}

void append_details(std::string& text, const CanonRecord& record) {
    switch (record.kind) {
        case CanonKind::rapid:
        case CanonKind::feed:
        case CanonKind::arc:
            return append_motion(text, record);
        case CanonKind::dwell:
            return append_member(text, "s", record.value);
        case CanonKind::speed:
            return append_member(text, "rpm", record.value);
        case CanonKind::spindle:
            return append_word(text, "dir", spindle_word(record.code));
        case CanonKind::coolant:
            append_flag(text, "on", record.code != 9);
            if (record.code != 9) append_word(text, "which", record.code == 7 ? "mist" : "flood");
            return;
        case CanonKind::tool_select:
        case CanonKind::tool_change:
            return append_member(text, "t", record.value);
        case CanonKind::path:
            append_word(text, "mode", path_word(record.code));
            if (record.code == 640) append_member(text, "p", record.value);
            return;
        case CanonKind::override_set:
            append_member(text, "m", record.code);
            append_member(text, "p", record.value);
            return;
        case CanonKind::output:
            return append_output(text, record);
        case CanonKind::input:
            return append_member(text, "n", record.value);
        case CanonKind::stop:
            return append_word(text, "why", stop_word(record.code));
        case CanonKind::end:
            return;
    }
}

constexpr std::array<std::string_view, 15> kKindNames{"rapid",    "feed",    "arc",   "dwell",       "speed",
                                                      "spindle",  "coolant", "tool",  "tool_change", "path",
                                                      "override", "output",  "input", "stop",        "end"};

}  // namespace

void append_canon_line(const CanonRecord& record, std::string& text) {
    text += "{\"k\":\"";
    text += kKindNames[static_cast<std::size_t>(record.kind)];
    text += '"';
    append_member(text, "line", static_cast<double>(record.line));
    append_details(text, record);
    text += "}\n";
}

}  // namespace psicarve::gcode
