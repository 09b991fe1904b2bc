// SPDX-License-Identifier: GPL-3.0-or-later
// What the window wants an operator to look at: before a start, at an alarm, of the time before it was there.
#include <gtest/gtest.h>

#include <QLabel>
#include <QSlider>

#include "hmi/session/preflight.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class Attention : public test::WindowRig {
protected:
    QString text(const char* label) { return part<QLabel>(label).text(); }
    void home_with_a_job() {
        start_core();
        open_window();
        ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
    }
};

TEST_F(Attention, IsAskedBeforeAStartThatIsPossible) {
    ASSERT_NO_FATAL_FAILURE(home_with_a_job());
    ASSERT_TRUE(comes_true([&] { return button("start").isEnabled(); }));
    EXPECT_FALSE(text("preflight_sum").contains("to look at"));
    EXPECT_EQ(text("reason"), "Hold, Resume, Stop: nothing is moving.");
    const auto icon_of = [&](const QString& check) {
        for (int row = 0; row < static_cast<int>(session::kMostChecks); ++row) {
            const auto name = QString{"preflight_name_%1"}.arg(row).toStdString();
            if (text(name.c_str()) != check) continue;
            return part<QLabel>(QString{"preflight_icon_%1"}.arg(row).toStdString().c_str()).accessibleName();
        }
        return QString{};
    };
    EXPECT_EQ(icon_of("Feed override"), "passed");
    part<QSlider>("override").setValue(80);
    ASSERT_TRUE(comes_true([&] { return sight().status->override_percent == 80; }));
    ASSERT_TRUE(comes_true([&] { return text("preflight_sum").endsWith("pass, 1 to look at"); }))
        << text("preflight_sum").toStdString();
    EXPECT_EQ(icon_of("Feed override"), "to look at");
    EXPECT_TRUE(button("start").isEnabled());
    EXPECT_EQ(text("reason"), "To be looked at before Start: Feed override: 80 %");
    take_picture("look_before_start_light");
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_FALSE(text("reason").contains("before Start"));
}

}  // namespace
}  // namespace psicarve::ui
