// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "hmi/cli/program_sight.hpp"
#include "hmi/gcode/code_groups.hpp"
#include "hmi/report/program_modes.hpp"
#include "hmi/report/program_origin.hpp"
#include "shared/base/message_text.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

ProgramReport held_report(ProgramHold hold) {
    ProgramReport report;
    report.status.program = 3;
    report.status.line = 8;
    report.status.is_running = 1;
    report.status.hold = hold;
    return report;
}

/// Of a record that the core did not take.
ProgramReport refused_report(ProgramHold hold) {
    ProgramReport report = held_report(hold);
    report.refusal = ProgramRefusal{
        .program = 3,
        .line = 9,
        .said = message_of(MessageId::program_goes_on_after_end, count_argument(std::uint64_t{9}))};
    return report;
}

TEST(ProgramText, SaysWhyItIsHeldAndWhatGoesOn) {
    EXPECT_EQ(program_text(held_report(ProgramHold::none), {}, nullptr),
              "program    no. 3, line 8\nswitches   not told how it is read\n"
              "queue      0 of 0 records; it had to wait for more 0 times\n");
    EXPECT_EQ(program_place_text(held_report(ProgramHold::tool_change)),
              "line 8: held, tool change; psicarve resume goes on");
    EXPECT_EQ(program_place_text(held_report(ProgramHold::starved)),
              "line 8: held, starved; it goes on when more of the program comes");
    EXPECT_EQ(program_text(ProgramReport{}, {}, nullptr), "");
}

TEST(ProgramText, NamesTheLineInWhichTheLastOneWasBrokenOff) {
    ProgramReport report = held_report(ProgramHold::none);
    report.status.is_running = 0;
    CoreStatus machine{};
    machine.state = MachineState::alarm;
    EXPECT_EQ(program_text(report, machine, nullptr),
              "program    the last one ended in line 8 of its program; gcode run FILE --from-line 8 begins "
              "where that line is reached first, once the machine is homed\n");
    EXPECT_EQ(last_program_json(report)["line"], 8);
    EXPECT_EQ(last_program_json(report)["is_done"], false);
    EXPECT_EQ(program_json(report, machine, nullptr), nullptr);
    machine.state = MachineState::ready;
    machine.homed_mask = 0xF;
    EXPECT_EQ(program_text(report, machine, nullptr),
              "program    the last one ended in line 8 of its program; gcode run FILE --from-line 8 begins "
              "where that line is reached first\n");
    machine.state = MachineState::carving;  // a job
    EXPECT_EQ(program_text(report, machine, nullptr), "");
    machine.state = MachineState::ready;
    report.status.is_done = 1;
    EXPECT_EQ(program_text(report, machine, nullptr), "");
    EXPECT_EQ(last_program_json(report)["is_done"], true);
    report.status = {};
    EXPECT_EQ(program_text(report, machine, nullptr), "") << "none yet";
    EXPECT_EQ(last_program_json(report), nullptr);
}

ProgramOrigin origin_named(const std::string& name, std::uint32_t flags = 0, std::uint64_t from_line = 0) {
    ProgramOrigin origin;
    origin.from_line = from_line;
    origin.flags = flags;
    name.copy(static_cast<char*>(origin.name), sizeof origin.name);
    return origin;
}

TEST(ProgramText, TellsWhichProgramRunsAndItsSwitches) {
    ProgramReport report = held_report(ProgramHold::none);
    report.origin = origin_named("/parts/left/pocket.ngc");
    EXPECT_EQ(program_text(report, {}, nullptr),
              "program    pocket.ngc (no. 3), line 8\nswitches   none\n"
              "queue      0 of 0 records; it had to wait for more 0 times\n");
    EXPECT_EQ(named_place_text(report), "pocket.ngc, line 8");
    report.status.is_single = 1;
    report.status.stops_at_optional = 1;
    report.origin = origin_named("-", kSourceIsStream | kSourceSkipsDeleted | kSourceIsDry | kSourceIsIso, 5);
    EXPECT_EQ(program_text(report, {}, nullptr),
              "program    standard input (no. 3), line 8\n"
              "switches   single block, optional stop, block delete, dry run, ISO dialect, from line 5\n"
              "queue      0 of 0 records; it had to wait for more 0 times\n");
    report.status.is_single = 0;
    report.origin = origin_named("/run/psicarve-77.ngc", kSourceIsTyped | kSourceIsSingle);
    EXPECT_EQ(named_place_text(report), "a typed block, line 8");
    EXPECT_NE(program_text(report, {}, nullptr).find("switches   optional stop\n"), std::string::npos)
        << "single was switched off since";
    report.origin.reset();
    EXPECT_EQ(named_place_text(report), "no. 3, line 8");
    EXPECT_NE(program_text(report, {}, nullptr).find("optional stop; not told how it is read\n"),
              std::string::npos);
}

TEST(ProgramText, HasWhichProgramRunsAndItsSwitchesInJson) {
    ProgramReport report = held_report(ProgramHold::none);
    auto json = program_json(report, {}, nullptr);
    for (const char* const key : {"name", "source", "from_line", "block_delete", "dry_run", "dialect"})
        EXPECT_TRUE(json.at(key).is_null()) << key;
    EXPECT_EQ(json["optional_stop"], false);
    report.status.stops_at_optional = 1;
    report.origin = origin_named("/parts/pocket.ngc", kSourceSkipsDeleted);
    json = program_json(report, {}, nullptr);
    EXPECT_EQ(json["name"], "pocket.ngc");
    EXPECT_EQ(json["source"], "file");
    EXPECT_EQ(json["from_line"], 1);
    EXPECT_EQ(json["block_delete"], true);
    EXPECT_EQ(json["dry_run"], false);
    EXPECT_EQ(json["dialect"], "ngc");
    EXPECT_EQ(json["optional_stop"], true);
    EXPECT_EQ(json["starvations"], 0);
    report.origin = origin_named("-", kSourceIsStream | kSourceIsDry | kSourceIsIso, 7);
    json = program_json(report, {}, nullptr);
    EXPECT_TRUE(json["name"].is_null());
    EXPECT_EQ(json["source"], "stream");
    EXPECT_EQ(json["from_line"], 7);
    EXPECT_EQ(json["dry_run"], true);
    EXPECT_EQ(json["dialect"], "iso");
    report.status.is_running = 0;
    report.origin = origin_named("pocket.ngc");
    EXPECT_EQ(last_program_json(report)["name"], "pocket.ngc");
    EXPECT_NE(program_text(report, {}, nullptr).find("the last one (pocket.ngc) ended in line 8 "),
              std::string::npos);
}

// Any bytes may stand there.
TEST(ProgramText, ShowsWhateverNameAsOneLineThatSteersNothing) {
    const auto shown = [](const std::string& name) { return report::file_name_of(origin_named(name)); };
    EXPECT_EQ(shown("a"), "a");
    EXPECT_EQ(shown(std::string(kSourceNameBytes - 1, 'n')), std::string(kSourceNameBytes - 1, 'n'));
    EXPECT_EQ(shown(std::string(kSourceNameBytes, 'n')), std::string(kSourceNameBytes, 'n')) << "no zero";
    EXPECT_EQ(shown("k\xC3\xA4se.ngc"), "k\xC3\xA4se.ngc");
    EXPECT_EQ(shown("torn\xC3"), "torn\\xc3");
    EXPECT_EQ(shown("\x1B[2J\n\tx"), "\\u001b[2J\\u000a\\u0009x");
    EXPECT_EQ(shown(""), "?");
    EXPECT_EQ(shown("folder/"), "?");
    ProgramReport report = held_report(ProgramHold::none);
    report.origin = origin_named("\xFF\xFE", 0xFFFF'FF00U, 0xFFFF'FFFF'FFFF'FFFFU);
    EXPECT_FALSE(program_json(report, {}, nullptr).dump().empty()) << "is UTF-8";
}

TEST(ProgramText, SaysWhichLineTheCoreRefusedAndWhy) {
    const std::string text = program_place_text(refused_report(ProgramHold::refused));
    EXPECT_EQ(
        text,
        "line 8: held, program refused (line 9: a record comes after the program's end; start the program "
        "again); psicarve stop ends it");
    const auto json = program_json(refused_report(ProgramHold::refused), {}, nullptr);
    EXPECT_EQ(json["hold"], "program refused");
    EXPECT_EQ(json["refusal"]["line"], 9);
    EXPECT_EQ(json["refusal"]["message"]["id"], "program_goes_on_after_end");
}

// The core reads ahead of the machine: what will end the program is no reason for a hold before it.
TEST(ProgramText, KeepsTheReasonUntilTheMachineComesToIt) {
    EXPECT_EQ(program_place_text(refused_report(ProgramHold::single)),
              "line 8: held, single block; psicarve resume goes on");
    EXPECT_TRUE(program_json(refused_report(ProgramHold::none), {}, nullptr)["refusal"].is_null());
}

ProgramReport told_report() {
    ProgramReport report = held_report(ProgramHold::none);
    report.status.sequence = 40;
    report.status.starvations = 2;
    report.queued = 12;
    report.ring_records = 64;
    ProgramModes modes{};
    modes.program = 3;
    modes.sequence = 42;
    modes.line = 8;
    modes.g_codes.fill(-1);
    modes.m_codes.fill(-1);
    modes.g_codes[0] = 20;
    modes.g_codes[1] = 591;
    modes.m_codes[0] = 3;
    modes.feed = 0.25;
    modes.zero = {1.0, -0.0001, 270.0, 2.5};
    modes.end = {40.0, 40.0, 90.0, 5.0};
    report.modes = modes;
    return report;
}

TEST(ProgramText, TellsWhatHoldsAndHowFarItIs) {
    const Profile profile;
    CoreStatus machine{};
    machine.position_pulses[index_of(Axis::r1)] = 400 * 39;
    machine.position_pulses[index_of(Axis::r2)] = 400 * 40;
    EXPECT_EQ(program_text(told_report(), machine, &profile),
              "program    no. 3, line 8\n"
              "switches   not told how it is read\n"
              "modes      G2 G59.1 M3; F 0.25, S 0, T 0\n"
              "zero       G59.1: r1 1.000 mm, r2 0.000 mm, psi 270.000 deg, y 2.500 mm\n"
              "to go      r1 1.000 mm, r2 0.000 mm, psi 90.000 deg, y 5.000 mm\n"
              "queue      12 of 64 records; it had to wait for more 2 times\n");
    const auto json = program_json(told_report(), machine, &profile);
    EXPECT_EQ(json["modes"]["codes"], "G2 G59.1 M3");
    EXPECT_EQ(json["to_go"]["y_mm"], 5.0);
    EXPECT_EQ(json["queue"]["records"], 12);
    EXPECT_TRUE(program_json(told_report(), machine, nullptr)["to_go"].is_null());
}

TEST(ProgramText, TellsNoDistanceToTheEndOfAWayThatIsDone) {
    const Profile profile;
    ProgramReport report = told_report();
    report.status.sequence = 43;
    report.status.line = 9;
    EXPECT_TRUE(program_json(report, {}, &profile)["to_go"].is_null());
    EXPECT_EQ(program_json(report, {}, &profile)["modes"]["is_at_hand"], false);
    const std::string text = program_text(report, {}, &profile);
    EXPECT_NE(text.find("T 0 (of line 8)\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("to go"), std::string::npos) << text;
}

// The words are another process's.
TEST(ProgramText, LeavesOutWhatIsNoCodeAndNoNumber) {
    const Profile profile;
    ProgramReport report = told_report();
    report.modes->g_codes[0] = 32'000;
    report.modes->m_codes[0] = -77;
    report.modes->end[1] = std::numeric_limits<double>::quiet_NaN();
    report.modes->zero[0] = std::numeric_limits<double>::infinity();
    const auto json = program_json(report, {}, &profile);
    EXPECT_EQ(json["modes"]["codes"], "G59.1");
    EXPECT_TRUE(json["modes"]["zero"].is_null());
    EXPECT_TRUE(json["to_go"].is_null());
    report.modes->zero[0] = 1e300;
    EXPECT_FALSE(program_text(report, {}, &profile).empty());
}

TEST(ProgramText, KnowsTheActiveCodesOfTheReaderAndNoOthers) {
    ProgramModes modes{};
    for (int code = -1; code <= 1'001; ++code) {
        const gcode::CodeEntry entry = gcode::g_code_entry(code);
        const bool is_active =
            entry.standing == gcode::CodeStanding::known && entry.group != gcode::CodeGroup::once;
        modes.g_codes.fill(-1);
        modes.m_codes.fill(-1);
        modes.g_codes[3] = static_cast<std::int16_t>(code);
        EXPECT_EQ(!report::codes_text(modes).empty(), is_active) << code;
        EXPECT_EQ(!report::system_text(modes).empty(), is_active && entry.group == gcode::CodeGroup::system)
            << code;
        modes.g_codes[3] = -1;
        modes.m_codes[1] = static_cast<std::int16_t>(code);
        const auto group = gcode::m_code_entry(code).group;
        const bool is_mode = gcode::m_code_entry(code).standing == gcode::CodeStanding::known &&
                             (group == gcode::CodeGroup::spindle || group == gcode::CodeGroup::coolant ||
                              code == 48 || code == 49);
        EXPECT_EQ(!report::codes_text(modes).empty(), is_mode) << code;
    }
}

TEST(ProgramText, LeavesOutEachNumberThatNoProgramHas) {
    const Profile profile;
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
        const auto with = [&](auto change) {
            ProgramReport report = told_report();
            change(*report.modes);
            return report;
        };
        const ProgramReport feed = with([&](ProgramModes& modes) { modes.feed = wrong; });
        EXPECT_NE(program_text(feed, {}, &profile).find("M3; S 0, T 0\n"), std::string::npos);
        EXPECT_TRUE(program_json(feed, {}, &profile)["modes"]["feed"].is_null());
        const ProgramReport speed = with([&](ProgramModes& modes) { modes.speed_rpm = wrong; });
        EXPECT_NE(program_text(speed, {}, &profile).find("M3; F 0.25, T 0\n"), std::string::npos);
        EXPECT_TRUE(program_json(speed, {}, &profile)["modes"]["speed_rpm"].is_null());
        const ProgramReport turned = with([&](ProgramModes& modes) { modes.rotation_deg = wrong; });
        EXPECT_EQ(program_text(turned, {}, &profile), program_text(told_report(), {}, &profile));
        EXPECT_TRUE(program_json(turned, {}, &profile)["modes"]["rotation_deg"].is_null());
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const ProgramReport zero = with([&](ProgramModes& modes) { modes.zero[k] = wrong; });
            EXPECT_EQ(program_text(zero, {}, &profile).find("zero"), std::string::npos) << k;
            EXPECT_TRUE(program_json(zero, {}, &profile)["modes"]["zero"].is_null()) << k;
            const ProgramReport end = with([&](ProgramModes& modes) { modes.end[k] = wrong; });
            EXPECT_EQ(program_text(end, {}, &profile).find("to go"), std::string::npos) << k;
            EXPECT_TRUE(program_json(end, {}, &profile)["to_go"].is_null()) << k;
        }
    }
    ProgramReport report = told_report();
    report.modes->tool = -5;
    report.modes->g_codes[1] = 541;
    EXPECT_NE(program_text(report, {}, &profile).find("modes      G2 M3; F 0.25, S 0\nto go"),
              std::string::npos)
        << program_text(report, {}, &profile);
    EXPECT_TRUE(program_json(report, {}, &profile)["modes"]["tool"].is_null());
    EXPECT_TRUE(program_json(report, {}, &profile)["modes"]["system"].is_null());
}

// After a stop in a cut the distance would grow, to an end that nobody goes to.
TEST(ProgramText, TellsNoDistanceOnceTheMachineGoesThereNoMore) {
    const Profile profile;
    for (std::uint8_t number = 0; number < kMachineStateCount; ++number) {
        CoreStatus machine{};
        machine.state = static_cast<MachineState>(number);
        const bool goes_on = machine.state != MachineState::stopping &&
                             machine.state != MachineState::alarm &&
                             machine.state != MachineState::backing_off;
        EXPECT_EQ(program_json(told_report(), machine, &profile)["to_go"].is_object(), goes_on)
            << name_of(machine.state);
    }
}

/// Who tells comes only with the look of this number; 0: never.
ProgramSight seen_after(int look_with_modes, int* looks) {
    ProgramSight first{{}, told_report()};
    first.program.modes->sequence = first.program.status.sequence - 1;
    *looks = 0;
    return told_sight(first, [=]() -> std::optional<ProgramSight> {
        if (++*looks != look_with_modes) return first;
        ProgramSight told{{}, told_report()};
        told.machine.heartbeat = 77;
        return told;
    });
}

TEST(ProgramSight, GivesWhoTellsWhatHoldsAMoment) {
    int looks = 0;
    const ProgramSight told = seen_after(3, &looks);
    EXPECT_EQ(looks, 3);
    EXPECT_EQ(told.program.modes->sequence, 42U);
    EXPECT_EQ(told.machine.heartbeat, 77U) << "both of the same moment";
    EXPECT_EQ(seen_after(0, &looks).program.modes->sequence, 39U);
    EXPECT_EQ(looks, 10) << "but not for ever";
}

TEST(ProgramSight, LooksOnceWhereNothingIsToCome) {
    int looks = 0;
    const auto look = [&]() -> std::optional<ProgramSight> {
        ++looks;
        return std::nullopt;
    };
    (void)told_sight({{}, told_report()}, look);
    ProgramSight none{};
    none.program.status.is_running = 0;
    (void)told_sight(none, look);
    EXPECT_EQ(looks, 0) << "told already, or no program";
    none.program = held_report(ProgramHold::none);
    EXPECT_EQ(told_sight(none, look).program.status.line, 8U);
    EXPECT_EQ(looks, 1) << "nobody is there who would tell";
}

}  // namespace
}  // namespace psicarve::cli
