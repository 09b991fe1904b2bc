// SPDX-License-Identifier: GPL-3.0-or-later
// A desktop that turns dark in the evening takes the window along, unless somebody has chosen otherwise.
#include <gtest/gtest.h>

#include <QPalette>

#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

class DesktopsTheme : public test::WindowRig {
protected:
    ~DesktopsTheme() override { QApplication::setPalette(before_); }
    static void turn(Theme theme) {
        QPalette palette;
        palette.setColor(QPalette::Window, theme == Theme::dark ? Qt::black : Qt::white);
        palette.setColor(QPalette::WindowText, theme == Theme::dark ? Qt::white : Qt::black);
        QApplication::setPalette(palette);
    }
    bool looks(Theme theme) { return window_->styleSheet() == style_sheet(tokens_of(theme)); }

    const QPalette before_ = QApplication::palette();
};

TEST_F(DesktopsTheme, IsFollowedWhileTheWindowIsOpen) {
    turn(Theme::light);
    open_window();
    window_->set_theme(ThemeChoice::system);
    ASSERT_TRUE(looks(Theme::light));
    turn(Theme::dark);
    EXPECT_TRUE(comes_true([&] { return looks(Theme::dark); }));
    turn(Theme::light);
    EXPECT_TRUE(comes_true([&] { return looks(Theme::light); }));
}

TEST_F(DesktopsTheme, IsNotFollowedByAWindowWhoseThemeWasChosen) {
    turn(Theme::light);
    open_window();
    window_->set_theme(ThemeChoice::light);
    const QString before = window_->styleSheet();
    turn(Theme::dark);
    for (int look = 0; look < 10; ++look) QApplication::processEvents();
    EXPECT_EQ(window_->styleSheet(), before);
    window_->set_theme(ThemeChoice::system);
    EXPECT_TRUE(looks(Theme::dark)) << "and is, once that is chosen";
}

}  // namespace
}  // namespace psicarve::ui
