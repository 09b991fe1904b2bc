// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/offsets_change.hpp"
#include "hmi/cli/run_offsets.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/base/decimals.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;
using gcode::kLetterCount;
using gcode::Position;

constexpr CommandText kGcodeOffsetsText{
    "offsets", "Show, set and clear the work offsets that programs begin with",
    "Without more it shows all systems, G92, and where G28 and G30 go. \"set SYSTEM LETTER=NUMBER ...\" sets "
    "some of a\nsystem in machine coordinates, mm and degrees, R its turn; \"clear\" takes away what a "
    "system, "
    "G92, G28, G30 or all\nhave. Refused while a program runs. A program begins with G54.",
    "psicarve gcode offsets\n  psicarve gcode offsets set G54 X=10 Y=-2.5\n  psicarve gcode offsets clear "
    "G54"};

constexpr std::chrono::milliseconds kOffsetsFreeLimit{1000};
constexpr int kShownDigits = 4;

struct OffsetsOptions {
    std::vector<std::string> words;
};

struct Shown {
    offsets::OffsetsPlace place;
    bool is_simulator = false;
    gcode::AxisLetters letters;
    offsets::Offsets offsets;
};

bool is_shown(const Shown& shown, std::size_t letter, double value) {
    return value != 0.0 || (shown.letters.all() & gcode::mask_of(letter)) != 0;
}

std::string text_of(const Shown& shown, const Position& position) {
    std::string text;
    for (std::size_t letter = 0; letter < kLetterCount; ++letter) {
        if (!is_shown(shown, letter, position[letter])) continue;
        text += (text.empty() ? "" : "  ") + std::string{gcode::kAxisLetters[letter]} + " " +
                decimals(position[letter], kShownDigits);
    }
    return text;
}

Json json_of(const Shown& shown, const Position& position) {
    auto object = Json::object();
    for (std::size_t letter = 0; letter < kLetterCount; ++letter)
        if (is_shown(shown, letter, position[letter]))
            object[std::string{gcode::kAxisLetters[letter]}] = position[letter];
    return object;
}

std::string row(std::string_view name, const std::string& text) {
    std::string line{name};
    line.resize(11, ' ');
    return line + text + "\n";
}

std::string text_of(const Shown& shown) {
    const gcode::KeptOffsets& kept = shown.offsets.kept;
    std::string text = row("kept in", shown.place.is_kept() ? shown.place.path : "no file");
    for (std::size_t system = 0; system < gcode::kSystemCount; ++system) {
        const gcode::SystemOffset& offset = kept.systems[system];
        std::string line = text_of(shown, offset.origin);
        if (offset.rotation_deg != 0.0) line += "  R " + decimals(offset.rotation_deg, kShownDigits);
        text += row(gcode::kSystemNames[system], line + (system == 0 ? "  (programs begin with it)" : ""));
    }
    const bool has_shift = kept.is_shifted || kept.shift != Position{};
    text += row("G92", has_shift ? text_of(shown, kept.shift) + (kept.is_shifted ? "" : "  (suspended)")
                                 : "not in force");
    for (std::size_t which = 0; which < kept.references.size(); ++which)
        text += row(which == 0 ? "G28" : "G30",
                    kept.references[which] ? text_of(shown, *kept.references[which]) : "the home position");
    return text;
}

Json json_of(const Shown& shown, const gcode::KeptOffsets& kept) {
    auto systems = Json::object();
    for (std::size_t system = 0; system < gcode::kSystemCount; ++system) {
        auto object = json_of(shown, kept.systems[system].origin);
        object["R"] = kept.systems[system].rotation_deg;
        systems[std::string{gcode::kSystemNames[system]}] = std::move(object);
    }
    auto shift = json_of(shown, kept.shift);
    shift["in_force"] = kept.is_shifted;
    const auto reference = [&](std::size_t which) {
        return kept.references[which] ? json_of(shown, *kept.references[which]) : Json(nullptr);
    };
    return {{"systems", std::move(systems)},
            {"g92", std::move(shift)},
            {"g28", reference(0)},
            {"g30", reference(1)}};
}

int show(const CommonOptions& common, const Shown& shown) {
    if (!common.json) {
        std::printf("%s", text_of(shown).c_str());
        return kExitDone;
    }
    Json object{{"file", shown.place.is_kept() ? Json(shown.place.path) : Json(nullptr)},
                {"simulator", shown.is_simulator},
                {"active", gcode::kSystemNames[0]}};
    object.update(json_of(shown, shown.offsets.kept));
    print_json_line(object);
    return kExitDone;
}

Error program_runs(std::uint64_t line) {
    const std::string where = line > 0 ? ", in line " + std::to_string(line) : std::string{};
    return Error{ErrorCode::machine_refused, "a program runs" + where +
                                                 "; its offsets can be changed when it has ended: "
                                                 "psicarve stop"};
}

/// A program whose reader was killed runs on without it, by what it was read with.
Result<void> require_no_program(const CommonOptions& common) {
    const auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link || !link->core_pid()) return {};
    const ProgramReport report = program_report(link->segment());
    if (report.status.is_running == 0) return {};
    return program_runs(report.status.line);
}

/// What cannot be read stays, to be mended by hand.
Result<void> put_broken_aside(const offsets::OffsetsPlace& place, const Profile& profile) {
    if (offsets::read_offsets(place, profile.gcode)) return {};
    const std::string backup = place.path + ".bak";
    if (std::rename(place.path.c_str(), backup.c_str()) != 0)
        return bad_input(place.path + ": " + std::generic_category().message(errno));
    print_note("the old file is " + backup);
    return {};
}

Result<int> change(const CommonOptions& common, const Profile& profile, Shown shown,
                   const std::vector<std::string>& words) {
    // Wrong words are told before anything else.
    gcode::KeptOffsets tried;
    if (const auto right = change_offsets(words, shown.letters, tried); !right) return right.error();
    if (!shown.place.is_kept())
        return Error{ErrorCode::bad_input, "nothing is kept: $PSICARVE_STATE is empty; set it to a folder"};
    if (const auto free = require_no_program(common); !free) return free.error();
    const auto lock = offsets::OffsetsLock::take(shown.place, kOffsetsFreeLimit);
    if (!lock) return lock.error();
    if (clears_all(words)) {
        if (const auto aside = put_broken_aside(shown.place, profile); !aside) return aside.error();
    }
    auto settled = offsets::settle_offsets(shown.place, profile.gcode, offsets_owner(common), *lock);
    if (!settled) return settled.error();
    if (!settled->warning.empty()) print_warning(settled->warning);
    if (settled->offsets.pending) return program_runs(0);
    if (const auto changed = change_offsets(words, shown.letters, settled->offsets.kept); !changed)
        return changed.error();
    if (const auto written = offsets::write_offsets(shown.place, settled->offsets, profile.gcode); !written)
        return written.error();
    shown.offsets = settled->offsets;
    return show(common, shown);
}

Result<int> run(const CommonOptions& common, const OffsetsOptions& options) {
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    const auto place = offsets_place(common);
    if (!place) return place.error();
    const offsets::OffsetsPlace of_machine = offsets::OffsetsPlace::of(common.segment, false);
    Shown shown{*place, place->path != of_machine.path, gcode::AxisLetters{profile->gcode}, {}};
    if (!options.words.empty()) return change(common, *profile, std::move(shown), options.words);
    auto read = kept_offsets(common, *profile);
    if (!read) return read.error();
    shown.offsets = std::move(*read);
    return show(common, shown);
}

}  // namespace

void add_gcode_offsets(CommandSet& commands) {
    const auto options = std::make_shared<OffsetsOptions>();
    commands.add(kGcodeOffsetsText, [options](const CommonOptions& common) { return run(common, *options); })
        .optional_arguments("CHANGE", options->words,
                            "set SYSTEM LETTER=NUMBER ..., or clear SYSTEM|G92|G28|G30|all");
}

}  // namespace psicarve::cli
