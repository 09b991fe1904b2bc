// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of a judged trace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "hmi/session/trace_judge.hpp"

namespace psicarve::replay {
namespace {

using testing::HasSubstr;

verify::VerifyReport cut_report() {
    verify::VerifyReport report;
    report.ok = report.is_cut = true;
    report.points_visited = 7;
    report.points_total = 10;
    report.max_deviation_pulses = 3;
    report.carve_seconds = 61.0;
    return report;
}

std::string rows_of(const verify::VerifyReport& report) {
    std::string text;
    for (const session::VerdictRow& row : session::verdict_rows(report))
        text += in_english(row.name) + ": " + in_english(row.value) + "\n";
    return text;
}

TEST(VerdictRows, OfACarvingThatWasCutShortAreOfWhatWasCarved) {
    verify::VerifyReport report = cut_report();
    const std::string text = rows_of(report);
    EXPECT_THAT(text, HasSubstr("Judged: the job from its begin\nJudged up to: where it was recorded\n"));
    EXPECT_THAT(text, HasSubstr("Largest deviation: 3 pulses, of what was carved\n"));
    EXPECT_THAT(text, HasSubstr("Carving time: 1:01, not finished\n"));
    EXPECT_EQ(in_english(session::verified_phrase(report)),
              "Verified as far as it was recorded, largest deviation 3 pulses");
    report.is_cut = false;
    report.is_complete = true;
    EXPECT_THAT(rows_of(report), HasSubstr("Carving time: 1:01\n"));
    EXPECT_THAT(in_english(session::verified_phrase(report)), HasSubstr("the pins carve the job"));
}

TEST(VerdictRows, SayWhereNothingWasCarved) {
    verify::VerifyReport report = cut_report();
    report.carve_seconds = 0.0;
    for (const bool is_dry : {false, true}) {
        report.is_dry = is_dry;
        report.is_cut = !is_dry;
        EXPECT_THAT(rows_of(report), HasSubstr("Largest deviation: nothing was carved\n"));
        EXPECT_THAT(rows_of(report), HasSubstr("Carving time: nothing was carved\n"));
    }
    EXPECT_EQ(in_english(session::verified_phrase(report)),
              "Verified: the pulses of a dry run, which carves nothing");
}

}  // namespace
}  // namespace psicarve::replay
