// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the list F12 shows, pressed as a keyboard does, each with its effect.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/strip.hpp"
#include "tests/hmi/replay/recorded_run.hpp"
#include "tests/hmi/ui/hands_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;
using S = MachineState;

class Keys : public replay::test::RecordedOn<test::HandsRig> {
protected:
    int page() { return part<QTabWidget>("tabs").currentIndex(); }
    /// The pane that has the focus: 0 strip, 1 left, 2 pages, 3 right; -1 none.
    int pane() {
        QWidget* const focus = QApplication::focusWidget();
        const QWidget* const panes[] = {&part<QWidget>("strip"), &part<QWidget>("axis_r1"),
                                        &part<QWidget>("tabs"), &button("start")};
        for (int i = 0; i < 4; ++i) {
            const QWidget* const pane = i % 2 == 0 ? panes[i] : panes[i]->parentWidget()->parentWidget();
            if (focus != nullptr && pane->isAncestorOf(focus)) return i;
        }
        return -1;
    }
    void open_replay() {
        window_->open(QString::fromStdString(trace()));
        auto& desk = window_->context().replay;
        ASSERT_TRUE(comes_true([&] { return desk.is_open() && desk.is_settled(); }));
        desk.add_job(job());
        ASSERT_TRUE(comes_true([&] { return desk.carving() != nullptr && desk.is_settled(); }))
            << all_messages().toStdString();
    }
};

TEST_F(Keys, HomeStartHoldResumeAndChangeTheFeed) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    ASSERT_TRUE(comes_true([&] { return button("home").isEnabled(); }));
    press_key(Qt::Key_Home, Qt::ControlModifier);
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(comes_true([&] { return button("start").isEnabled(); }));
    press_key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(comes_to(S::carving));
    const auto feed_is = [&](std::uint32_t percent) {
        return comes_true([&] { return machine_view().status->override_percent == percent; });
    };
    press_key(Qt::Key_Minus, Qt::ControlModifier);
    EXPECT_TRUE(feed_is(95));
    press_key(Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_TRUE(feed_is(100));
    press_key(Qt::Key_Equal, Qt::ControlModifier);
    EXPECT_TRUE(feed_is(105)) << "the + of keyboards that have it above =";
    press_key(Qt::Key_0, Qt::ControlModifier);
    EXPECT_TRUE(feed_is(100));
    press_key(Qt::Key_Pause);
    ASSERT_TRUE(comes_to(S::held));
    press_key(Qt::Key_Pause);
    ASSERT_TRUE(comes_to(S::carving));
}

TEST_F(Keys, PauseHoldsFromADialogAndItsListIsShutByItsButton) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
    EXPECT_TRUE(answered([&] { press_key(Qt::Key_F12); }, {[&](QDialog& list) {
                             EXPECT_EQ(list.objectName(), "keys");
                             list.activateWindow();
                             EXPECT_TRUE(comes_true([&] { return list.isActiveWindow(); }));
                             QTest::keyClick(&list, Qt::Key_Pause);
                             EXPECT_TRUE(comes_to(S::held));
                             QTest::mouseClick(list.findChild<QPushButton*>("keys_ok"), Qt::LeftButton);
                             EXPECT_FALSE(list.isVisible());
                         }}));
    EXPECT_EQ(open_dialog(), nullptr);
}

TEST_F(Keys, GoToPagesLayerNumberAndPanes) {
    open_in_front();
    for (int i = 7; i >= 0; --i) {
        press_key(static_cast<Qt::Key>(Qt::Key_1 + i), Qt::ControlModifier);
        EXPECT_EQ(page(), i);
    }
    ASSERT_NO_FATAL_FAILURE({
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(two_process::lobed_job(3, 40));
        ASSERT_TRUE(save_snapshot(snapshot, file("short.job")));
        window_->open(QString::fromStdString(file("short.job")));
        ASSERT_TRUE(comes_to(OpenJobState::job));
    });
    press_key(Qt::Key_L, Qt::ControlModifier);
    EXPECT_EQ(page(), 1);
    auto& number = part<QSpinBox>("layer_number");
    ASSERT_TRUE(comes_true([&] { return number.maximum() == 3; }));
    EXPECT_TRUE(number.hasFocus());
    press_key(Qt::Key_3);  // over what is selected
    press_key(Qt::Key_Return);
    EXPECT_EQ(number.value(), 3);
    press_key(Qt::Key_1, Qt::ControlModifier);
    window_->setFocus();
    part<QTabWidget>("tabs").tabBar()->setFocus();
    ASSERT_EQ(pane(), 2);
    for (const int next : {3, 0, 1, 2}) {
        press_key(Qt::Key_F6);
        EXPECT_EQ(pane(), next);
    }
}

TEST_F(Keys, F10OpensTheMenuBehindItsButtonOrInItsBar) {
    open_in_front();
    auto& menu_button = static_cast<QToolButton&>(button("menu_button"));
    const auto shuts = [&](const std::function<void()>& open) {
        bool was_open = false;
        QTimer hand;
        QObject::connect(&hand, &QTimer::timeout, [&] {
            QWidget* const menu = QApplication::activePopupWidget();
            if (menu == nullptr) return;
            hand.stop();
            was_open = menu == menu_button.menu();
            QTest::keyClick(menu, Qt::Key_Escape);
        });
        hand.start(1);
        open();
        return comes_true([&] { return !hand.isActive(); }) && was_open;
    };
    EXPECT_TRUE(shuts([&] { press_key(Qt::Key_F10); }));
    EXPECT_TRUE(shuts([&] { QTest::mousePress(&menu_button, Qt::LeftButton); }));
    window_->resize(1920, 1040);
    ASSERT_TRUE(comes_true([&] { return window_->menuBar()->isVisible(); }));
    bring_to_front();
    press_key(Qt::Key_F10);
    EXPECT_EQ(window_->menuBar()->activeAction(), window_->menuBar()->actions().front())
        << (QApplication::activePopupWidget() != nullptr) << window_->isActiveWindow();
}

TEST_F(Keys, F5SlicesAndF9ArmsAndOpenAndCloseAsElsewhere) {
    start_core();
    open_in_front();
    EXPECT_TRUE(named_file([&] { press_key(Qt::Key_O, Qt::ControlModifier); }, example("small.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    part<QSpinBox>("layers").setValue(20);
    ASSERT_TRUE(comes_true([&] { return button("slice").isEnabled(); }));
    press_key(Qt::Key_F5);
    ASSERT_TRUE(comes_to(OpenJobState::job));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    for (const char* text : {"Disarm keyboard jog", "Arm keyboard jog", "Disarm keyboard jog"}) {
        ASSERT_TRUE(comes_true([&] { return button("arm_keys").isEnabled(); }));
        press_key(Qt::Key_F9);
        EXPECT_TRUE(comes_true([&] { return button("arm_keys").text() == text; })) << text;
    }
    press_key(Qt::Key_Q, Qt::ControlModifier);
    EXPECT_FALSE(window_->isVisible());
}

TEST_F(Keys, OfARecordingPlayItStepItAndGoFromEntryToEntry) {
    record();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(open_replay());
    replay::ReplayClock& clock = window_->context().replay.clock();
    const auto& entries = window_->context().replay.facts().entries;
    ASSERT_GE(entries.size(), 2U);
    clock.seek(0);
    press_key(Qt::Key_N);
    EXPECT_EQ(clock.now_ns(), entries[0].time_ns);
    press_key(Qt::Key_N);
    EXPECT_EQ(clock.now_ns(), entries[1].time_ns);
    press_key(Qt::Key_N, Qt::ShiftModifier);
    EXPECT_EQ(clock.now_ns(), entries[0].time_ns);
    EXPECT_EQ(clock.speed(), 1.0);
    press_key(Qt::Key_L);
    EXPECT_EQ(clock.speed(), 10.0);
    press_key(Qt::Key_J);
    press_key(Qt::Key_J);
    EXPECT_EQ(clock.speed(), 0.1);
    press_key(Qt::Key_K);
    EXPECT_TRUE(clock.is_playing());
    press_key(Qt::Key_K);
    EXPECT_FALSE(clock.is_playing());
    const auto layer = [&] { return window_->context().replay.shown().place->layer; };
    const auto settles_at = [&](std::uint32_t wanted) {
        return comes_true([&] {
            return window_->context().replay.is_settled() && window_->context().replay.shown().place &&
                   layer() == wanted;
        });
    };
    clock.seek(clock.end_ns() / 20 * 17);
    ASSERT_TRUE(comes_true(
        [&] { return window_->context().replay.is_settled() && window_->context().replay.shown().place; }));
    const std::uint32_t from = layer();
    ASSERT_GT(from, 1U);
    press_key(Qt::Key_Comma);
    EXPECT_TRUE(settles_at(from - 1));
    press_key(Qt::Key_Comma);
    EXPECT_TRUE(settles_at(from - 2));
    press_key(Qt::Key_Period);
    EXPECT_TRUE(settles_at(from - 1));
}

}  // namespace
}  // namespace psicarve::ui
