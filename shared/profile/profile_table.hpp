// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shared/profile/profile.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::profile_detail {

// Internal to the profile's source files: the one table of keys that reads, prints, checks, compares and
// documents the profile. No other file includes this.

/// Where a key's value lives in a Profile.
using Field =
    std::variant<double*, std::int64_t*, int*, bool*, std::string*, std::array<double, 2>*, Schedule*,
                 HomeSensor*, Planner*, Joining*, PulseForm*, ToolShape*, AxisNames*, SecondHead*>;

/// A word that a file may say for a value that is no number.
struct Word {
    std::string_view text;
    std::uint8_t value;
};

/// Least and greatest value of a number, in the key's unit. For text: the length in bytes.
struct Bounds {
    double least = 0.0;
    double greatest = 0.0;
};

struct KeySpec {
    std::string path;  ///< "axis.r1.speed_mm_s"
    std::string unit;
    Bounds bounds;
    std::span<const Word> words;  ///< not empty: the value is one of these words
    std::string explanation;
    bool matters_to_motion = true;
    std::function<Field(Profile&)> field;
};

/// In the order in which they are printed; keys of one TOML table stand together.
const std::vector<KeySpec>& key_table();
const KeySpec* find_key(std::string_view path);

/// The same field, read-only.
Field field_of(const KeySpec& key, const Profile& profile);
/// The value as TOML: 10.0, 400, "max", [0.0, 60.0].
std::string value_as_toml(const KeySpec& key, const Profile& profile);
/// The value's bounds for people: "0.001 <= value <= 10000", "min, max or none".
std::string bounds_text(const KeySpec& key);
std::string number_as_toml(double value);
/// A number for messages: as short as possible, no needless ".0".
std::string number_text(double value);

/// A contradiction in a profile, before file and line are known.
struct Problem {
    std::string key;                ///< the key that the message names
    std::vector<std::string> also;  ///< other keys that take part: where the file does not give `key`, the
                                    ///< first of these that it gives tells the line
    std::string text;               ///< "what is wrong; remedy"
    bool blame_later = false;       ///< name the key that the file gives last
};

/// Checks values against each other; each alone is within its bounds. The built-in profile passes.
std::optional<Problem> check_profile(const Profile& profile);
std::optional<Problem> check_pins(const Profile& profile);
std::optional<Problem> check_pulse_rates(const Profile& profile);

}  // namespace psicarve::profile_detail
