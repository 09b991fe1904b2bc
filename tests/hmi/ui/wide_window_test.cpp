// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>

#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

/// What a large screen has room for.
class WideWindow : public WindowRig {
protected:
    void open_wide() {
        start_core();
        open_window();
        window_->resize(1920, 1080);
    }
    QString text(const char* name) {
        auto* const label = window_->findChild<QLabel*>(name);
        return label != nullptr ? label->text() : QString{"no label"};
    }
};

TEST_F(WideWindow, ShowsWhatAJobCameFromAndWhatIsLeftOfIt) {
    open_wide();
    ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
    EXPECT_TRUE(window_->findChild<QLabel*>("job_source")->isVisible());
    EXPECT_EQ(text("job_source"), "–") << "nobody sliced it";
    EXPECT_EQ(text("job_joining"), "continuous");
    ASSERT_TRUE(comes_true([&] { return text("work_text").startsWith("Layer "); }));
    EXPECT_TRUE(text("work_text").endsWith("override 100 %")) << text("work_text").toStdString();
    EXPECT_TRUE(text("pulses_r1").endsWith(" pulses"));
    window_->findChild<QTabWidget*>()->setCurrentIndex(2);
    const auto left_pulses = [&] {
        const QString digits = text("axis_left_psi").remove(QChar{0x2009});
        return digits.toLongLong();
    };
    ASSERT_TRUE(comes_true([&] { return left_pulses() > 0; }));
    const auto before_pulses = left_pulses();
    EXPECT_TRUE(comes_true([&] { return left_pulses() < before_pulses; }));
    take_picture("wide_carving_light");
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(WideWindow, HasItsMenusInABarAndANarrowOneBehindAButton) {
    open_window();
    const auto* const bar = window_->findChild<QMenuBar*>("menu_bar");
    ASSERT_NE(bar, nullptr);
    EXPECT_FALSE(bar->isVisible());
    EXPECT_FALSE(window_->findChild<QLabel*>("job_source")->isVisible());
    window_->resize(1920, 1080);
    QApplication::processEvents();
    EXPECT_TRUE(bar->isVisible());
    ASSERT_EQ(bar->actions().size(), 5);
    EXPECT_EQ(bar->actions().front()->text(), "File");
}

TEST_F(WideWindow, KeepsTheNamesOfItsPagesInSightWhereASmallOneScrolls) {
    open_window();
    window_->resize(640, 360);  // 1280 x 720 at 200 %
    QApplication::processEvents();
    auto& tabs = part<QTabWidget>("tabs");
    for (int i = 0; i < tabs.count(); ++i) {
        tabs.setCurrentIndex(i);
        QApplication::processEvents();
        auto* const page = static_cast<QScrollArea*>(tabs.currentWidget());
        page->horizontalScrollBar()->setValue(page->horizontalScrollBar()->maximum());
        page->verticalScrollBar()->setValue(page->verticalScrollBar()->maximum());
        const QRect name =
            tabs.tabBar()->tabRect(i).translated(tabs.tabBar()->mapTo(window_.get(), QPoint{}));
        EXPECT_TRUE(window_->rect().contains(name)) << tabs.tabText(i).toStdString() << " is out of sight";
    }
}

}  // namespace
}  // namespace psicarve::ui
