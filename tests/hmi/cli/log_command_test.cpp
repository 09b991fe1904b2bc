// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "shared/record/journal_file.hpp"
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

constexpr std::int64_t kBegin_ms = 1'764'204'185'123;  ///< 2025-11-27 00:43:05 UTC

/// Central European time, in winter one hour ahead, with the rules in the variable itself.
class LocalTime {
public:
    LocalTime() { setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1); }
    ~LocalTime() { unsetenv("TZ"); }
    LocalTime(const LocalTime&) = delete;
    LocalTime& operator=(const LocalTime&) = delete;
};

class LogCommand : public CliTest {
protected:
    void add(JournalKind kind, const std::string& what, const JournalFacts& facts, bool is_simulated = true) {
        JournalRecord record;
        record.sequence = ++sequence_;
        record.run = 1;
        record.time_ms = kBegin_ms + static_cast<std::int64_t>(sequence_) * 60'000;
        record.tick = 100 * sequence_;
        record.kind = kind;
        record.what = what;
        record.facts = facts;
        append(journal_line(record), is_simulated);
    }
    void append(const std::string& text, bool is_simulated = true) const {
        const JournalFiles files{StateNames{folder_.string(), segment_, is_simulated}};
        std::ofstream{files.newer, std::ios::app} << text;
    }
    Outcome log(std::vector<std::string> more = {}) const {
        const LocalTime here;
        more.insert(more.begin(), {"log", "--state", folder_.string()});
        return run(more);
    }
    /// One of everything.
    void add_all() {
        add(JournalKind::core, "start",
            JournalFacts{}
                .add("version", "1.2.3")
                .add("pid", 77)
                .add("port", "sim")
                .add("clock", "real")
                .add("profile", "00ff")
                .add("before", "killed")
                .add("boot", "b"));
        add(JournalKind::job, "loaded",
            JournalFacts{}
                .add("source", "vase\x1b[2J.stl")
                .add("layers", 400)
                .add("layer_points", 361)
                .add("checksum", "7fd2"));
        add(JournalKind::command, "home", sender(JournalFacts{}, "done"));
        add(JournalKind::command, "jog",
            sender(JournalFacts{}.add("axis", "r1").add("value", "-5.5"), "refused")
                .add("reason", "jog: not while carving; wait, or stop"));
        add(JournalKind::job, "started",
            JournalFacts{}.add("source", "vase.stl").add("first_layer", 12).add("first_point", 56));
        add(JournalKind::command, "estop", {});
        add(JournalKind::alarm, "steps lost",
            progress(JournalFacts{}
                         .add("axis", "psi")
                         .add("expected", 6400)
                         .add("seen", 6390)
                         .add("first_wrong_layer", 12)
                         .add("wrong_layers", 2)
                         .add("signals", 0)
                         .add("r1_pulses", 600)
                         .add("r2_pulses", -1)
                         .add("psi_pulses", 6390)
                         .add("y_pulses", 0)));
        add(JournalKind::job, "ended",
            progress(JournalFacts{}.add("source", "vase.stl").add("how", "alarm")));
        add(JournalKind::core, "missed ticks", JournalFacts{}.add("count", 7).add("total", 9));
        add(JournalKind::command, "left out", JournalFacts{}.add("count", 2500));
        add(JournalKind::core, "not written", JournalFacts{}.add("count", 3));
        add(JournalKind::core, "end", JournalFacts{}.add("state", "alarm").add("cause", "steps lost"));
    }
    static JournalFacts sender(JournalFacts facts, const char* answer) {
        return facts.add("pid", 78).add("uid", 0).add("sender", "psicarve").add("answer", answer);
    }
    static JournalFacts progress(JournalFacts facts) {
        return facts.add("layer", 13).add("point", 9).add("points_done", 4702).add("points_total", 144400);
    }

    std::uint64_t sequence_ = 0;
};

TEST_F(LogCommand, TellsEverythingInLocalTimeTheNewestLast) {
    add_all();
    const Outcome outcome = log();
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(
        outcome.out,
        R"(2025-11-27 01:44:05 +0100  core     simulator  start: version 1.2.3, port sim, real clock, profile 00ff, pid 77; the one before was killed or crashed
2025-11-27 01:45:05 +0100  job      simulator  loaded vase\u001b[2J.stl, 400 layers of 361 points, job 7fd2
2025-11-27 01:46:05 +0100  command  simulator  home: done (psicarve, pid 78, root)
2025-11-27 01:47:05 +0100  command  simulator  jog r1 -5.5: refused, not while carving; wait, or stop (psicarve, pid 78, root)
2025-11-27 01:48:05 +0100  job      simulator  started vase.stl with layer 12, point 56
2025-11-27 01:49:05 +0100  command  simulator  estop
2025-11-27 01:50:05 +0100  alarm    simulator  steps lost, psi at layer 13, point 9 (4702 of 144400 points); expected 6400 pulses, seen 6390; wrong may be 2 layers from 12; at r1 600 r2 -1 psi 6390 y 0 pulses
2025-11-27 01:51:05 +0100  job      simulator  ended vase.stl: alarm at layer 13, point 9 (4702 of 144400 points)
2025-11-27 01:52:05 +0100  core     simulator  7 ticks missed, 9 since the start
2025-11-27 01:53:05 +0100  command  simulator  2500 more commands came too fast to be kept
2025-11-27 01:54:05 +0100  core     simulator  3 records could not be written
2025-11-27 01:55:05 +0100  core     simulator  end, the machine alarm: steps lost
)");
}

TEST_F(LogCommand, TellsWhereAProgramWasHeldAndHowItEnded) {
    add(JournalKind::job, "program started", JournalFacts{}.add("number", 7).add("single", 1));
    add(JournalKind::job, "program held", JournalFacts{}.add("how", "tool change").add("line", 8));
    add(JournalKind::job, "program resumed", JournalFacts{}.add("line", 8));
    add(JournalKind::job, "program held", JournalFacts{}.add("line", 9));
    add(JournalKind::job, "program ended",
        JournalFacts{}.add("how", "stopped").add("line", 9).add("waits", 2));
    const std::string out = log().out;
    for (const char* const words :
         {"program started, no. 7, single block\n", "program held: tool change at line 8\n",
          "program resumed at line 8\n", "program held at line 9\n",
          "program ended: stopped at line 9; it had to wait for more 2 times\n"})
        EXPECT_NE(out.find(words), std::string::npos) << out;
}

TEST_F(LogCommand, ShowsOnlyWhatIsAskedFor) {
    add_all();
    const auto lines = [&](std::vector<std::string> more) {
        const std::string out = log(std::move(more)).out;
        return std::count(out.begin(), out.end(), '\n');
    };
    EXPECT_EQ(lines({"--kind", "alarm"}), 1);
    EXPECT_EQ(lines({"--kind", "alarm", "--kind", "command"}), 5);
    EXPECT_EQ(lines({"--kind", "alarm,core"}), 5);
    EXPECT_EQ(lines({"--last", "3"}), 3);
    EXPECT_EQ(lines({"--kind", "core", "--last", "2"}), 2);
    EXPECT_EQ(lines({"--since", "2025-11-27 01:50"}), 6);
    EXPECT_EQ(lines({"--since", "2025-11-27T00:50:05Z"}), 6);
    EXPECT_EQ(lines({"--since", "2025-11-27"}), 12);
    EXPECT_EQ(lines({"--since", "2025-11-28"}), 0);
    EXPECT_EQ(lines({"--since", "1h"}), 0);
    EXPECT_EQ(lines({"--since", "5000w"}), 12);
    EXPECT_EQ(log({"--since", "1h"}).exit_code, 0);
}

TEST_F(LogCommand, RefusesWhatIsNoTimeAndNoKind) {
    for (const char* since : {"yesterday", "5", "5x", "-5m", "2025-02-31", "25:00", "2025-11-27 01:50 x",
                              "99999999999999999w", ""}) {
        const Outcome outcome = log({"--since", since});
        EXPECT_EQ(outcome.exit_code, 2) << since;
        EXPECT_EQ(outcome.error_lines(), 1U) << since;
    }
    const Outcome kind = log({"--kind", "alarms"});
    EXPECT_EQ(kind.exit_code, 2);
    EXPECT_NE(kind.error.find("alarm, command, job or core"), std::string::npos) << kind.error;
    EXPECT_EQ(log({"--last", "0"}).exit_code, 2);
}

TEST_F(LogCommand, JsonIsAnObjectALine) {
    add_all();
    const Outcome outcome = log({"--json", "--kind", "command", "--last", "3"});
    std::istringstream lines{outcome.out};
    std::vector<nlohmann::json> objects;
    for (std::string line; std::getline(lines, line);) objects.push_back(nlohmann::json::parse(line));
    ASSERT_EQ(objects.size(), 3U);
    EXPECT_EQ(objects[0].at("time"), "2025-11-27T00:47:05Z");
    EXPECT_EQ(objects[0].at("kind"), "command");
    EXPECT_EQ(objects[0].at("what"), "jog");
    EXPECT_EQ(objects[0].at("sequence"), 4);
    EXPECT_EQ(objects[0].at("is_simulator"), true);
    EXPECT_EQ(objects[0].at("facts").at("value"), "-5.5");
    EXPECT_EQ(objects[0].at("facts").at("pid"), 78);
    EXPECT_EQ(objects[2].at("facts").at("count"), 2500);
}

TEST_F(LogCommand, BothKindsOfMachinesAreMergedByTime) {
    add(JournalKind::command, "home", {}, true);
    add(JournalKind::command, "hold", {}, false);
    add(JournalKind::command, "stop", {}, true);
    const Outcome outcome = log();
    EXPECT_NE(outcome.out.find("simulator  home\n"), std::string::npos) << outcome.out;
    EXPECT_LT(outcome.out.find("simulator  home\n"), outcome.out.find("machine    hold\n"));
    EXPECT_LT(outcome.out.find("machine    hold\n"), outcome.out.find("simulator  stop\n"));
}

TEST_F(LogCommand, ADamagedRecordIsToldAndHidesNoOther) {
    add(JournalKind::command, "home", {});
    append("0123456789abcdef seq=1 garbage\n");
    add(JournalKind::command, "stop", {});
    const Outcome outcome = log();
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2);
    EXPECT_EQ(outcome.error, "psicarve: warning: 1 damaged or torn records are left out\n");
}

TEST_F(LogCommand, AFileThatCannotBeReadHidesNoOther) {
    const JournalFiles machine{StateNames{folder_.string(), segment_, false}};
    std::filesystem::create_directory(machine.newer);
    const Outcome alone = log();
    EXPECT_EQ(alone.exit_code, 3);
    EXPECT_NE(alone.error.find("is no file"), std::string::npos) << alone.error;
    add(JournalKind::command, "home", {});
    const Outcome outcome = log();
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out.find("home"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.error, "psicarve: warning: " + machine.newer + ": is no file\n");
}

TEST_F(LogCommand, FollowingGoesOnOverWhatCannotBeReadAndTellsOfDamage) {
    const JournalFiles machine{StateNames{folder_.string(), segment_, false}};
    add(JournalKind::command, "home", {});
    RunningProgram sut{"psicarve", {"log", "--follow", "--state", folder_.string(), "--segment", segment_}};
    const auto shows = [&](const std::string& what) {
        return eventually([&] { return sut.out_so_far().find(what) != std::string::npos; });
    };
    ASSERT_TRUE(shows("home"));
    std::filesystem::create_directory(machine.newer);
    append("0123456789abcdef seq=1 garbage\n");
    add(JournalKind::command, "hold", {});
    ASSERT_TRUE(shows("hold"));
    add(JournalKind::command, "stop", {});
    ASSERT_TRUE(shows("stop"));
    sut.send(SIGINT);
    EXPECT_EQ(sut.wait(), 0);
    const std::string error = sut.error();
    EXPECT_NE(error.find("1 damaged or torn records are left out\n"), std::string::npos) << error;
    const std::size_t first = error.find("is no file");
    EXPECT_NE(first, std::string::npos) << error;
    EXPECT_EQ(error.find("is no file", first + 1), std::string::npos) << error;
}

TEST_F(LogCommand, AStartTellsHowTheOneBeforeEnded) {
    const auto told = [&](const char* before) {
        add(JournalKind::core, "start", JournalFacts{}.add("before", before));
        return log({"--last", "1"}).out;
    };
    EXPECT_NE(told("none").find("; the first one\n"), std::string::npos);
    EXPECT_NE(told("in order").find("; the one before ended in order\n"), std::string::npos);
    EXPECT_NE(told("unknown").find("; how the one before ended is not known\n"), std::string::npos);
    EXPECT_NE(told("no end").find("has no end: killed, crashed, or the computer was switched off\n"),
              std::string::npos);
    EXPECT_NE(told("no end, started again")
                  .find("has no end: killed, crashed, or the computer was switched off; the computer was "
                        "started again since\n"),
              std::string::npos);
}

TEST_F(LogCommand, WithoutAJournalItSaysWhere) {
    const Outcome outcome = log();
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error_lines(), 1U);
    EXPECT_NE(outcome.error.find(folder_.string()), std::string::npos) << outcome.error;
}

TEST_F(LogCommand, OfAnotherSegmentNothingIsShown) {
    add_all();
    EXPECT_EQ(psicarve({"log", "--state", folder_.string(), "--segment", segment_ + "x"}).exit_code, 3);
}

TEST_F(LogCommand, ItFollowsUntilCtrlC) {
    add(JournalKind::command, "home", {});
    RunningProgram sut{"psicarve", {"log", "--follow", "--state", folder_.string(), "--segment", segment_}};
    const auto shows = [&](const std::string& what) {
        return eventually([&] { return sut.out_so_far().find(what) != std::string::npos; });
    };
    ASSERT_TRUE(shows("home"));
    const JournalFiles files{StateNames{folder_.string(), segment_, true}};
    std::filesystem::rename(files.newer, files.older);
    add(JournalKind::command, "hold", {});
    EXPECT_TRUE(shows("hold"));
    // A line that is begun is shown once it is whole.
    append("0123");
    add(JournalKind::command, "resume", {});
    add(JournalKind::command, "stop", {}, false);
    EXPECT_TRUE(shows("stop"));
    sut.send(SIGINT);
    EXPECT_EQ(sut.wait(), 0);
    EXPECT_EQ(sut.error(), "psicarve: warning: 1 damaged or torn records are left out\n");
    EXPECT_EQ(sut.out().find("resume"), std::string::npos) << "torn";
}

}  // namespace
}  // namespace psicarve::test
