// SPDX-License-Identifier: GPL-3.0-or-later
// Where the window stands, and how it goes.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTabWidget>

#include "hmi/ui/settings.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/state_pill.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

TEST(FirstPlace, IsMaximisedWhereOnlyThatLeavesTheUsualRoom) {
    const FirstPlace on_a_small_screen = first_place({1280, 720});
    EXPECT_TRUE(on_a_small_screen.is_maximised);
    EXPECT_EQ(room_in({1280, 690}), Room::usual) << "under a title bar of thirty pixels";
    EXPECT_FALSE(first_place({1366, 768}).is_maximised);
    EXPECT_EQ(room_in(first_place({1366, 768}).size), Room::usual);
    EXPECT_FALSE(first_place({1920, 1080}).is_maximised) << "there is room for other windows";
    EXPECT_EQ(first_place({1920, 1080}).size, QSize(1280, 720));
    EXPECT_FALSE(first_place({1024, 600}).is_maximised) << "nothing is won by it";
    EXPECT_EQ(first_place({1024, 600}).size, QSize(1016, 560));
}

class WindowsPlace : public WindowRig {
protected:
    QTabWidget& tabs() { return part<QTabWidget>("tabs"); }
};

TEST_F(WindowsPlace, IsKeptWhileTheWindowIsThereAndTakenByTheNext) {
    open_window();
    const QByteArray at_first = test::KeptSettings{}.geometry();
    window_->resize(1190, 701);
    ASSERT_TRUE(comes_true([&] { return test::KeptSettings{}.geometry() != at_first; }))
        << "nobody closed it";
    tabs().setCurrentIndex(4);
    ASSERT_TRUE(comes_true([&] { return test::KeptSettings{}.page() == "realtime"; }));
    MainWindow next{session::SessionOptions{segment_name_, {}, {}}, Drawing::painter, kept_settings()};
    EXPECT_EQ(next.size(), window_->size());
    next.go_to_last_page();
    EXPECT_EQ(next.findChild<QTabWidget*>("tabs")->currentIndex(), 4);
}

TEST_F(WindowsPlace, IsWrittenWhenTheProgramIsToEndAndNothingIsAsked) {
    start_core();
    open_window();
    carve_job(two_process::long_job());
    window_->set_close_question([] {
        ADD_FAILURE() << "there is nobody to answer";
        return CloseChoice::stop;
    });
    tabs().setCurrentIndex(3);
    window_->leave();
    tabs().setCurrentIndex(2);  // it is over: nothing is kept any more, and nothing is missed
    window_.reset();
    EXPECT_EQ(test::KeptSettings{}.page(), "ports");
    EXPECT_TRUE(reaches(S::carving));
}

TEST_F(WindowsPlace, IsSmallAndGreyButtonsStillSayWhy) {
    open_window();
    window_->resize(960, 515);
    const auto reason = [this]() -> const QLabel& { return part<QLabel>("motion_reason"); };
    ASSERT_TRUE(comes_true([&] { return reason().isVisible() && !reason().text().isEmpty(); }));
    EXPECT_EQ(reason().text(), "No core serves the segment");
    EXPECT_EQ(reason().toolTip(), reason().text());
    EXPECT_FALSE(part<QLabel>("reason").isVisible()) << "the Job panel's own is on another page";
    start_core();
    publish_job(two_process::lobed_job(2, 24, Profile{}));
    ASSERT_TRUE(comes_true([&] { return reason().toolTip() == "Start: axis R1 is not homed"; }))
        << reason().toolTip().toStdString();
    take_picture("small_with_its_reason");
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(comes_true([&] { return reason().toolTip() == "Hold, Resume, Stop: nothing is moving."; }))
        << reason().toolTip().toStdString();
    EXPECT_LE(reason().fontMetrics().horizontalAdvance(reason().text()), reason().width());
}

class WindowThatCloses : public WindowRig {
protected:
    bool is_told(const char* what) { return all_messages().contains(what); }
    void ask_for_hold() {
        window_->set_close_question([] { return CloseChoice::hold; });
        EXPECT_FALSE(window_->close()) << "not before the core has taken the hold";
    }
};

TEST_F(WindowThatCloses, GoesOnceTheCoreHasTakenTheHold) {
    start_core();
    open_window();
    carve_job(two_process::long_job());
    ask_for_hold();
    EXPECT_TRUE(window_->isVisible());
    ASSERT_TRUE(comes_true([&] { return !window_->isVisible(); })) << all_messages().toStdString();
    EXPECT_TRUE(reaches(S::held));
}

TEST_F(WindowThatCloses, NeverWaitsForACoreThatHangsAndStaysToSayThatNobodyHolds) {
    start_core();
    open_window();
    carve_job(two_process::long_job());
    core_->send_signal(SIGSTOP);
    ask_for_hold();  // and is back before the core's time to answer is over
    EXPECT_TRUE(is_told("Hold asked for: the window closes once the core has taken it"));
    EXPECT_FALSE(is_told("The window stays open"));
    ASSERT_TRUE(comes_true([&] { return is_told("The window stays open: the core has not taken the hold"); }))
        << all_messages().toStdString();
    EXPECT_TRUE(window_->isVisible());
    core_->send_signal(SIGCONT);
}

class WindowWithoutItsCore : public WindowRig {};

TEST_F(WindowWithoutItsCore, SaysSoInItsFirstLookAfterTheCoresDeath) {
    // The kernel takes a dead core's lock away at once: between that and the word is one look, no time.
    constexpr std::chrono::milliseconds kPromised{500};
    static_assert(2 * MainWindow::kLookPause < kPromised);
    static_assert(session::core_life(false, std::chrono::milliseconds{0}) == session::CoreLife::none);
    start_core();
    open_window();
    carve_job(two_process::long_job());
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    window_->refresh();
    EXPECT_EQ(static_cast<StatePill&>(part<QWidget>("state_pill")).word(), "NO CORE");
    EXPECT_EQ(machine_view().life, session::CoreLife::none);
}

}  // namespace
}  // namespace psicarve::ui
