// SPDX-License-Identifier: GPL-3.0-or-later
// Page Messages: kinds, the selected one in full, an alarm's moment in the flight recorder.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "hmi/replay/entry.hpp"
#include "shared/record/journal_file.hpp"
#include "tests/hmi/ui/pages_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class MessagesPageOf : public test::PagesRig {
protected:
    QTableView& table() { return part<QTableView>("messages"); }
    QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
    QStringList shown() {
        window_->refresh();
        QStringList texts;
        for (int row = 0; row < table().model()->rowCount(); ++row) texts += cell(row, 3);
        return texts;
    }
    bool select(const QString& what) {
        for (int row = 0; row < table().model()->rowCount(); ++row) {
            if (cell(row, 3) != what) continue;
            table().selectRow(row);
            return true;
        }
        return false;
    }
    void show_kind(int kind) { part<QComboBox>("messages_kind").setCurrentIndex(kind); }
    bool is_pane_there() { return !part<QLabel>("message_title").isHidden(); }
    /// Stopped in an emergency, reset and homed since.
    void have_an_alarm_behind() {
        start_core();
        open_window();
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
        window_->emergency_stop();
        ASSERT_TRUE(comes_to(S::alarm));
        ASSERT_TRUE(click("reset_alarm"));
        ASSERT_TRUE(comes_to(S::off));
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
        show_page("messages_page");
    }
};

/// Written down by a core of long ago, on the simulator.
class HistoryPageOf : public MessagesPageOf {
protected:
    HistoryPageOf() { qputenv("PSICARVE_STATE", QByteArray::fromStdString(journals())); }
    ~HistoryPageOf() override { qputenv("PSICARVE_STATE", ""); }
    std::string journals() const { return file("journals"); }
    void write_down(JournalKind kind, const std::string& what, const JournalFacts& facts) {
        JournalRecord record;
        record.sequence = ++sequence_;
        record.run = 3;
        record.time_ms = 1'606'000'000'000 + static_cast<std::int64_t>(sequence_) * 1000;
        record.kind = kind;
        record.what = what;
        record.facts = facts;
        std::filesystem::create_directories(journals());
        const JournalFiles files{StateNames{journals(), segment_name_, true}};
        std::ofstream{files.newer, std::ios::app} << journal_line(record);
    }
    bool is_history_read() {
        return comes_true([&] { return window_->context().history.is_read(); });
    }

private:
    std::uint64_t sequence_ = 0;
};

TEST_F(HistoryPageOf, IsBelowWhatThisWindowHasSeenInItsOwnWords) {
    write_down(JournalKind::alarm, "limit", JournalFacts{}.add("axis", "r2").add("layer", 4).add("point", 7));
    write_down(
        JournalKind::command, "jog",
        JournalFacts{}.add("answer", "refused").add("message", "not_homed").add("reason", "old words"));
    open_window();
    ASSERT_TRUE(is_history_read());
    window_->context().log.add(session::Severity::info, session::phrase("Opened %1", "vase.stl"));
    show_page("messages_page");
    const QStringList all = shown();
    ASSERT_GE(all.size(), 3);
    EXPECT_EQ(all.front(), "Opened vase.stl");
    EXPECT_EQ(all[all.size() - 2], "Command: jog: the machine is not homed; home first");
    EXPECT_EQ(all.back(), "Limit switch R2 closed (layer 5, point 8)");
    EXPECT_TRUE(cell(static_cast<int>(all.size()) - 1, 0).startsWith("2020-11-2")) << "the year is told";
    show_kind(1);
    EXPECT_EQ(shown(), QStringList{"Limit switch R2 closed (layer 5, point 8)"});
    ASSERT_TRUE(select("Limit switch R2 closed (layer 5, point 8)"));
    EXPECT_TRUE(text_of("message_when").endsWith("journal of the simulator, run 3"))
        << text_of("message_when").toStdString();
    EXPECT_TRUE(text_of("message_cause").contains("Axis R2 stopped"));
    EXPECT_FALSE(button("message_recorder").isEnabled());
    show_kind(0);
    part<QLineEdit>("messages_find").setText("JOG");
    EXPECT_EQ(shown(), QStringList{"Command: jog: the machine is not homed; home first"});
    part<QLineEdit>("messages_find").clear();
    take_picture("messages_history_light");
    part<QComboBox>("messages_span").setCurrentIndex(1);
    EXPECT_FALSE(shown().contains("Limit switch R2 closed (layer 5, point 8)"));
    EXPECT_TRUE(shown().contains("Opened vase.stl"));
}

TEST_F(HistoryPageOf, HasNoAlarmTwiceThatTheCoreStillTellsOf) {
    start_core({"--state", journals()});
    open_window();
    ASSERT_TRUE(comes_to(S::off));
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(comes_to(S::off));
    const JournalFiles files{StateNames{journals(), segment_name_, true}};
    ASSERT_TRUE(comes_true([&] {
        const auto records = read_journal(files);
        return records && std::ranges::any_of(*records, [](const JournalRecord& record) {
                   return record.kind == JournalKind::command && record.what == "reset-alarm";
               });
    }));
    open_window();
    ASSERT_TRUE(comes_to(S::off));
    ASSERT_TRUE(is_history_read());
    ASSERT_GE(window_->context().history.messages().size(), 3U);
    show_page("messages_page");
    show_kind(1);
    EXPECT_EQ(shown(), QStringList{"Before this window was there: Emergency stop"});
    show_kind(0);
    EXPECT_TRUE(shown().contains("Command: reset-alarm"));
}

// Seven thousand rows: each look at the machine stays short, as only rows that are seen are laid out.
TEST_F(HistoryPageOf, OfThousandsIsThereToItsBound) {
    for (int i = 0; i < 5'200; ++i) write_down(JournalKind::core, "end", JournalFacts{}.add("state", "off"));
    open_window();
    ASSERT_TRUE(is_history_read());
    show_page("messages_page");
    const auto count = static_cast<std::size_t>(shown().size());
    EXPECT_EQ(window_->context().history.messages().size(), session::JournalHistory::kMost);
    EXPECT_EQ(count, session::JournalHistory::kMost + window_->context().log.messages().size());
    for (int i = 0; i < 2'100; ++i)
        window_->context().log.add(session::Severity::info, session::phrase("Opened %1", "vase.stl"));
    EXPECT_EQ(static_cast<std::size_t>(shown().size()),
              session::JournalHistory::kMost + session::MessageLog::kMost);
}

TEST_F(MessagesPageOf, AreChosenByTheirKind) {
    open_window();
    session::MessageLog& log = window_->context().log;
    log.add(session::Severity::info, session::phrase("Opened %1", "vase.stl"));
    log.add(session::Severity::warning, session::phrase("Not saved: %1", "disk full"));
    log.add(session::Severity::alarm, session::phrase("Emergency stop"));
    log.add_command(session::Severity::info, session::phrase("Stop asked for"));
    log.add_command(session::Severity::warning, session::phrase("Start: %1", "home first"));
    show_page("messages_page");
    show_kind(1);
    EXPECT_EQ(shown(), QStringList{"Emergency stop"});
    show_kind(2);
    EXPECT_EQ(shown(), (QStringList{"Start: home first", "Not saved: disk full"}));
    show_kind(3);
    EXPECT_EQ(shown(), (QStringList{"Start: home first", "Stop asked for"}));
    show_kind(4);
    EXPECT_TRUE(shown().contains("Opened vase.stl"));
    EXPECT_FALSE(shown().contains("Stop asked for"));
    show_kind(0);
    EXPECT_GE(shown().size(), 5);
}

TEST_F(MessagesPageOf, TellTheSelectedOneInFullUntilItIsFilteredAway) {
    ASSERT_NO_FATAL_FAILURE(have_an_alarm_behind());
    EXPECT_FALSE(is_pane_there());
    EXPECT_TRUE(shown().contains("Asked for: Home"));
    ASSERT_TRUE(select("Emergency stop"));
    ASSERT_TRUE(is_pane_there());
    EXPECT_EQ(text_of("message_title"), "Emergency stop");
    EXPECT_TRUE(text_of("message_cause").contains("spindle")) << text_of("message_cause").toStdString();
    EXPECT_TRUE(text_of("message_steps").startsWith("1. Reset alarm"))
        << text_of("message_steps").toStdString();
    window_->context().log.add(session::Severity::info, session::phrase("Opened %1", "vase.stl"));
    window_->refresh();
    EXPECT_EQ(text_of("message_title"), "Emergency stop") << "a newer one stands above it";
    take_picture("message_pane_light");
    window_->set_theme(ThemeChoice::dark);
    ASSERT_TRUE(select("Emergency stop"));
    take_picture("message_pane_dark");
    ASSERT_TRUE(select("Opened vase.stl"));
    EXPECT_EQ(text_of("message_title"), "Opened vase.stl");
    EXPECT_FALSE(button("message_recorder").isEnabled());
    part<QLineEdit>("messages_find").setText("emergency");
    EXPECT_FALSE(is_pane_there());
}

TEST_F(MessagesPageOf, LeadFromAnAlarmToItsMomentInTheFlightRecorder) {
    ASSERT_NO_FATAL_FAILURE(have_an_alarm_behind());
    ASSERT_TRUE(select("Emergency stop"));
    ASSERT_TRUE(click("message_recorder"));
    replay::ReplaySession& desk = window_->context().replay;
    ASSERT_TRUE(comes_true([&] { return desk.is_open(); })) << all_messages().toStdString();
    const auto& entries = desk.facts().entries;
    const int at = replay::entry_at(entries, desk.clock().now_ns());
    ASSERT_GE(at, 0);
    const auto is_alarm = [&](int entry) {
        return entries[static_cast<std::size_t>(entry)].severity == session::Severity::alarm;
    };
    bool is_there = false;
    for (int entry = at; entry >= 0; --entry)
        is_there |=
            is_alarm(entry) && entries[static_cast<std::size_t>(entry)].time_ns == desk.clock().now_ns();
    EXPECT_TRUE(is_there) << desk.clock().now_ns();
    EXPECT_LT(desk.clock().now_ns(), desk.facts().end_ns) << "much was homed since";
}

TEST_F(MessagesPageOf, HaveThePaneWhereItIsWhateverIsSelected) {
    ASSERT_NO_FATAL_FAILURE(have_an_alarm_behind());
    const auto place_of = [&](const char* name) {
        QApplication::processEvents();
        QWidget& widget = part<QWidget>(name);
        return QRect{widget.mapTo(window_.get(), QPoint{}), widget.size()};
    };
    const QRect pane = place_of("message_pane");
    const QRect recorder = place_of("message_recorder");
    EXPECT_TRUE(part<QWidget>("message_pane").isVisible());
    ASSERT_TRUE(select("Emergency stop"));
    EXPECT_EQ(place_of("message_pane"), pane) << "a second press would be on what came up";
    EXPECT_EQ(place_of("message_recorder"), recorder);
    EXPECT_FALSE(recorder.intersects(place_of("messages")));
}

TEST_F(MessagesPageOf, OpenNoRecorderWhileTheMachineIsUnderWay) {
    ASSERT_NO_FATAL_FAILURE(have_an_alarm_behind());
    ASSERT_TRUE(select("Emergency stop"));
    ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
    EXPECT_FALSE(button("message_recorder").isEnabled());
    EXPECT_TRUE(button("message_recorder").toolTip().contains("under way"))
        << button("message_recorder").toolTip().toStdString();
    request_stop(*segment_);
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(comes_true([&] { return button("message_recorder").isEnabled(); }));
}

TEST_F(MessagesPageOf, SayThatTheFlightRecorderOfAnotherCoreIsGone) {
    ASSERT_NO_FATAL_FAILURE(have_an_alarm_behind());
    ASSERT_TRUE(select("Emergency stop"));
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    const auto before = machine_view().core_pid;
    start_core();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard() && machine_view().core_pid != before; }));
    EXPECT_FALSE(button("message_recorder").isEnabled());
    EXPECT_TRUE(button("message_recorder").toolTip().contains("core is gone"));
}

}  // namespace
}  // namespace psicarve::ui
