// SPDX-License-Identifier: GPL-3.0-or-later
// A recording in the window: everything shows its moment, nothing moves, the live machine stays in view.
#include <gtest/gtest.h>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QSlider>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>

#include <fstream>

#include "hmi/ui/language.hpp"
#include "hmi/ui/state_pill.hpp"
#include "hmi/ui/timeline_view.hpp"
#include "tests/hmi/replay/recorded_run.hpp"
#include "tests/hmi/ui/fit_audit.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

class ReplayWindow : public replay::test::RecordedOn<WindowRig> {
protected:
    replay::ReplaySession& desk() { return window_->context().replay; }
    void open_recording(const std::string& path) {
        window_->open(QString::fromStdString(path));
        ASSERT_TRUE(comes_true([&] { return desk().is_open() && desk().is_settled(); }))
            << all_messages().toStdString();
    }
    void go_to(double share) {
        desk().clock().seek(static_cast<std::int64_t>(share * static_cast<double>(desk().facts().end_ns)));
        ASSERT_TRUE(comes_true([&] { return desk().is_settled(); }));
    }
    QString text_of(const char* label) { return window_->findChild<QLabel*>(label)->text(); }
    void show_page(int index) { window_->findChild<QTabWidget*>()->setCurrentIndex(index); }
    TimelineView& timeline() { return *static_cast<TimelineView*>(window_->findChild<QWidget*>("timeline")); }
    QString pill() { return static_cast<StatePill*>(window_->findChild<QWidget*>("state_pill"))->word(); }
    void press_key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QKeyEvent press{QEvent::KeyPress, key, modifiers};
        QApplication::sendEvent(&timeline(), &press);
    }
};

TEST_F(ReplayWindow, LocksWhatWouldHelpARefusedModel) {
    record();
    open_window();
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    part<QDoubleSpinBox>("scale").setValue(10.0);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("desk_refusal").isVisible(); }));
    ASSERT_TRUE(button("remedy_height").isEnabled());
    // As one that was still being read when slicing was asked for.
    desk().open(trace(), Profile{});
    ASSERT_TRUE(comes_true([&] { return desk().is_open() && desk().is_settled(); }));
    window_->refresh();
    ASSERT_FALSE(part<QWidget>("desk_refusal").isHidden());
    EXPECT_FALSE(button("slice").isEnabled());
    EXPECT_FALSE(button("remedy_height").isEnabled());
    EXPECT_EQ(button("remedy_height").toolTip(), button("slice").toolTip());
}

TEST_F(ReplayWindow, ShowsATracesMomentOnEveryPageAndLeavesAgain) {
    record();
    open_window();
    window_->set_theme(ThemeChoice::dark);
    open_recording(trace());
    EXPECT_TRUE(window_->windowTitle().contains("REPLAY: run.trace"));
    EXPECT_EQ(pill(), "REPLAY");
    EXPECT_TRUE(window_->findChild<QWidget*>("replay_bar")->isVisible());
    EXPECT_FALSE(part<QWidget>("dry_run").isEnabled());
    window_->context().replay.add_job(job());
    ASSERT_TRUE(comes_true([&] { return desk().carving() != nullptr && desk().is_settled(); }))
        << all_messages().toStdString();
    go_to(0.85);
    ASSERT_TRUE(desk().shown().place);
    const auto& status = *desk().view().status;
    const double r1_mm = static_cast<double>(status.position_pulses[0]) / Profile{}.r1.pulses_per_mm;
    EXPECT_EQ(text_of("position_r1"), QString::number(r1_mm, 'f', 2));
    EXPECT_TRUE(text_of("replay_place").startsWith(QString{"Layer %1 / 6"}.arg(status.layer + 1)));
    show_page(2);
    ASSERT_TRUE(comes_true([&] { return true; }));
    take_picture("replay_carving_dark");
    show_page(1);
    ASSERT_TRUE(comes_true([&] {
        return window_->findChild<QSlider*>("layer_slider")->value() == static_cast<int>(status.layer) + 1;
    }));
    take_picture("replay_layers_dark");
    show_page(3);
    ASSERT_TRUE(comes_true([&] { return desk().is_settled(); }));
    auto* const pins = window_->findChild<QTableWidget*>("pins");
    for (int row = 0; row < pins->rowCount(); ++row) {
        if (pins->item(row, 1)->text() == "Spindle") {
            EXPECT_TRUE(pins->item(row, 4)->text().contains("high"));
        }
    }
    take_picture("replay_ports_dark");
    show_page(5);
    ASSERT_TRUE(comes_true([&] { return true; }));
    auto* const entries = window_->findChild<QTableView*>("entries");
    EXPECT_TRUE(entries->isVisible());
    EXPECT_EQ(entries->model()->rowCount(), static_cast<int>(desk().facts().entries.size()));
    EXPECT_EQ(entries->selectionModel()->currentIndex().row(),
              replay::entry_at(desk().facts().entries, desk().clock().now_ns()));
    take_picture("replay_entries_dark");
    ASSERT_TRUE(click("replay_leave"));
    ASSERT_TRUE(comes_true([&] { return pill() == "NO CORE"; }));
    EXPECT_EQ(window_->windowTitle(), "Psicarve");
    EXPECT_FALSE(window_->findChild<QWidget*>("replay_bar")->isVisible());
}

TEST_F(ReplayWindow, MovesNothingWhileTheMachineIsReady) {
    record();
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    open_recording(snapshot());
    window_->refresh();
    for (const char* name :
         {"home", "home_one", "zero_one", "start", "hold", "resume", "stop", "from_layer", "full", "publish",
          "slice", "jog_r1_out", "jog_psi_plus", "jog_y_down", "back_off", "reset_alarm"}) {
        EXPECT_FALSE(button(name).isEnabled()) << name;
        EXPECT_EQ(button(name).toolTip(), "Replay moves nothing: leave replay first") << name;
    }
    EXPECT_FALSE(window_->findChild<QSlider*>("override")->isEnabled());
    // Nor by ways around the buttons.
    const auto positions = [&] {
        const auto& pulses = window_->context().machine.view().status->position_pulses;
        return std::vector<std::int64_t>(std::begin(pulses), std::end(pulses));
    };
    const auto before = positions();
    window_->context().machine.start(0);
    window_->context().machine.order(CommandKind::home, session::phrase("Home"));
    window_->context().machine.jog().step(Axis::y, 1.0, 5.0);
    window_->context().machine.jog().hold(Axis::y, true, 5.0);
    EXPECT_TRUE(all_messages().contains("Home: a recording is shown"));
    for (int i = 0; i < 30; ++i) ASSERT_TRUE(comes_true([&] { return true; }));
    EXPECT_EQ(positions(), before);
    EXPECT_EQ(window_->context().machine.view().state(), S::ready);
    take_picture("replay_snapshot_light");
    ASSERT_TRUE(click("replay_leave"));
    ASSERT_TRUE(click("jog_y_up"));
    ASSERT_TRUE(comes_true([&] { return positions() != before; }));
}

TEST_F(ReplayWindow, KeepsTheLiveMachineInSightAndTheEmergencyStopOnIt) {
    record();
    start_core();
    open_window();
    open_recording(trace());
    EXPECT_EQ(pill(), "REPLAY");
    QKeyEvent press{QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier};
    QApplication::sendEvent(window_.get(), &press);
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_TRUE(comes_true([&] { return pill() == "ALARM"; }));
    EXPECT_TRUE(window_->findChild<QLabel*>("alarm_title")->isVisible());
    bool is_badge_there = false;
    for (const QLabel* label : window_->findChildren<QLabel*>())
        is_badge_there = is_badge_there || (label->text() == "REPLAY" && label->isVisible());
    EXPECT_TRUE(is_badge_there);
    take_picture("replay_live_alarm_light");
}

TEST_F(ReplayWindow, LetsAHandHoldTheMachineThatCarvesButNotGoOn) {
    record();
    start_core();
    ASSERT_EQ(publish(two_process::long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(reaches(S::carving));
    open_window();
    open_recording(trace());
    window_->context().machine.order(CommandKind::hold, session::phrase("Hold"));
    ASSERT_TRUE(comes_to(S::held));
    window_->context().machine.order(CommandKind::resume, session::phrase("Resume"));
    EXPECT_TRUE(all_messages().contains("Resume: a recording is shown"));
    for (int i = 0; i < 30; ++i) ASSERT_TRUE(comes_true([&] { return true; }));
    EXPECT_EQ(window_->context().machine.view().state(), S::held);
}

TEST_F(ReplayWindow, IsScrubbedByMouseAndKeysAndPlayed) {
    record();
    open_window();
    open_recording(trace());
    const std::int64_t wanted_ns = desk().facts().end_ns / 3;
    const QPointF place{static_cast<double>(timeline().x_of(wanted_ns)), 30.0};
    QMouseEvent press{QEvent::MouseButtonPress, place, place, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier};
    QApplication::sendEvent(&timeline(), &press);
    EXPECT_NEAR(static_cast<double>(desk().clock().now_ns()), static_cast<double>(wanted_ns),
                static_cast<double>(desk().facts().end_ns) / 400.0);
    ASSERT_TRUE(comes_true([&] { return desk().is_settled(); }));
    const std::int64_t before_ns = desk().clock().now_ns();
    press_key(Qt::Key_Right);
    EXPECT_EQ(desk().clock().now_ns(), before_ns + 1'000'000'000);
    press_key(Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(desk().clock().now_ns(), before_ns + 990'000'000);
    press_key(Qt::Key_Home);
    EXPECT_EQ(desk().clock().now_ns(), 0);
    ASSERT_TRUE(click("replay_next"));
    EXPECT_EQ(desk().clock().now_ns(), desk().facts().entries[0].time_ns);
    EXPECT_FALSE(timeline().words_at(timeline().x_of(desk().clock().now_ns())).isEmpty());
    press_key(Qt::Key_End);
    ASSERT_TRUE(click("replay_before"));
    EXPECT_LT(desk().clock().now_ns(), desk().facts().end_ns);
    ASSERT_TRUE(click("replay_begin"));
    ASSERT_TRUE(click("replay_speed_100"));
    ASSERT_TRUE(click("replay_play"));
    ASSERT_TRUE(comes_true([&] { return desk().shown().time_ns == desk().facts().end_ns; }));
    EXPECT_FALSE(desk().clock().is_playing());
    EXPECT_EQ(button("replay_play").text(), "Play");
}

TEST_F(ReplayWindow, OpensTheJobOfASnapshotAndAModelInstead) {
    record();
    open_window();
    open_recording(snapshot());
    ASSERT_TRUE(click("replay_job"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    EXPECT_FALSE(desk().is_open());
    open_recording(snapshot());
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    EXPECT_FALSE(desk().is_open());
    EXPECT_EQ(test::KeptSettings{}.recent_files().size(), 2);
}

TEST_F(ReplayWindow, SaysInOneLineWhyAFileIsNone) {
    record();
    open_window();
    std::ofstream(file("cut.trace"), std::ios::binary) << two_process::text_of(trace()).substr(0, 50);
    window_->open(QString::fromStdString(file("cut.trace")));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("cut off inside its header"); }))
        << all_messages().toStdString();
    EXPECT_FALSE(desk().is_open());
    EXPECT_FALSE(window_->findChild<QWidget*>("replay_bar")->isVisible());
}

TEST_F(ReplayWindow, FitsTheSmallestScreenInEveryLanguage) {
    record();
    for (std::size_t i = 0; i < std::size(kLanguages); ++i) {
        use_language(static_cast<Language>(i));
        open_window();
        window_->resize(1280, 720);
        open_recording(trace());
        EXPECT_LE(window_->minimumSizeHint().width(), 1280);
        EXPECT_LE(window_->minimumSizeHint().height(), 720);
        show_page(5);
        ASSERT_TRUE(comes_true([&] { return true; }));
        QApplication::processEvents();  // the layout follows the figures
        for (const QAbstractButton* found : window_->findChildren<QAbstractButton*>()) {
            if (!found->isVisible() || found->text().isEmpty()) continue;
            EXPECT_GE(found->width(), found->minimumSizeHint().width()) << found->text().toStdString();
        }
        for (const QLabel* label : window_->findChildren<QLabel*>()) {
            if (!label->isVisible() || label->text().isEmpty() || label->wordWrap()) continue;
            EXPECT_GE(label->width() + 1, label->minimumSizeHint().width()) << label->text().toStdString();
        }
        take_picture(QString{"replay_language_%1"}.arg(i));
        window_->resize(960, 515);  // 1920 x 1080 at 200 %
        for (int look = 0; look < 3; ++look) ASSERT_TRUE(comes_true([&] { return true; }));
        QApplication::processEvents();
        for (const std::string& misfit : test::misfits(*window_)) ADD_FAILURE() << i << ": " << misfit;
        take_picture(QString{"replay_language_%1_small"}.arg(i));
    }
    use_language(Language::english);
}

TEST_F(ReplayWindow, SaysWhichNeighbourItDidNotTakeAsTheTracesJob) {
    record();
    JobTable other = two_process::lobed_job(kLayers, kPoints);
    for (std::int32_t& radius : other.r_left_pulses) radius += 100;
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(other);
    ASSERT_TRUE(save_snapshot(snapshot, file("run.snap")));
    open_window();
    open_recording(trace());
    window_->refresh();
    EXPECT_FALSE(desk().facts().job);
    const auto& warnings = part<QLabel>("replay_warnings");
    EXPECT_TRUE(warnings.isVisible());
    EXPECT_EQ(warnings.text(), "run.snap lies beside this trace, but is of another run: it is not used");
    take_picture("replay_refused_neighbour_light");
    window_->context().replay.add_job(job());
    ASSERT_TRUE(comes_true([&] { return desk().facts().job != nullptr; }));
    ASSERT_TRUE(comes_true([&] { return !warnings.isVisible(); }));
}

TEST_F(ReplayWindow, HoldsATraceAgainstItsJobAndShowsTheVerdict) {
    record();
    open_window();
    open_recording(trace());
    window_->refresh();
    ASSERT_TRUE(button("replay_verify").isVisible());
    if (!desk().facts().job) {
        EXPECT_FALSE(button("replay_verify").isEnabled()) << "against what?";
        EXPECT_FALSE(button("replay_verify").toolTip().isEmpty());
        window_->context().replay.add_job(job());
        ASSERT_TRUE(comes_true([&] { return desk().facts().job != nullptr; }))
            << all_messages().toStdString();
    }
    ASSERT_TRUE(click("replay_verify"));
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("verdict") != nullptr; }))
        << all_messages().toStdString();
    EXPECT_TRUE(all_messages().contains("Verified: the pins carve the job")) << all_messages().toStdString();
    QStringList texts;
    for (const QLabel* label : window_->findChild<QDialog*>("verdict")->findChildren<QLabel*>())
        texts += label->text();
    EXPECT_TRUE(texts.contains("yes")) << texts.join("; ").toStdString();
    EXPECT_EQ(button("replay_verify").text(), "Verify");
    EXPECT_TRUE(desk().is_open()) << "the recording is still shown";
}

}  // namespace
}  // namespace psicarve::ui
