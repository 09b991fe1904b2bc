// SPDX-License-Identifier: GPL-3.0-or-later
// What a real core writes down of its machine, on good disks and bad ones, and what `psicarve log` finds.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "shared/record/journal_file.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

/// Processes that are started meanwhile find this disk (disk_preload.cpp).
class RuledDisk {
public:
    RuledDisk(const std::string& folder, const std::string& rules) {
        const char* const options = std::getenv("ASAN_OPTIONS");
        options_before_ = options == nullptr ? "" : options;
        setenv("LD_PRELOAD", in_build("tests/disk_preload.so").c_str(), 1);
        setenv("ASAN_OPTIONS", (options_before_ + ":verify_asan_link_order=0").c_str(), 1);
        setenv("PSICARVE_DISK", folder.c_str(), 1);
        setenv("PSICARVE_DISK_RULES", rules.c_str(), 1);
    }
    ~RuledDisk() {
        for (const char* name : {"LD_PRELOAD", "PSICARVE_DISK", "PSICARVE_DISK_RULES"}) unsetenv(name);
        setenv("ASAN_OPTIONS", options_before_.c_str(), 1);
    }
    RuledDisk(const RuledDisk&) = delete;
    RuledDisk& operator=(const RuledDisk&) = delete;

private:
    std::string options_before_;
};

class CoreJournal : public CoreRig {
protected:
    std::string state() const { return file("state"); }
    JournalFiles files() const { return JournalFiles{StateNames{state(), segment_name_, true}}; }
    void start_kept() { start_core({"--state", state()}); }
    void disk_is(const std::string& rules) const { std::ofstream{file("rules")} << rules; }
    void start_on_ruled_disk() {
        const RuledDisk disk{state(), file("rules")};
        start_kept();
    }
    std::vector<JournalRecord> records() const {
        auto read = read_journal(files());
        return read ? std::move(*read) : std::vector<JournalRecord>{};
    }
    std::size_t count_of(JournalKind kind, const std::string& what) const {
        const auto all = records();
        return static_cast<std::size_t>(std::ranges::count_if(
            all, [&](const JournalRecord& record) { return record.kind == kind && record.what == what; }));
    }
    bool comes(JournalKind kind, const std::string& what, std::size_t count = 1) const {
        return eventually([&] { return count_of(kind, what) >= count; });
    }
    JournalRecord last(JournalKind kind, const std::string& what) const {
        JournalRecord found;
        for (JournalRecord& record : records())
            if (record.kind == kind && record.what == what) found = std::move(record);
        return found;
    }
    test::Outcome log(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"log", "--state", state(), "--segment", segment_name_});
        return test::psicarve(more);
    }
};

TEST_F(CoreJournal, TellsOfARunFromItsStartToItsEnd) {
    start_kept();
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    EXPECT_NE(refusal_of(CommandKind::start), "");
    home();
    start_carving();
    ASSERT_TRUE(reaches(MachineState::ready));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    const JournalRecord start = last(JournalKind::core, "start");
    EXPECT_EQ(start.facts.text("port"), "sim");
    EXPECT_EQ(start.facts.text("clock"), "virtual");
    EXPECT_EQ(start.facts.text("before"), "none");
    EXPECT_EQ(start.facts.number("pid"), core_->pid());
    const JournalRecord loaded = last(JournalKind::job, "loaded");
    EXPECT_EQ(loaded.facts.number("layers"), 3);
    const JournalRecord sent = last(JournalKind::command, "home");
    EXPECT_EQ(sent.facts.text("answer"), "done");
    EXPECT_EQ(sent.facts.number("pid"), ::getpid());
    EXPECT_EQ(sent.facts.number("uid"), std::int64_t{::geteuid()});
    EXPECT_FALSE(sent.facts.text("sender").empty());
    const auto all = records();
    const auto refused = std::ranges::find_if(all, [](const JournalRecord& record) {
        return record.what == "start" && record.facts.text("answer") == "refused";
    });
    ASSERT_NE(refused, all.end());
    EXPECT_NE(refused->facts.text("reason").find("home"), std::string::npos) << refused->facts.text("reason");
    EXPECT_EQ(refused->facts.text("message"), "not_homed");
    EXPECT_EQ(count_of(JournalKind::job, "started"), 1U);
    const JournalRecord ended = last(JournalKind::job, "ended");
    EXPECT_EQ(ended.facts.text("how"), "done");
    EXPECT_EQ(ended.facts.number("points_done"), 99);
    EXPECT_EQ(ended.facts.number("points_total"), 99);
    EXPECT_EQ(all.back().what, "end");
    EXPECT_EQ(last(JournalKind::command, "shutdown").facts.text("answer"), "done");
}

TEST_F(CoreJournal, ACoreThatIsKilledIsToldOfByTheNext) {
    start_kept();
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(comes(JournalKind::command, "start-interpolation"));
    ::kill(core_->pid(), SIGKILL);
    (void)core_->wait_for_exit();
    start_kept();
    ASSERT_TRUE(comes(JournalKind::core, "start", 2));
    EXPECT_EQ(last(JournalKind::core, "start").facts.text("before"), "killed");
    const test::Outcome told = log({"--kind", "core"});
    EXPECT_EQ(told.exit_code, 0) << told.error;
    EXPECT_NE(told.out.find("the one before was killed or crashed"), std::string::npos) << told.out;
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    start_kept();
    ASSERT_TRUE(comes(JournalKind::core, "start", 3));
    EXPECT_EQ(last(JournalKind::core, "start").facts.text("before"), "in order");
    std::uint64_t before = 0;
    for (const JournalRecord& record : records()) EXPECT_EQ(record.sequence, ++before);
}

TEST_F(CoreJournal, AnAlarmHasItsPlaceInTheJob) {
    start_kept();
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().layer > 2; }));
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    ASSERT_TRUE(comes(JournalKind::job, "ended"));
    EXPECT_EQ(count_of(JournalKind::command, "estop"), 1U);
    const JournalRecord alarm = last(JournalKind::alarm, "emergency stop");
    EXPECT_GT(alarm.facts.number("layer").value_or(0), 2);
    EXPECT_EQ(alarm.facts.number("y_pulses"), status().position_pulses[index_of(Axis::y)]);
    EXPECT_EQ(last(JournalKind::job, "ended").facts.text("how"), "alarm");
    // It was the last second of a computer that is switched off now.
    ::kill(core_->pid(), SIGKILL);
    (void)core_->wait_for_exit();
    EXPECT_NE(log({"--kind", "alarm"}).out.find("emergency stop at layer"), std::string::npos);
}

TEST_F(CoreJournal, AFloodOfCommandsPushesNothingOut) {
    start_kept();
    constexpr std::size_t kFlood = 1200;
    for (std::size_t i = 0; i < kFlood; ++i) ASSERT_NE(refusal_of(CommandKind::hold), "");
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_TRUE(comes(JournalKind::alarm, "emergency stop"));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    const std::size_t kept = count_of(JournalKind::command, "hold");
    EXPECT_GE(kept, 400U);
    EXPECT_LE(kept, 600U);
    std::int64_t left_out = 0;
    for (const JournalRecord& record : records())
        if (record.what == "left out") left_out += record.facts.number("count").value_or(0);
    // The emergency stop and the shutdown may be among them.
    EXPECT_GE(left_out, static_cast<std::int64_t>(kFlood - kept));
    EXPECT_LE(left_out, static_cast<std::int64_t>(kFlood - kept + 2));
    EXPECT_LE(count_of(JournalKind::command, "left out"), 10U);
    EXPECT_EQ(count_of(JournalKind::core, "start"), 1U);
}

TEST_F(CoreJournal, ADiskThatHangsHoldsBackNoCommandNoStopAndNoEnd) {
    disk_is("hangs");
    start_on_ruled_disk();
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    // More than may wait for it.
    for (int i = 0; i < 1500; ++i) ASSERT_NE(refusal_of(CommandKind::home), "");
    const std::uint64_t heartbeat = status().heartbeat;
    ASSERT_TRUE(eventually([&] { return status().heartbeat > heartbeat; }));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    const RuledDisk disk{state(), file("rules")};
    const test::Outcome told = log();
    EXPECT_EQ(told.exit_code, 3);
    EXPECT_NE(told.error.find("does not answer"), std::string::npos) << told.error;
}

TEST_F(CoreJournal, ADiskThatTakesNothingIsToldOnceAndCountedLater) {
    disk_is("takes_nothing");
    start_on_ruled_disk();
    const auto said = [&] { return text_of(file("core.err")); };
    ASSERT_TRUE(eventually([&] { return said().find("is not written down") != std::string::npos; }))
        << said();
    for (int i = 0; i < 5; ++i) ASSERT_NE(refusal_of(CommandKind::hold), "");
    disk_is("");
    ASSERT_NE(refusal_of(CommandKind::resume), "");
    ASSERT_TRUE(comes(JournalKind::command, "resume"));
    EXPECT_GE(last(JournalKind::core, "not written").facts.number("count").value_or(0), 1);
    const std::size_t first = said().find("is not written down");
    EXPECT_EQ(said().find("is not written down", first + 1), std::string::npos) << said();
}

TEST_F(CoreJournal, FollowingGoesOnOverACoreThatIsKilled) {
    start_kept();
    test::RunningProgram sut{"psicarve", {"log", "--follow", "--state", state(), "--segment", segment_name_}};
    const auto shows = [&](const std::string& what) {
        return eventually([&] { return sut.out_so_far().find(what) != std::string::npos; });
    };
    ASSERT_TRUE(shows("the first one"));
    ::kill(core_->pid(), SIGKILL);
    (void)core_->wait_for_exit();
    start_kept();
    EXPECT_TRUE(shows("the one before was killed"));
    ASSERT_NE(refusal_of(CommandKind::hold), "");
    EXPECT_TRUE(shows("hold: refused"));
    sut.send(SIGINT);
    EXPECT_EQ(sut.wait(), 0);
}

TEST_F(CoreJournal, IsNoneOfACoreThatKeepsNothing) {
    start_core();
    ASSERT_NE(refusal_of(CommandKind::hold), "");
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    EXPECT_EQ(log().exit_code, 3);
}

}  // namespace
}  // namespace psicarve::two_process
