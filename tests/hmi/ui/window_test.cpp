// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/strip.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;

class Window : public WindowRig {};

TEST_F(Window, LocksEveryMotionWithoutACoreAndSaysWhy) {
    open_window();
    ASSERT_TRUE(comes_true([&] { return !button("start").toolTip().isEmpty(); }));
    for (const char* name : {"home", "home_one", "zero_one", "start", "hold", "resume", "stop", "one_layer",
                             "from_layer", "full", "jog_r1_out", "jog_psi_plus", "jog_y_down"}) {
        EXPECT_FALSE(button(name).isEnabled()) << name;
        EXPECT_EQ(button(name).toolTip(), "No core serves the segment") << name;
        EXPECT_EQ(button(name).accessibleDescription(), button(name).toolTip()) << name;
    }
    EXPECT_EQ(window_->findChild<QLabel*>("reason")->text(), "No core serves the segment");
    take_picture("no_core_light");
}

TEST_F(Window, KeepsTheEmergencyStopInReachOnF1AlsoInADialog) {
    open_window();
    QMessageBox dialog{window_.get()};
    dialog.setObjectName("test_question");
    dialog.setModal(true);
    dialog.open();
    QApplication::processEvents();
    QKeyEvent press{QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier};
    QApplication::sendEvent(&dialog, &press);
    EXPECT_TRUE(all_messages().contains("Nobody heard the emergency stop")) << all_messages().toStdString();
    const auto count = window_->context().log.count();
    QKeyEvent repeated{QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier, QString{}, true};
    QApplication::sendEvent(&dialog, &repeated);
    EXPECT_EQ(window_->context().log.count(), count);
}

TEST_F(Window, StopsOnPressOfTheBigButtonNotOnItsRelease) {
    open_window();
    auto* const strip = window_->findChild<QWidget*>("strip");
    auto& emergency = static_cast<Strip*>(strip)->emergency_button();
    EXPECT_TRUE(emergency.isEnabled());
    EXPECT_GE(emergency.width(), 200);
    QMouseEvent press{QEvent::MouseButtonPress, QPointF{20, 20}, QPointF{20, 20},
                      Qt::LeftButton,           Qt::LeftButton,  Qt::NoModifier};
    QApplication::sendEvent(&emergency, &press);
    EXPECT_TRUE(all_messages().contains("Nobody heard the emergency stop")) << all_messages().toStdString();
}

TEST_F(Window, FitsItsSmallestScreenInBothThemes) {
    open_window();
    for (const ThemeChoice theme : {ThemeChoice::light, ThemeChoice::dark}) {
        window_->set_theme(theme);
        QApplication::processEvents();
        EXPECT_LE(window_->minimumSizeHint().width(), 1280);
        EXPECT_LE(window_->minimumSizeHint().height(), 720);
    }
    take_picture("no_core_dark");
}

// The focus may stand on any of them.
TEST_F(Window, StartsNoMotionBySpaceOrEnter) {
    start_core();
    open_window();
    ASSERT_TRUE(comes_true([&] { return button("home").isEnabled(); }));
    for (const int key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Select}) {
        for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent event{type, key, Qt::NoModifier};
            QApplication::sendEvent(&button("home"), &event);
        }
    }
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(comes_true([&] { return window_->context().machine.view().is_heard(); }));
        ASSERT_EQ(window_->context().machine.view().state(), MachineState::off);
    }
}

TEST_F(Window, LetsTheEmergencyStopBePressedBesideADialog) {
    open_window();
    QMessageBox box{QMessageBox::Question, "A question", "?", QMessageBox::Ok, window_.get()};
    box.setObjectName("test_question");
    QTimer::singleShot(0, [&] {
        EXPECT_EQ(open_dialog(), &box);
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
        EXPECT_FALSE(window_->close()) << "the dialog comes first";
        QMessageBox second{window_.get()};
        EXPECT_EQ(run_dialog(second), QDialog::Rejected);
        box.accept();
    });
    EXPECT_EQ(run_dialog(box), QDialog::Accepted);
    EXPECT_EQ(open_dialog(), nullptr);
}

TEST_F(Window, ChangesNoFeedByTheWheel) {
    open_window();
    for (QSlider* slider :
         window_->findChild<QWidget*>("override")->parentWidget()->findChildren<QSlider*>()) {
        const int before = slider->value();
        QWheelEvent turn{QPointF{5, 5},
                         slider->mapToGlobal(QPointF{5, 5}),
                         {},
                         {0, 120},
                         Qt::NoButton,
                         Qt::NoModifier,
                         Qt::NoScrollPhase,
                         false};
        QApplication::sendEvent(slider, &turn);
        EXPECT_EQ(slider->value(), before);
    }
}

// 1280 x 720 at 200 %: what must be seen is seen, everything else is a page or can be scrolled to.
TEST_F(Window, KeepsItsSafetyOnAVerySmallScreen) {
    start_core();
    open_window();
    ASSERT_TRUE(comes_true([&] { return window_->context().machine.view().is_heard(); }));
    window_->resize(640, 360);
    QApplication::processEvents();
    EXPECT_EQ(window_->size(), QSize(640, 360));
    const QRect screen{0, 0, 640, 360};
    const auto place_of = [&](const QWidget& widget) {
        return QRect{widget.mapTo(window_.get(), QPoint{0, 0}), widget.size()};
    };
    auto& strip = *static_cast<Strip*>(window_->findChild<QWidget*>("strip"));
    EXPECT_TRUE(screen.contains(place_of(strip.emergency_button())));
    for (const QAbstractButton* motion :
         window_->findChild<QWidget*>("motion")->findChildren<QAbstractButton*>())
        EXPECT_TRUE(motion->isVisible() && screen.contains(place_of(*motion)))
            << motion->text().toStdString();
    take_picture("smallest_light");
    auto* const names = window_->findChild<QTabBar*>("side_names");
    auto* const pages = window_->findChild<QStackedWidget*>("side_pages");
    for (int i = 0; i < names->count(); ++i) {
        names->setCurrentIndex(i);
        EXPECT_EQ(pages->currentIndex(), i);
    }
    window_->resize(1920, 1080);
    QApplication::processEvents();
    EXPECT_FALSE(pages->isVisible());
    EXPECT_TRUE(button("start").isVisible());
    take_picture("wide_light");
    window_->resize(1280, 720);
    QApplication::processEvents();
    take_picture("usual_again_light");
    EXPECT_TRUE(button("start").isVisible());
}

TEST_F(Window, RemembersItsThemeAndItsFilesAndDoesNotMoveAnything) {
    open_window();
    window_->set_theme(ThemeChoice::dark);
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    window_->close();
    window_.reset();
    const test::KeptSettings settings;
    EXPECT_EQ(settings.theme(), ThemeChoice::dark);
    ASSERT_EQ(settings.recent_files().size(), 1);
    EXPECT_TRUE(settings.recent_files().front().endsWith("small.stl"));
    EXPECT_FALSE(settings.geometry().isEmpty());
    EXPECT_TRUE(settings.last_folder().endsWith("examples"));
}

TEST_F(Window, ShowsTheBlankAndWhatTheHeadsCannotReach) {
    open_window();
    window_->open(QString::fromStdString(example("figurine.stl")));
    auto& view = *static_cast<MeshView*>(window_->findChild<QWidget*>("model_view"));
    const auto has_colours = [&] {
        return !view.picture().bodies.empty() && !view.picture().bodies.front().scene->vertex_rgb.empty();
    };
    ASSERT_TRUE(comes_true(has_colours));
    constexpr std::uint32_t kUndercut = 0xFFC21A;
    const auto& colours = view.picture().bodies.front().scene->vertex_rgb;
    const auto hidden = std::count(colours.begin(), colours.end(), kUndercut);
    EXPECT_GT(hidden, 0);
    EXPECT_LT(hidden, static_cast<std::ptrdiff_t>(colours.size() / 4));
    EXPECT_GT(view.picture().lines.size(), 50U);  // the axis, and the blank's dashes
    auto* const warnings = window_->findChild<QListWidget*>("warnings");
    EXPECT_FALSE(warnings->isVisible());
    take_picture("undercut_light");
    auto* const show = window_->findChild<QPushButton*>("view_undercut");
    ASSERT_TRUE(show->isEnabled());
    const auto before = view.picture().view;
    show->click();
    EXPECT_NE(view.picture().view.azimuth_rad, before.azimuth_rad);
    take_picture("undercut_shown_light");
    const auto* const legend = view.findChild<QLabel*>("legend");
    EXPECT_TRUE(legend->text().contains("undercut about ")) << legend->text().toStdString();
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    ASSERT_TRUE(comes_true([&] { return warnings->count() > 0 && warnings->isVisible(); }));
    EXPECT_TRUE(warnings->item(0)->text().contains("cannot be reached"));
    // One figure, wherever it stands.
    const QString percent = warnings->item(0)->text().section(" %", 0, 0);
    EXPECT_TRUE(legend->text().contains("undercut " + percent + " %"))
        << legend->text().toStdString() << " " << warnings->item(0)->text().toStdString();
    EXPECT_TRUE(part<QLabel>("job_undercut").text().startsWith(percent + " %"));
    window_->set_theme(ThemeChoice::dark);
    take_picture("warnings_dark");
}

TEST_F(Window, DrawsCoarselyWhileTheModelIsTurnedAndFinelyAfterwards) {
    open_window();
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    auto& view = *static_cast<MeshView*>(window_->findChild<QWidget*>("model_view"));
    ASSERT_TRUE(comes_true([&] { return !view.picture().bodies.empty(); }));
    const double before_rad = view.picture().view.azimuth_rad;
    const auto send = [&](QEvent::Type type, double x) {
        QMouseEvent event{type,           QPointF{x, 100}, QPointF{x, 100},
                          Qt::LeftButton, Qt::LeftButton,  Qt::NoModifier};
        QApplication::sendEvent(&view, &event);
    };
    send(QEvent::MouseButtonPress, 100);
    send(QEvent::MouseMove, 150);
    EXPECT_TRUE(view.picture().is_coarse);
    EXPECT_NE(view.picture().view.azimuth_rad, before_rad);
    send(QEvent::MouseButtonRelease, 150);
    EXPECT_FALSE(view.picture().is_coarse);
}

TEST_F(Window, NeverPutsTheFirstFocusOnWhatMoves) {
    open_window();
    QApplication::processEvents();
    EXPECT_EQ(qobject_cast<QPushButton*>(window_->focusWidget()), nullptr);
    for (auto* const found : window_->findChildren<QPushButton*>()) {
        EXPECT_FALSE(found->autoDefault() && found->isDefault()) << found->text().toStdString();
        EXPECT_NE(found->focusPolicy(), Qt::StrongFocus) << found->text().toStdString();
    }
}

}  // namespace
}  // namespace psicarve::ui
