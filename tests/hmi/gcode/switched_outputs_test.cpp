// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/switched_outputs.hpp"

#include <gtest/gtest.h>

#include "hmi/gcode/approach.hpp"
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

constexpr SwitchedOutputs kMist = switched_bit(Signal::mist);
constexpr SwitchedOutputs kFlood = switched_bit(Signal::flood);

/// All enables on one pin leave two for outputs.
Profile profile_with(std::initializer_list<Signal> outputs) {
    Profile profile;
    for (const Axis axis : kAllAxes) profile.port.pins[index_of(enable_of(axis))] = 6;
    int pin = 1;
    for (const Signal output : outputs) {
        profile.port.pins[index_of(output)] = pin;
        pin = 7;
    }
    return profile;
}

/// "3 flood on", "4 mist flood off", other records by their kind's number.
std::vector<std::string> switched(const std::vector<MotionRecord>& records) {
    std::vector<std::string> told;
    for (const MotionRecord& record : records) {
        std::string text = std::to_string(record.line);
        for (std::size_t k = kFirstSwitchedOutput; k < kSignalCount; ++k) {
            const auto signal = static_cast<Signal>(k);
            if ((levels_of(record.outputs) & bit_of(signal)) != 0) text += " " + std::string{name_of(signal)};
        }
        if (record.kind == MotionKind::output) text += record.code != 0 ? " on" : " off";
        if (record.kind != MotionKind::output) text += " #" + std::to_string(static_cast<int>(record.kind));
        told.push_back(text);
    }
    return told;
}
using Told = std::vector<std::string>;

TEST(SwitchedOutputs, AreNotWarnedOfWhereTheyAreWired) {
    const Profile both = profile_with({Signal::mist, Signal::flood});
    EXPECT_EQ(read_program("M7\nM8\nM9\nM2\n", {}, &both)->faults(), Faults{});
    const Profile flood = profile_with({Signal::flood});
    const auto read = read_program("M7\nM8\nM9\nM2\n", {}, &flood);
    EXPECT_EQ(read->faults(), Faults{"1:1 coolant_unused"});
    EXPECT_EQ(what_text(read->problems.warnings().front()), "the machine has no output for mist");
    const Profile none;
    EXPECT_EQ(what_text(read_program("M7\nM2\n", {}, &none)->problems.warnings().front()),
              "the machine has no output for coolant");
}

TEST(SwitchedOutputs, OfDigitalKindAreRefusedByNumberWhereTheyAreNotWired) {
    const Profile profile = profile_with({Signal::output_0, Signal::output_3});
    EXPECT_EQ(read_program("M62 P0\nM63 P3\nM64 P3\nM65 P0\nM2\n", {}, &profile)->faults(), Faults{});
    EXPECT_EQ(read_program("M62 P1\nM63 P2\nM64 P4\nM65 P5\nM66 P0\nM2\n", {}, &profile)->faults(),
              (Faults{"1:1 output_missing", "2:1 output_missing", "3:1 output_missing", "4:1 output_missing",
                      "5:1 output_missing"}));
}

TEST(SwitchedOutputs, BecomeRecordsAtTheirPlace) {
    const Profile both = profile_with({Signal::mist, Signal::flood});
    EXPECT_EQ(switched(made_records("M8\nG0 Y1\nM7\nG1 Y2 F60 M9\nM2\n", {}, both).records),
              (Told{"1 flood on", "2 #1", "3 mist on", "4 mist flood off", "4 #1", "5 #5"}));
    const Profile flood = profile_with({Signal::flood});
    EXPECT_EQ(switched(made_records("M7\nM8\nG0 Y1\nM9\nM2\n", {}, flood).records),
              (Told{"2 flood on", "3 #1", "4 flood off", "5 #5"}))
        << "only what is wired";
    EXPECT_EQ(switched(made_records("M7\nM8\nG0 Y1\nM9\nM2\n").records), (Told{"3 #1", "5 #5"}));
    const Profile digital = profile_with({Signal::output_0, Signal::output_2});
    EXPECT_EQ(switched(made_records("M64 P0\nM62 P2\nG0 Y1\nM65 P0\nM63 P2\nM2\n", {}, digital).records),
              (Told{"1 output_0 on", "2 output_2 on", "3 #1", "4 output_0 off", "5 output_2 off", "6 #5"}));
}

TEST(SwitchedOutputs, StayOffInADryRun) {
    RunOptions how;
    how.is_dry = true;
    const Profile profile = profile_with({Signal::mist, Signal::output_1});
    const auto records = made_records("M3\nM7\nM64 P1\nG0 Y1\nM9\nM2\n", how, profile).records;
    for (const MotionRecord& record : records) EXPECT_NE(record.kind, MotionKind::output) << record.line;
}

TEST(SwitchedOutputs, AreOnBeforeTheHeadsComeInWhereAProgramBeginsWithALine) {
    const Profile profile = profile_with({Signal::mist, Signal::flood});
    RunOptions how;
    how.from_line = 6;
    EXPECT_EQ(switched(made_records("M3\nM7\nM8\nM9\nM8 G0 X40 Y1\nG0 Y2\nM2\n", how, profile).records),
              (Told{"6 #3", "6 flood on", "6 #1", "6 #1", "6 #1", "6 #1", "6 #1", "7 #5"}))
        << "heads out, psi, y, heads in; then the line's own way";
    how.is_dry = true;
    for (const MotionRecord& record :
         made_records("M8\nG0 Y1\nM3\nM8\nM7\nG0 Y2\nM2\n", how, profile).records)
        EXPECT_NE(record.kind, MotionKind::output);
}

TEST(SwitchedOutputs, AreToldOfTheApproach) {
    const Profile profile = profile_with({Signal::flood});
    const auto found = [&](const std::string& text, std::uint32_t line) {
        ApproachFinder sut{profile, line};
        ProblemList problems;
        LineSource lines{bytes_of(text)};
        EXPECT_TRUE(interpret_program(lines, machine_options(profile), sut, problems).has_value());
        return sut.found();
    };
    const std::string text = "M7\nM8\nG0 Y1\nM9\nG0 Y2\nM2\n";
    EXPECT_EQ(found(text, 2).outputs_on, 0) << "mist is not wired";
    EXPECT_FALSE(found(text, 2).is_needed());
    EXPECT_EQ(found(text, 3).outputs_on, kFlood);
    EXPECT_TRUE(found(text, 3).is_needed());
    EXPECT_EQ(found(text, 5).outputs_on, 0);
}

TEST(SwitchedOutputs, OfARecordAreThoseItNames) {
    CanonRecord record;
    record.kind = CanonKind::coolant;
    record.code = 9;
    EXPECT_EQ(outputs_of(record), kMist | kFlood);
    record.kind = CanonKind::spindle;
    EXPECT_EQ(outputs_of(record), 0);
    record.kind = CanonKind::output;
    record.value = 4.0;
    EXPECT_EQ(outputs_of(record), 0);
}

}  // namespace
}  // namespace psicarve::gcode
