// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/status_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace psicarve::session {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class StatusLineTest : public ::testing::Test {
protected:
    void tell(Severity severity, const char* text) { log.add(severity, phrase(text)); }
    /// What stands there after so much more time.
    std::string after(milliseconds time) {
        now += time;
        sut.look(log, now);
        return sut.shown() ? in_english(sut.shown()->what) : "";
    }

    MessageLog log;
    StatusLine sut;
    StatusLine::Clock::time_point now{};
};

TEST_F(StatusLineTest, ShowsTheNewestOfWhatIsNoTrouble) {
    EXPECT_EQ(after(milliseconds{0}), "");
    tell(Severity::info, "one");
    tell(Severity::info, "two");
    EXPECT_EQ(after(milliseconds{33}), "two");
    tell(Severity::info, "three");
    EXPECT_EQ(after(milliseconds{33}), "three");
}

TEST_F(StatusLineTest, KeepsAWarningAgainstGoodNewsForItsTime) {
    tell(Severity::warning, "cut off");
    tell(Severity::info, "core found");  // in the same look
    EXPECT_EQ(after(milliseconds{33}), "cut off");
    tell(Severity::info, "job");
    EXPECT_EQ(after(StatusLine::kTroubleStays - milliseconds{1}), "cut off");
    EXPECT_EQ(after(milliseconds{1}), "job") << "the newest of those kept back";
    tell(Severity::info, "later");
    EXPECT_EQ(after(milliseconds{33}), "later");
}

TEST_F(StatusLineTest, GivesAWarningsPlaceToANewerOneAtOnce) {
    tell(Severity::alarm, "limit switch");
    EXPECT_EQ(after(milliseconds{33}), "limit switch");
    tell(Severity::info, "kept back");
    tell(Severity::warning, "spindle");
    EXPECT_EQ(after(milliseconds{33}), "spindle");
    EXPECT_EQ(after(seconds{60}), "spindle") << "what was told before it does not come after it";
}

TEST_F(StatusLineTest, LetsOldTroubleGoWithTheNextNews) {
    tell(Severity::warning, "cut off");
    EXPECT_EQ(after(milliseconds{0}), "cut off");
    EXPECT_EQ(after(seconds{60}), "cut off") << "nothing else was told";
    tell(Severity::info, "core found");
    EXPECT_EQ(after(milliseconds{33}), "core found");
}

}  // namespace
}  // namespace psicarve::session
