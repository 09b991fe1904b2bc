// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets as JSON and back.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/offsets/offsets_file.hpp"

namespace psicarve::offsets {
namespace {

using Json = nlohmann::ordered_json;
using gcode::kAxisLetters;
using gcode::KeptOffsets;
using gcode::kLetterCount;
using gcode::kSystemNames;
using gcode::Position;

constexpr const char* kFormatKey = "psicarve_offsets";
constexpr int kFormat = 1;
constexpr const char* kRotation = "R";
constexpr std::size_t kMostNameBytes = 256;
constexpr std::array<const char*, 2> kReferenceNames{"g28", "g30"};

std::string_view name_of_letters(const GcodeProfile& letters) noexcept {
    return letters.letters == AxisNames::turning ? "turning" : "machine";
}
std::string_view name_of_head(const GcodeProfile& letters) noexcept {
    return letters.second_head == SecondHead::follow ? "follow" : "own";
}

Json json_of(const Position& position) {
    auto object = Json::object();
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        object[std::string{kAxisLetters[axis]}] = position[axis];
    return object;
}

Json json_of(const KeptOffsets& kept) {
    auto systems = Json::object();
    for (std::size_t system = 0; system < kept.systems.size(); ++system) {
        if (kept.systems[system] == gcode::SystemOffset{}) continue;
        auto object = json_of(kept.systems[system].origin);
        object[kRotation] = kept.systems[system].rotation_deg;
        systems[std::string{kSystemNames[system]}] = std::move(object);
    }
    Json object{{"systems", std::move(systems)}};
    if (kept.is_shifted || kept.shift != Position{}) {
        auto shift = json_of(kept.shift);
        shift["in_force"] = kept.is_shifted;
        object["g92"] = std::move(shift);
    }
    for (std::size_t which = 0; which < kReferenceNames.size(); ++which)
        if (kept.references[which]) object[kReferenceNames[which]] = json_of(*kept.references[which]);
    return object;
}

/// Reads JSON and remembers the first thing that is wrong.
class Reading {
public:
    bool is_wrong() const noexcept { return !what_.empty(); }
    const std::string& what() const noexcept { return what_; }
    void refuse(const std::string& what) {
        if (what_.empty()) what_ = what;
    }

    const Json& object_in(const Json& object, const char* key) {
        static const Json kNone = Json::object();
        const auto found = object.find(key);
        if (found == object.end()) return kNone;
        if (found->is_object()) return *found;
        refuse(std::string{key} + " is no object");
        return kNone;
    }
    void allow_only(const Json& object, std::initializer_list<std::string_view> keys) {
        for (const auto& entry : object.items())
            if (std::ranges::find(keys, entry.key()) == keys.end()) refuse(entry.key() + " is not known");
    }
    double number(const std::string& name, const Json& value) {
        const double read = value.is_number() ? value.get<double>() : NAN;
        if (std::isfinite(read) && std::abs(read) <= gcode::kMostOffset) return read;
        refuse(name + " is no number that an offset can have");
        return 0.0;
    }
    std::uint64_t count(const Json& object, const char* key) {
        const auto found = object.find(key);
        if (found != object.end() && found->is_number_unsigned()) return found->get<std::uint64_t>();
        refuse(std::string{key} + " is no number");
        return 0;
    }
    std::string name(const Json& object, const char* key) {
        const auto found = object.find(key);
        if (found != object.end() && found->is_string() &&
            found->get_ref<const std::string&>().size() <= kMostNameBytes)
            return found->get<std::string>();
        refuse(std::string{key} + " is no name");
        return {};
    }
    /// All letters, and what else the caller has a place for.
    template <typename TakeOther>
    Position position(const std::string& name, const Json& object, const TakeOther& take_other) {
        Position read{};
        for (const auto& entry : object.items()) {
            const std::string& key = entry.key();
            const std::size_t axis = key.size() == 1 ? kAxisLetters.find(key[0]) : std::string_view::npos;
            if (axis != std::string_view::npos) {
                read[axis] = number(std::string{name}.append(" ").append(key), entry.value());
            } else if (!take_other(key, entry.value())) {
                refuse(std::string{name}.append(" has no ").append(key));
            }
        }
        for (const char letter : kAxisLetters)
            if (!object.contains(std::string{letter})) refuse(name + " lacks " + letter);
        return read;
    }

    KeptOffsets kept(const Json& object) {
        KeptOffsets read;
        for (const auto& entry : object_in(object, "systems").items()) {
            const auto found = std::ranges::find(kSystemNames, entry.key());
            if (found == kSystemNames.end() || !entry.value().is_object()) {
                refuse("system " + entry.key() + " is not known");
                continue;
            }
            gcode::SystemOffset& system =
                read.systems[static_cast<std::size_t>(found - kSystemNames.begin())];
            system.origin =
                position(entry.key(), entry.value(), [&](const std::string& key, const Json& value) {
                    if (key != kRotation) return false;
                    system.rotation_deg = number(entry.key() + " R", value);
                    return true;
                });
            if (!entry.value().contains(kRotation)) refuse(entry.key() + " lacks " + kRotation);
        }
        if (object.contains("g92")) {
            const Json& shift = object_in(object, "g92");
            read.shift = position("g92", shift, [&](const std::string& key, const Json& value) {
                if (key != "in_force" || !value.is_boolean()) return false;
                read.is_shifted = value.get<bool>();
                return true;
            });
            if (!shift.contains("in_force")) refuse("g92 lacks in_force");
        }
        for (std::size_t which = 0; which < kReferenceNames.size(); ++which) {
            if (!object.contains(kReferenceNames[which])) continue;
            read.references[which] =
                position(kReferenceNames[which], object_in(object, kReferenceNames[which]),
                         [](const std::string&, const Json&) { return false; });
        }
        return read;
    }

    ProfileMark profile(const Json& object) {
        allow_only(object, {"name", "xxh3"});
        return {name(object, "name"), count(object, "xxh3")};
    }

    Pending pending(const Json& object) {
        allow_only(object, {"segment", "boot_id", "core_pid", "core_start_time", "program", "offsets"});
        Pending read;
        read.of.segment = name(object, "segment");
        read.of.boot_id = name(object, "boot_id");
        const std::uint64_t pid = count(object, "core_pid");
        if (pid > std::numeric_limits<std::uint32_t>::max()) refuse("core_pid is no process");
        read.of.core_pid = static_cast<std::uint32_t>(pid);
        read.of.core_start_time = count(object, "core_start_time");
        read.of.program = count(object, "program");
        const Json& offsets = object_in(object, "offsets");
        allow_only(offsets, {"systems", "g92", "g28", "g30"});
        read.offsets = kept(offsets);
        return read;
    }

private:
    std::string what_;
};

Json json_of(const Pending& pending) {
    return {{"segment", pending.of.segment},   {"boot_id", pending.of.boot_id},
            {"core_pid", pending.of.core_pid}, {"core_start_time", pending.of.core_start_time},
            {"program", pending.of.program},   {"offsets", json_of(pending.offsets)}};
}

Error begin_anew(const std::string& what) {
    return bad_input(what + ", or begin anew: psicarve gcode offsets clear all");
}

}  // namespace

std::string text_of(const Offsets& offsets, const GcodeProfile& letters) {
    Json object{
        {kFormatKey, kFormat}, {"letters", name_of_letters(letters)}, {"second_head", name_of_head(letters)}};
    object.update(json_of(offsets.kept));
    if (offsets.profile)
        object["profile"] = {{"name", offsets.profile->name.substr(0, kMostNameBytes)},
                             {"xxh3", offsets.profile->hash}};
    if (offsets.pending) object["pending"] = json_of(*offsets.pending);
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Offsets> offsets_from(std::string_view text, const GcodeProfile& letters) {
    const Json object = Json::parse(text, nullptr, false);
    if (!object.is_object() || !object.contains(kFormatKey) || !object[kFormatKey].is_number_integer())
        return begin_anew("holds no work offsets; mend it");
    const auto format = object[kFormatKey].get<std::int64_t>();
    if (format < kFormat)
        return begin_anew("has format " + std::to_string(format) + ", which is none; mend it");
    if (format > kFormat)
        return begin_anew("has format " + std::to_string(format) + " of a newer psicarve; use that one");
    Reading reading;
    reading.allow_only(
        object, {kFormatKey, "letters", "second_head", "systems", "g92", "g28", "g30", "profile", "pending"});
    const auto is_word = [&](const char* key, std::string_view wanted) {
        return object.contains(key) && object[key].is_string() && object[key].get<std::string>() == wanted;
    };
    if (!is_word("letters", name_of_letters(letters)) || !is_word("second_head", name_of_head(letters)))
        return begin_anew("has offsets for other letters than the profile's [gcode], which has letters = \"" +
                          std::string{name_of_letters(letters)} + "\", second_head = \"" +
                          std::string{name_of_head(letters)} + "\"; use the profile that they are of");
    Offsets read;
    read.kept = reading.kept(object);
    if (object.contains("profile")) read.profile = reading.profile(reading.object_in(object, "profile"));
    if (object.contains("pending")) read.pending = reading.pending(reading.object_in(object, "pending"));
    if (reading.is_wrong()) return begin_anew(reading.what() + "; mend it");
    return read;
}

}  // namespace psicarve::offsets
