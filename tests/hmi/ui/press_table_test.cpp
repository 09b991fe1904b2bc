// SPDX-License-Identifier: GPL-3.0-or-later
// No button, entry or key of the window is without a test that presses it.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "tests/hmi/ui/press_log.hpp"
#include "tests/hmi/ui/press_table.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::PressLog;

class PressTable : public test::WindowRig {
protected:
    PressTable() {
        for (const test::PressLine& line : test::press_table()) names_.insert(line.name);
    }
    void expect_line(const std::string& name) {
        EXPECT_TRUE(names_.contains(name)) << name << ": no line in press_table.cpp";
    }

    std::set<std::string> names_;
};

TEST_F(PressTable, HasAllThatCanBePressed) {
    open_window();
    for (const QAbstractButton* each : window_->findChildren<QAbstractButton*>()) {
        if (PressLog::is_for_table(*each)) expect_line(PressLog::name_of(*each, each->text()));
    }
    for (const QAction* action : window_->findChildren<QAction*>()) {
        const bool is_placeholder = !action->isEnabled() && action->text() == "None yet";
        if (action->isSeparator() || action->menu() != nullptr || PressLog::is_of_qt(*action) ||
            is_placeholder)
            continue;
        expect_line(PressLog::name_of(*action, action->text()));
        for (const QKeySequence& keys : action->shortcuts())
            expect_line(keys.toString(QKeySequence::PortableText).toStdString());
    }
    // No action and no button has them.
    for (const char* key : {"F1", "Esc", "Shift+Esc", "Shift+Left", "Shift+Right", "Shift+Up", "Shift+Down",
                            "Shift+PgUp", "Shift+PgDown", "Ctrl+Shift+PgUp", "Ctrl+Shift+PgDown"})
        expect_line(key);
    for (const QAbstractButton* each : window_->findChildren<QAbstractButton*>()) {
        if (!each->shortcut().isEmpty())
            expect_line(each->shortcut().toString(QKeySequence::PortableText).toStdString());
    }
}

TEST(PressLines, NameTestsThatThereAre) {
    std::set<std::string> tests;
    const auto* const program = ::testing::UnitTest::GetInstance();
    for (int i = 0; i < program->total_test_suite_count(); ++i) {
        const auto* const suite = program->GetTestSuite(i);
        for (int k = 0; k < suite->total_test_count(); ++k)
            tests.insert(std::string{suite->name()} + "." + suite->GetTestInfo(k)->name());
    }
    std::set<std::pair<std::string, std::string>> seen;  // a key may mean something else elsewhere
    for (const test::PressLine& line : test::press_table()) {
        EXPECT_TRUE(tests.contains(line.test)) << line.name << ": " << line.test;
        EXPECT_TRUE(seen.emplace(line.name, line.test).second) << line.name << " is there twice";
    }
}

}  // namespace
}  // namespace psicarve::ui
