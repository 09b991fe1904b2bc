// SPDX-License-Identifier: GPL-3.0-or-later
// What is locked says why: every button that is seen and cannot be pressed, on all pages, whatever the
// machine is at.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDialog>
#include <QTabBar>
#include <QTabWidget>

#include <fstream>
#include <map>
#include <set>

#include "tests/hmi/replay/recorded_run.hpp"
#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class Reasons : public replay::test::RecordedOn<test::PagesRig> {
protected:
    ~Reasons() override {
        // What stands there when a button can be pressed is no reason why it cannot.
        for (const auto& [name, tips] : locked_) {
            for (const QString& tip : tips)
                EXPECT_FALSE(free_[name].contains(tip)) << name << ": " << tip.toStdString();
        }
    }

    void expect_reasons(const std::string& where) {
        for (int look = 0; look < 2; ++look) {
            window_->refresh();
            QApplication::processEvents();
        }
        for (const QAbstractButton* button : window_->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || is_of_qt(*button)) continue;
            const std::string name =
                (button->objectName().isEmpty() ? button->text() : button->objectName()).toStdString();
            if (button->isEnabled()) {
                free_[name].insert(button->toolTip());
                continue;
            }
            locked_[name].insert(button->toolTip());
            EXPECT_FALSE(button->toolTip().isEmpty()) << where << ": " << name;
            EXPECT_EQ(button->accessibleDescription(), button->toolTip()) << where << ": " << name;
        }
    }
    void expect_reasons_on_all_pages(const std::string& where) {
        auto& tabs = part<QTabWidget>("tabs");
        for (int i = 0; i < tabs.count(); ++i) {
            tabs.setCurrentIndex(i);
            for (const char* what : {"show_measurement", "check_computer", "show_steps"}) {
                if (!button(what).isVisible()) continue;
                button(what).click();
                expect_reasons(where + ", " + what);
            }
            expect_reasons(where + ", page " + std::to_string(i + 1));
        }
        show_page("model_page");
    }
    std::set<std::string> locked_names() const {
        std::set<std::string> names;
        for (const auto& [name, tips] : locked_) names.insert(name);
        return names;
    }

private:
    static bool is_of_qt(const QAbstractButton& button) {
        return qobject_cast<const QTabBar*>(button.parentWidget()) != nullptr ||
               button.inherits("QTableCornerButton") || button.objectName().startsWith("qt_") ||
               button.parentWidget()->inherits("QLineEdit");
    }

    std::map<std::string, std::set<QString>> free_;
    std::map<std::string, std::set<QString>> locked_;
};

TEST_F(Reasons, AreToldWithoutACoreWithAndWithoutAModel) {
    open_window();
    expect_reasons_on_all_pages("no core");
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    expect_reasons_on_all_pages("no core, a model");
    EXPECT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    expect_reasons_on_all_pages("no core, a job");
    for (const char* name : {"home", "start", "jog_y_up", "profile_save", "profile_undo", "profile_restore",
                             "latency_end", "latency_save", "view_undercut", "model_report_open"})
        EXPECT_TRUE(locked_names().contains(name)) << name;
}

TEST_F(Reasons, AreToldOfAProfile) {
    std::ofstream(file("machine.toml")) << "name = \"lathe\"\n";
    open_window();
    show_page("profile_page");
    ASSERT_TRUE(opens(file("machine.toml")));
    expect_reasons("from a file");
    edit("core_radius_mm", "1.7");
    expect_reasons("changed");
    edit("core_radius_mm", "wide");
    expect_reasons("wrong");
    ASSERT_TRUE(click("profile_undo"));
    ASSERT_TRUE(click("profile_calibrate"));
    ASSERT_TRUE(comes_true([&] { return button("calibrate_close").isVisible(); }));
    expect_reasons("calibration");
    EXPECT_TRUE(locked_names().contains("calibrate_back"));
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(click("calibrate_next"));
    expect_reasons("what becomes of it");
}

TEST_F(Reasons, AreToldWhateverTheMachineIsAt) {
    start_core();
    open_window();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    expect_reasons_on_all_pages("not homed");
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    expect_reasons_on_all_pages("published");
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    expect_reasons_on_all_pages("homed");
    ASSERT_TRUE(click("go_to"));
    expect_reasons("to a position");
    part<QDialog>("move_dialog").close();
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    expect_reasons_on_all_pages("carving");
    ASSERT_TRUE(click("hold"));
    ASSERT_TRUE(comes_to(S::held));
    expect_reasons_on_all_pages("held");
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(S::alarm));
    expect_reasons_on_all_pages("alarm");
    core_.reset();
    ASSERT_TRUE(comes_true([&] { return !machine_view().is_heard(); }));
    expect_reasons_on_all_pages("core lost");
}

TEST_F(Reasons, AreToldOfRecordings) {
    record();
    open_window();
    expect_reasons("at first");
    for (const std::string& recording : {trace(), snapshot()}) {
        window_->open(QString::fromStdString(recording));
        auto& desk = window_->context().replay;
        ASSERT_TRUE(comes_true([&] { return desk.is_open() && desk.is_settled(); }));
        expect_reasons_on_all_pages(recording);
        desk.leave();
    }
    EXPECT_TRUE(locked_names().contains("dry_run"));
}

}  // namespace
}  // namespace psicarve::ui
