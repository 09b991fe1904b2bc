// SPDX-License-Identifier: GPL-3.0-or-later
// What the core refused says so beside the button that asked for it, with what would help, while that holds.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QSpinBox>

#include "hmi/session/move_request.hpp"
#include "tests/hmi/ui/pages_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class OrderRefused : public test::PagesRig {
protected:
    void open_on_core() {
        start_core();
        open_window();
        ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    }
    void home() {
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
    }
    void stop_in_an_emergency() {
        window_->emergency_stop();
        ASSERT_TRUE(comes_to(S::alarm));
    }
    session::MachineSession& machine() { return window_->context().machine; }
    bool is_there(const char* card) { return part<QWidget>(card).isVisible(); }
    QString why(const char* card) {
        return part<QLabel>((std::string{card} + "_why").c_str()).text().remove(QChar{0x200B});
    }
    bool comes(const char* card) {
        return comes_true([&] { return is_there(card); });
    }
    bool goes(const char* card) {
        return comes_true([&] { return !is_there(card); });
    }
    /// All of it, and on nothing but them.
    bool is_before_pages(const QWidget& card) {
        const QWidget& tabs = part<QWidget>("tabs");
        return card.parentWidget() == window_.get() &&
               QRect{tabs.mapTo(window_.get(), QPoint{}), tabs.size()}.contains(card.geometry());
    }
    void take_pictures(const char* name) {
        window_->refresh();
        take_picture(QString{name} + "_light");
        window_->set_theme(ThemeChoice::dark);
        take_picture(QString{name} + "_dark");
        window_->set_theme(ThemeChoice::light);
    }
};

TEST_F(OrderRefused, HomingInAnAlarmOffersToResetIt) {
    open_on_core();
    stop_in_an_emergency();
    machine().order(CommandKind::home, session::phrase("Home"));
    ASSERT_TRUE(comes("refused_position")) << all_messages().toStdString();
    EXPECT_TRUE(why("refused_position").startsWith("Home: ")) << why("refused_position").toStdString();
    EXPECT_EQ(button("refused_position_remedy").text(), "Reset alarm");
    take_pictures("home_refused");
    ASSERT_TRUE(click("refused_position_remedy"));
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_TRUE(goes("refused_position"));
}

TEST_F(OrderRefused, AJogBeforeHomingOffersToHomeAll) {
    open_on_core();
    machine().jog().step(Axis::y, 1.0, 5.0);
    ASSERT_TRUE(comes("refused_jog")) << all_messages().toStdString();
    EXPECT_FALSE(part<QWidget>("refused_jog")
                     .geometry()
                     .intersects({part<QWidget>("jog_y_up").mapTo(window_.get(), QPoint{}),
                                  part<QWidget>("jog_y_up").size()}));
    EXPECT_EQ(button("refused_jog_remedy").text(), "Home all");
    take_pictures("jog_refused");
    ASSERT_TRUE(click("refused_jog_remedy"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(goes("refused_jog"));
}

TEST_F(OrderRefused, AJogOutOfTravelSaysSoUntilAnotherStepIsChosenOrAnotherJogAskedFor) {
    open_on_core();
    home();
    ASSERT_FALSE(HasFatalFailure());
    const auto jog_too_far = [&] { machine().jog().step(Axis::y, -500.0, 5.0); };
    jog_too_far();
    ASSERT_TRUE(comes("refused_jog")) << all_messages().toStdString();
    EXPECT_TRUE(why("refused_jog").contains("travel")) << why("refused_jog").toStdString();
    EXPECT_FALSE(button("refused_jog_remedy").isVisible());
    button("jog_step_10_mm").click();
    EXPECT_TRUE(goes("refused_jog"));
    jog_too_far();
    ASSERT_TRUE(comes("refused_jog"));
    machine().jog().step(Axis::y, 1.0, 5.0);
    EXPECT_TRUE(goes("refused_jog"));
    EXPECT_TRUE(comes_to(S::ready));
}

TEST_F(OrderRefused, AStartBeforeHomingOffersToHomeAllWhereverStartStands) {
    open_on_core();
    publish_job(two_process::long_job());
    ASSERT_FALSE(HasFatalFailure());
    machine().start(0);
    ASSERT_TRUE(comes("refused_job")) << all_messages().toStdString();
    EXPECT_TRUE(why("refused_job").startsWith("Start: ")) << why("refused_job").toStdString();
    EXPECT_FALSE(part<QWidget>("refused_motion").isVisible()) << "once is enough";
    take_pictures("start_refused");
    window_->resize(1000, 640);
    ASSERT_TRUE(comes("refused_motion"));
    EXPECT_FALSE(part<QWidget>("refused_job").isVisible());
    take_pictures("start_refused_small");
    window_->resize(1280, 720);
    ASSERT_TRUE(comes("refused_job"));
    EXPECT_TRUE(goes("refused_motion"));
    ASSERT_TRUE(click("refused_job_remedy"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(goes("refused_job"));
}

TEST_F(OrderRefused, AStartInASmallWindowIsHelpedBesideIt) {
    open_on_core();
    publish_job(two_process::long_job());
    ASSERT_FALSE(HasFatalFailure());
    window_->resize(1000, 640);
    machine().start(0);
    ASSERT_TRUE(comes("refused_motion")) << all_messages().toStdString();
    ASSERT_TRUE(click("refused_motion_remedy"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(goes("refused_motion"));
}

TEST_F(OrderRefused, AStartFromALayerThatIsNotThereGoesWithTheNumber) {
    open_on_core();
    publish_job(two_process::long_job());
    ASSERT_FALSE(HasFatalFailure());
    home();
    machine().start(1'000'000);
    ASSERT_TRUE(comes("refused_job")) << all_messages().toStdString();
    EXPECT_FALSE(button("refused_job_remedy").isVisible());
    part<QSpinBox>("layer").setValue(7);
    EXPECT_TRUE(goes("refused_job"));
}

TEST_F(OrderRefused, AMoveInAnAlarmSaysSoInItsDialog) {
    open_on_core();
    home();
    ASSERT_TRUE(click("go_to"));
    stop_in_an_emergency();
    session::MoveRequest request;
    request.target[index_of(Axis::y)] = 10.0;
    machine().order(session::move_command(request), session::phrase("Go to"));
    ASSERT_TRUE(comes("refused_move")) << all_messages().toStdString();
    ASSERT_TRUE(click("refused_move_remedy"));
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_TRUE(goes("refused_move"));
    part<QDialog>("move_dialog").close();
}

TEST_F(OrderRefused, AnOutputsTestInAnAlarmSaysSoBelowTheTest) {
    open_on_core();
    show_page("ports_page");
    stop_in_an_emergency();
    machine().jog().test(Signal::spindle, 0, 0.0);
    ASSERT_TRUE(comes("refused_outputs")) << all_messages().toStdString();
    take_pictures("output_refused");
    ASSERT_TRUE(click("refused_outputs_remedy"));
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_TRUE(goes("refused_outputs"));
}

TEST_F(OrderRefused, IsTakenAwayOnceItWasReadWhereverItStands) {
    open_on_core();
    show_page("ports_page");
    stop_in_an_emergency();
    const auto taken_away = [&](const std::string& card, CommandKind kind) {
        machine().order(kind, session::phrase("Asked"));
        if (!comes(card.c_str())) return false;
        const auto clicked = click((card + "_read").c_str());
        EXPECT_TRUE(clicked) << card;
        EXPECT_FALSE(machine().refused_order()) << card;
        return goes(card.c_str());
    };
    EXPECT_TRUE(taken_away("refused_position", CommandKind::home));
    EXPECT_TRUE(taken_away("refused_jog", CommandKind::spindle));
    EXPECT_TRUE(taken_away("refused_job", CommandKind::resume));
    EXPECT_TRUE(taken_away("refused_outputs", CommandKind::drives_off));
    window_->resize(1000, 640);
    EXPECT_TRUE(taken_away("refused_motion", CommandKind::resume));
    window_->resize(1280, 720);
    part<QDialog>("move_dialog").show();
    EXPECT_TRUE(taken_away("refused_move", CommandKind::move));
    part<QDialog>("move_dialog").close();
    EXPECT_EQ(machine_view().state(), S::alarm) << "it moves and resets nothing";
}

TEST_F(OrderRefused, OfAPanelThatIsAnotherTabStandsBeforeThePages) {
    open_on_core();
    for (const QSize& size : {QSize{1000, 640}, QSize{960, 515}}) {
        window_->resize(size);
        QApplication::processEvents();
        machine().jog().step(Axis::y, 1.0, 5.0);
        ASSERT_TRUE(comes("refused_jog")) << all_messages().toStdString();
        EXPECT_FALSE(button("jog_y_up").isVisible());
        EXPECT_TRUE(is_before_pages(part<QWidget>("refused_jog")));
        ASSERT_TRUE(click("refused_jog_read"));
    }
}

TEST_F(OrderRefused, AnOutputsTestMovesNoButtonOfIt) {
    open_on_core();
    for (const QSize& size : {QSize{1280, 720}, QSize{960, 515}}) {
        window_->resize(size);
        show_page("ports_page");
        const auto place = [&] { return part<QWidget>("arm_wiring").mapTo(window_.get(), QPoint{}); };
        const QPoint before = place();
        machine().order(CommandKind::resume, session::phrase("Resume"));
        machine().jog().test(Signal::spindle, 50'000'000, 1.0);
        ASSERT_TRUE(comes("refused_outputs")) << all_messages().toStdString();
        QApplication::processEvents();
        EXPECT_EQ(place(), before);
        EXPECT_TRUE(is_before_pages(part<QWidget>("refused_outputs")));
        take_pictures(size.width() == 960 ? "output_refused_960" : "output_refused_1280");
        ASSERT_TRUE(click("refused_outputs_read"));
    }
}

TEST_F(OrderRefused, AMoveMovesNoButtonOfItsDialog) {
    open_on_core();
    home();
    ASSERT_FALSE(HasFatalFailure());
    ASSERT_TRUE(click("go_to"));
    stop_in_an_emergency();
    QApplication::processEvents();
    const QPoint before = part<QWidget>("move_go").pos();
    machine().order(CommandKind::move, session::phrase("Go to"));
    ASSERT_TRUE(comes("refused_move")) << all_messages().toStdString();
    QApplication::processEvents();
    EXPECT_EQ(part<QWidget>("move_go").pos(), before);
    part<QDialog>("move_dialog").close();
}

TEST_F(OrderRefused, InAFrameOfItsOwnStandsBeforeThePagesAndOutlivesIt) {
    open_on_core();
    window_->findChild<QAction*>("float_jog")->trigger();
    machine().jog().step(Axis::y, 1.0, 5.0);
    ASSERT_TRUE(comes("refused_jog")) << all_messages().toStdString();
    QWidget& card = part<QWidget>("refused_jog");
    EXPECT_EQ(card.window(), window_.get()) << "its frame has no room that no button has";
    EXPECT_TRUE(is_before_pages(card));
    window_->findChild<QAction*>("float_jog")->trigger();
    ASSERT_TRUE(comes_true([&] { return card.isVisible() && card.window() == window_.get(); }));
    ASSERT_TRUE(click("refused_jog_remedy"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(goes("refused_jog"));
}

TEST_F(OrderRefused, ResettingAnAlarmSaysWhyBesideItsButton) {
    open_on_core();
    stop_in_an_emergency();
    Command command{};
    command.kind = CommandKind::back_off;
    machine().order(command, session::phrase("Back off"));
    ASSERT_TRUE(comes_true([&] { return text_of("alarm_reason").startsWith("Back off: the switch"); }))
        << text_of("alarm_reason").toStdString();
    EXPECT_EQ(part<QLabel>("alarm_reason").property("trouble"), "yes");
    machine().order(CommandKind::reset_alarm, session::phrase("Reset alarm"));
    ASSERT_TRUE(comes_to(S::off));
}

}  // namespace
}  // namespace psicarve::ui
