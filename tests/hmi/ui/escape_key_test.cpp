// SPDX-License-Identifier: GPL-3.0-or-later
// What Esc and Shift+Esc do: a key that everybody presses without thought ends no job.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QCompleter>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QSlider>
#include <QTabWidget>

#include "hmi/ui/side_panels.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

class EscapeKey : public WindowRig {
protected:
    /// Where the keyboard would bring it: what has dropped down, else the widget.
    static void press(QWidget& widget, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QWidget* const popup = QApplication::activePopupWidget();
        QKeyEvent event{QEvent::KeyPress, Qt::Key_Escape, with};
        QApplication::sendEvent(popup != nullptr ? popup : &widget, &event);
    }
    void carve() {
        start_core();
        open_window();
        carve_job(two_process::long_job());
    }
    /// Whatever was asked of the core is done, and it carves all the same.
    ::testing::AssertionResult goes_on_carving() {
        const auto done = machine_view().status->points_done;
        if (!comes_true([&] { return machine_view().status->points_done > done + 20; }))
            return ::testing::AssertionFailure()
                   << name_of(machine_view().state()) << all_messages().toStdString();
        return comes_to(S::carving);
    }
    qsizetype times_said(const char* what) const { return all_messages().count(what); }
};

TEST_F(EscapeKey, HoldsAndNeitherResumesNorEnds) {
    ASSERT_NO_FATAL_FAILURE(carve());
    press(*window_);
    ASSERT_TRUE(comes_to(S::held));
    EXPECT_EQ(times_said("Hold asked for by Esc: Resume or the Pause key goes on"), 1);
    press(*window_);
    press(part<QTabWidget>("tabs"));
    const auto beat = machine_view().status->heartbeat;
    ASSERT_TRUE(comes_true([&] {
        return !window_->context().machine.has_orders() && machine_view().status->heartbeat > beat + 2;
    }));
    ASSERT_EQ(machine_view().state(), S::held);
    EXPECT_EQ(times_said("Hold asked for"), 1);
    EXPECT_EQ(times_said("Stop asked for"), 0);
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(comes_to(S::carving));
    press(part<QSlider>("override"));
    EXPECT_TRUE(comes_to(S::held)) << "wherever the focus is";
}

TEST_F(EscapeKey, ClosesADialogAndDoesNothingElseThere) {
    ASSERT_NO_FATAL_FAILURE(carve());
    QMessageBox dialog{window_.get()};
    dialog.setObjectName("test_question");
    dialog.setModal(false);
    dialog.addButton(QMessageBox::Cancel);
    dialog.show();
    QApplication::processEvents();
    press(*dialog.buttons().front());
    press(dialog);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_TRUE(goes_on_carving());
    EXPECT_EQ(times_said("Hold asked for") + times_said("Stop asked for"), 0);
    press(*window_);
    EXPECT_TRUE(comes_to(S::held)) << "the dialog is gone";
}

TEST_F(EscapeKey, ClosesAMenuAListAndACompletion) {
    ASSERT_NO_FATAL_FAILURE(carve());
    QMenu menu{window_.get()};
    menu.addAction("one");
    menu.popup(window_->mapToGlobal(QPoint{50, 50}));
    ASSERT_TRUE(comes_true([&] { return menu.isVisible(); }));
    press(*window_);
    EXPECT_FALSE(menu.isVisible());
    auto& list = part<QComboBox>("joining");
    list.showPopup();
    ASSERT_TRUE(comes_true([&] { return list.view()->isVisible(); }));
    press(*list.view());
    EXPECT_TRUE(comes_true([&] { return !list.view()->isVisible(); }));
    QLineEdit field{window_.get()};
    QCompleter completer{QStringList{"psi", "psicarve"}};
    field.setCompleter(&completer);
    field.show();
    completer.setCompletionPrefix("psi");
    completer.complete();
    ASSERT_TRUE(comes_true([&] { return completer.popup()->isVisible(); }));
    press(field);
    EXPECT_FALSE(completer.popup()->isVisible());
    EXPECT_TRUE(goes_on_carving());
    EXPECT_EQ(times_said("Hold asked for") + times_said("Stop asked for"), 0);
}

TEST_F(EscapeKey, WithShiftStopsFromADialogWhichStaysOpen) {
    ASSERT_NO_FATAL_FAILURE(carve());
    QMessageBox dialog{window_.get()};
    dialog.setObjectName("test_question");
    dialog.setModal(false);
    dialog.addButton(QMessageBox::Cancel);
    dialog.show();
    QApplication::processEvents();
    press(dialog, Qt::ShiftModifier);
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(dialog.isVisible());
    press(dialog, Qt::ShiftModifier);  // nothing moves
    press(dialog);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_EQ(times_said("Stop asked for"), 1);
}

TEST_F(EscapeKey, WithShiftStopsFromAMenuAndOnHold) {
    ASSERT_NO_FATAL_FAILURE(carve());
    press(*window_);
    ASSERT_TRUE(comes_to(S::held));
    QMenu menu{window_.get()};
    menu.addAction("one");
    menu.popup(window_->mapToGlobal(QPoint{50, 50}));
    ASSERT_TRUE(comes_true([&] { return menu.isVisible(); }));
    press(*window_, Qt::ShiftModifier);
    EXPECT_TRUE(comes_to(S::ready));
    menu.close();
}

TEST_F(EscapeKey, EndsWhatCannotBeHeld) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::homing));
    press(*window_);
    ASSERT_TRUE(comes_true(
        [&] { return machine_view().state() != S::homing && is_at_rest(machine_view().state()); }));
    EXPECT_EQ(machine_view().state(), S::off) << all_messages().toStdString();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    press(*window_);
    EXPECT_EQ(times_said("Stop asked for"), 1) << "nothing moved the second time";
    // Where the computer is busy a jog on the virtual clock may be over, for want of news, before anybody
    // sees it.
    QAbstractButton& turn = button("jog_psi_plus");
    const auto moves = [&] { return machine_view().state() == S::moving; };
    for (int attempt = 0; attempt < 20; ++attempt) {
        turn.setDown(true);
        Q_EMIT turn.pressed();
        if (comes_true(moves, two_process::milliseconds{5'000})) break;
        Q_EMIT turn.released();
    }
    ASSERT_TRUE(moves());
    press(*window_);
    EXPECT_TRUE(comes_to(S::ready));
    EXPECT_FALSE(turn.isDown());
    EXPECT_EQ(times_said("Stop asked for"), 2);
}

TEST_F(EscapeKey, HoldsFromAPanelInAFrameOfItsOwn) {
    ASSERT_NO_FATAL_FAILURE(carve());
    for (QAction* action : part<QMenu>("panels").actions()) action->setChecked(true);
    QApplication::processEvents();
    ASSERT_NE(button("hold").window(), window_.get());
    press(button("hold"));
    EXPECT_TRUE(comes_to(S::held));
}

}  // namespace
}  // namespace psicarve::ui
