// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/journal_message.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hmi/session/log_file.hpp"

namespace psicarve::session {
namespace {

Message told_of(JournalKind kind, const std::string& what, const JournalFacts& facts) {
    JournalRecord record;
    record.run = 7;
    record.time_ms = 1'764'204'185'123;
    record.tick = 4'200;
    record.kind = kind;
    record.what = what;
    record.facts = facts;
    return journal_message({record, true}, 42);
}

TEST(JournalMessage, HasAnAlarmInTheWordsOfTheWindowWithItsPlace) {
    const auto told =
        told_of(JournalKind::alarm, "limit",
                JournalFacts{}.add("axis", "r2").add("layer", 11).add("point", 99).add("r2_pulses", -512));
    EXPECT_EQ(in_english(told.what), "Limit switch R2 closed (layer 12, point 100)");
    EXPECT_EQ(in_english(told.cause),
              "Axis R2 stopped at \u2212"
              "512 pulses. Likely a chip or a broken wire at the switch, or lost steps.");
    EXPECT_EQ(told.axes, "R2");
    EXPECT_EQ(told.severity, Severity::alarm);
    ASSERT_TRUE(told.place);
    EXPECT_EQ(told.place->core_pid, 42U);
    EXPECT_EQ(told.place->tick, 4'200U);
    EXPECT_TRUE(told.is_from_before);
    ASSERT_TRUE(told.journal);
    EXPECT_EQ(told.journal->run, 7U);
    EXPECT_TRUE(told.journal->is_simulator);
}

TEST(JournalMessage, TellsHowManyStepsWereLost) {
    const auto told = told_of(JournalKind::alarm, "steps lost",
                              JournalFacts{}.add("axis", "psi").add("expected", 6400).add("seen", 6390));
    EXPECT_EQ(in_english(told.what), "The table has lost steps");
    EXPECT_NE(in_english(told.cause).find("6\u2009390"), std::string::npos) << in_english(told.cause);
}

TEST(JournalMessage, SaysARefusalByItsIdentifierNotByTheWordsOfThatDay) {
    const auto told = told_of(JournalKind::command, "jog",
                              JournalFacts{}
                                  .add("axis", "r1")
                                  .add("value", "-5.5")
                                  .add("answer", "refused")
                                  .add("reason", "words of an older version")
                                  .add("message", "inside_core_radius")
                                  .add("arguments", "a 0 4008000000000000")
                                  .add("sender", "psicarve")
                                  .add("pid", 99));
    EXPECT_EQ(in_english(told.what), "Command: jog (-5.5): R1 would go inside the core radius, 3.000 mm");
    EXPECT_EQ(in_english(told.cause), "Asked for by psicarve, process 99");
    EXPECT_EQ(told.severity, Severity::warning);
    EXPECT_TRUE(told.is_command);
    EXPECT_EQ(told.axes, "R1");
}

TEST(JournalMessage, KeepsTheWordsOfARecordWithoutArguments) {
    const auto refused = JournalFacts{}.add("answer", "refused").add("reason", "jog: no such thing");
    EXPECT_EQ(in_english(told_of(JournalKind::command, "jog", refused).what), "Command: jog: no such thing");
    auto older = refused;
    older.add("message", "not_homed");  // it has no arguments
    EXPECT_EQ(in_english(told_of(JournalKind::command, "home", older).what),
              "Command: home: the machine is not homed; home first");
}

TEST(JournalMessage, TellsOfCoresAndJobs) {
    const auto killed = told_of(
        JournalKind::core, "start",
        JournalFacts{}.add("version", "1.2").add("port", "sim").add("pid", 5).add("before", "killed"));
    EXPECT_EQ(in_english(killed.what), "The core has started: version 1.2, port sim, process 5");
    EXPECT_EQ(in_english(killed.cause), "The one before was killed or crashed");
    EXPECT_EQ(killed.severity, Severity::warning);
    const auto english_of = [](const std::string& what, const JournalFacts& facts) {
        return in_english(told_of(JournalKind::job, what, facts).what);
    };
    EXPECT_EQ(english_of("started", JournalFacts{}.add("source", "vase.stl").add("first_layer", 12)),
              "Carving began with layer 13: vase.stl");
    const auto within =
        JournalFacts{}.add("source", "vase.stl").add("first_layer", 12).add("first_point", 56);
    EXPECT_EQ(english_of("started", within), "Carving began with layer 13, point 57: vase.stl");
    EXPECT_EQ(english_of("started", JournalFacts{within}.add("dry", 1)),
              "Dry run began with layer 13, point 57: vase.stl");
    EXPECT_EQ(
        english_of("ended", JournalFacts{}.add("source", "vase.stl").add("how", "stopped").add("layer", 4)),
        "Job stopped in layer 5: vase.stl");
    EXPECT_EQ(english_of("refused", JournalFacts{}.add("message", "busy_for_a_job")),
              "Job refused: the machine is busy; try again");
    EXPECT_EQ(english_of("left out", JournalFacts{}.add("count", 9)),
              "9 more came too fast to be written down");
}

TEST(JournalMessage, TellsHowAProgramEndedAndInWhichLine) {
    const auto program = [](const std::string& what, const JournalFacts& facts) {
        return told_of(JournalKind::job, what, facts);
    };
    const auto ended = [&](const std::string& how) {
        return program("program ended", JournalFacts{}.add("how", how).add("line", 12));
    };
    EXPECT_EQ(in_english(program("program started", {}).what), "Program begun");
    const auto held = [&](const std::string& how) {
        return program("program held", JournalFacts{}.add("how", how).add("line", 12));
    };
    EXPECT_EQ(in_english(held("tool change").what), "Program held in line 12: tool change (M6)");
    EXPECT_EQ(in_english(held("").what), "Program held in line 12");
    EXPECT_EQ(in_english(held("%1").what), "Program held in line 12");
    EXPECT_EQ(held("program feeder lost").severity, Severity::warning);
    EXPECT_EQ(in_english(program("program resumed", JournalFacts{}.add("line", 12)).what),
              "Program goes on in line 12");
    EXPECT_EQ(in_english(ended("done").what), "Program done, up to line 12");
    EXPECT_EQ(ended("done").severity, Severity::info);
    EXPECT_EQ(in_english(ended("stopped").what), "Program stopped in line 12");
    EXPECT_EQ(in_english(ended("alarm").what), "Program ended by an alarm in line 12");
    EXPECT_EQ(in_english(ended("feeder lost").what), "Program broke off behind line 12: its reader was gone");
    EXPECT_EQ(ended("feeder lost").severity, Severity::warning);
    const auto refused = program("program ended", JournalFacts{}
                                                      .add("how", "refused")
                                                      .add("line", 12)
                                                      .add("message", "program_goes_on_after_end")
                                                      .add("arguments", "d"));
    EXPECT_NE(in_english(refused.what).find("Program broke off behind line 12: "), std::string::npos)
        << in_english(refused.what);
    EXPECT_EQ(refused.severity, Severity::warning);
    const auto alarm = told_of(JournalKind::alarm, "limit", JournalFacts{}.add("axis", "r2").add("line", 12));
    EXPECT_EQ(in_english(alarm.what), "Limit switch R2 closed (line 12 of the program)");
}

// Whoever may write to the folder.
TEST(JournalMessage, TrustsNoValue) {
    for (const JournalKind kind :
         {JournalKind::core, JournalKind::alarm, JournalKind::command, JournalKind::job}) {
        for (const char* what : {"", "start", "limit", "ended", "missed ticks", "%1%2%3", "estop"}) {
            const auto told = told_of(kind, what,
                                      JournalFacts{}
                                          .add("axis", "r9")
                                          .add("layer", INT64_MAX)
                                          .add("first_wrong_layer", INT64_MIN)
                                          .add("wrong_layers", INT64_MAX)
                                          .add("count", "many")
                                          .add("message", "outside_travel")
                                          .add("arguments", "ff ff ff"));
            EXPECT_NE(log_line(told), "");
        }
    }
}

}  // namespace
}  // namespace psicarve::session
