// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/number_reader.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <system_error>

#include "hmi/gcode/block.hpp"

namespace psicarve::gcode {
namespace {

/// Whole numbers and powers up to these are exact, and so is their quotient's rounding.
constexpr int kExactDigits = 15;
constexpr std::array<double, 16> kTenTo{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
constexpr double kLargestMagnitude = 1e9;

bool is_digit(char byte) noexcept {
    return byte >= '0' && byte <= '9';
}

/// Digits and a point, without the blanks between them.
struct PlainDigits {
    std::array<char, kMostLineBytes + 1> bytes;
    std::size_t count = 0;

    double value() const noexcept {
        double number = 0.0;
        const auto [end, error] =
            std::from_chars(bytes.data(), bytes.data() + count, number, std::chars_format::fixed);
        return error == std::errc{} ? number : kLargestMagnitude * 2.0;
    }
};

double long_number(std::string_view line, std::size_t begin, std::size_t end) noexcept {
    PlainDigits plain;
    for (std::size_t at = begin; at < end; ++at)
        if (is_digit(line[at]) || line[at] == '.') plain.bytes[plain.count++] = line[at];
    return plain.value();
}

}  // namespace

NumberReading read_number(std::string_view line, std::size_t begin) noexcept {
    NumberReading reading;
    bool is_negative = false;
    bool has_sign = false;
    bool has_point = false;
    int digits = 0;
    int decimals = 0;
    std::uint64_t whole = 0;
    std::size_t at = begin;
    for (; at < line.size(); ++at) {
        const char byte = line[at];
        if (is_digit(byte)) {
            reading.has_digits = true;
            if (digits < kExactDigits) whole = whole * 10U + static_cast<std::uint64_t>(byte - '0');
            if (whole > 0 || has_point) ++digits;
            if (has_point) ++decimals;
        } else if (byte == '.' && !has_point) {
            has_point = true;
        } else if ((byte == '-' || byte == '+') && !has_sign && !has_point && !reading.has_digits) {
            has_sign = true;
            is_negative = byte == '-';
        } else if (byte != ' ' && byte != '\t') {
            break;
        }
    }
    reading.end = at;
    if (!reading.has_digits) return reading;
    const double magnitude = digits <= kExactDigits && decimals <= kExactDigits
                                 ? static_cast<double>(whole) / kTenTo[static_cast<std::size_t>(decimals)]
                                 : long_number(line, begin, at);
    if (magnitude <= kLargestMagnitude) reading.value = is_negative ? -magnitude : magnitude;
    return reading;
}

}  // namespace psicarve::gcode
