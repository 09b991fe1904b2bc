// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
    EXPECT_EQ(program_text(held_report(ProgramHold::none)), "program    line 8\n");
    EXPECT_EQ(program_place_text(held_report(ProgramHold::tool_change)),
              "line 8: held, tool change; psicarve resume goes on");
    EXPECT_EQ(program_place_text(held_report(ProgramHold::starved)),
              "line 8: held, starved; it goes on when more of the program comes");
    EXPECT_EQ(program_text(ProgramReport{}), "");
}

TEST(ProgramText, SaysWhichLineTheCoreRefusedAndWhy) {
    const std::string text = program_place_text(refused_report(ProgramHold::refused));
    EXPECT_EQ(
        text,
        "line 8: held, program refused (line 9: a record comes after the program's end; start the program "
        "again); psicarve stop ends it");
    const auto json = program_json(refused_report(ProgramHold::refused));
    EXPECT_EQ(json["hold"], "program refused");
    EXPECT_EQ(json["refusal"]["line"], 9);
    EXPECT_EQ(json["refusal"]["message"]["id"], "program_goes_on_after_end");
}

// The core reads ahead of the machine: what will end the program is no reason for a hold before it.
TEST(ProgramText, KeepsTheReasonUntilTheMachineComesToIt) {
    EXPECT_EQ(program_place_text(refused_report(ProgramHold::single)),
              "line 8: held, single block; psicarve resume goes on");
    EXPECT_TRUE(program_json(refused_report(ProgramHold::none))["refusal"].is_null());
}

}  // namespace
}  // namespace psicarve::cli
