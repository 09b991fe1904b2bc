// SPDX-License-Identifier: GPL-3.0-or-later
// Page Program: what runs is what was shown, once, and can be stopped before it moves.
#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include <filesystem>
#include <sstream>
#include <string>

#include "hmi/offsets/offsets_file.hpp"
#include "hmi/offsets/offsets_lock.hpp"
#include "tests/hmi/ui/program_rig.hpp"

namespace psicarve::ui {
namespace {

constexpr const char* kShortProgram = "G21 G90 F300\nG0 X40 Z41 Y5 C0\nM0\nG1 Y7\nM2\n";

class ProgramGuardOf : public test::ProgramRig {
protected:
    /// Its check takes a while.
    static std::string long_program() {
        std::ostringstream text;
        text << "G21 G90 F600\nG0 X50 Z50 Y10 C0\n";
        for (int i = 0; i < 300'000; ++i) text << "G1 X" << 50 - i % 10 << " C" << i % 360 << "\n";
        text << "M2\n";
        return text.str();
    }
    bool is_card_shown() { return part<QWidget>("approach_card").isVisible(); }
    void send_return(QWidget& to, Qt::KeyboardModifiers with, bool is_repeated) {
        QKeyEvent press{QEvent::KeyPress, Qt::Key_Return, with, QStringLiteral("\r"), is_repeated};
        QApplication::sendEvent(&to, &press);
    }
};

TEST_F(ProgramGuardOf, ADoubleClickStartsOneProcess) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens(kShortProgram));
    ASSERT_TRUE(comes_true([&] { return button("program_start").isEnabled(); }));
    auto& start = button("program_start");
    start.clicked();
    start.clicked();
    EXPECT_FALSE(start.isEnabled());
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    EXPECT_EQ(all_messages().count("Program started"), 1) << all_messages().toStdString();
    ASSERT_TRUE(click("program_stop"));
    ASSERT_TRUE(is_over(false));
}

TEST_F(ProgramGuardOf, AFileThatIsAnotherByNowIsNotRun) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens(kShortProgram));
    ASSERT_TRUE(comes_true([&] { return button("program_start").isEnabled(); }));
    program("G21 G90 F300\nG0 X30\nM0\nM2\n");
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(is_over(false));
    EXPECT_TRUE(state_of_page().contains("has been changed since it was read; decode it again"))
        << state_of_page().toStdString();
    EXPECT_EQ(running().program, 0U) << "nothing has moved";
}

TEST_F(ProgramGuardOf, AProgramThatWouldBeginWithOtherOffsetsIsNotRun) {
    setenv("PSICARVE_STATE", file("state-of-offsets").c_str(), 1);
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens(kShortProgram));
    ASSERT_TRUE(comes_true([&] { return button("program_start").isEnabled(); }));
    const auto place = offsets::OffsetsPlace::of(segment_name_, true);
    offsets::Offsets changed;
    changed.kept.systems[0].origin[0] = 1.0;
    {
        const auto lock = offsets::OffsetsLock::take(place, std::chrono::milliseconds{0});
        ASSERT_TRUE(lock);
        ASSERT_TRUE(offsets::write_offsets(place, changed, {}));
    }
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(is_over(false));
    EXPECT_TRUE(state_of_page().contains("work offsets have been changed since it was read"))
        << state_of_page().toStdString();
    EXPECT_EQ(running().program, 0U) << "nothing has moved";
    setenv("PSICARVE_STATE", "", 1);
}

TEST_F(ProgramGuardOf, StopEndsWhatIsOnItsWayBeforeItMoves) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens(long_program()));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(click("program_stop"));
    ASSERT_TRUE(is_over(false));
    EXPECT_TRUE(state_of_page().endsWith("interrupted; nothing has moved")) << state_of_page().toStdString();
    const qsizetype before = all_messages().count("Program started");
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(comes_true([&] { return desk().has_process(); }));
    press_key(Qt::Key_Escape, Qt::ShiftModifier);
    ASSERT_TRUE(is_over(false));
    EXPECT_GT(all_messages().count("Program started"), before);
    EXPECT_TRUE(state_of_page().endsWith("interrupted; nothing has moved")) << state_of_page().toStdString();
    EXPECT_EQ(running().program, 0U);
}

TEST_F(ProgramGuardOf, TheCardTellsOfTheMachineAsItIsNow) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G91 F300\nG0 X-2\nG0 Y1\nM2\n"));
    part<QSpinBox>("program_from_line").setValue(3);
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(comes_true([&] { return is_card_shown(); }));
    const QString first = text_of("approach_told");
    ASSERT_TRUE(click("approach_back"));
    auto& line = part<QLineEdit>("mdi_line");
    line.setText("G0 X40");
    line.returnPressed();
    ASSERT_TRUE(is_over(true));
    EXPECT_NEAR(place(Axis::r1), 40.0, 0.01);
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(comes_true([&] { return is_card_shown(); }));
    EXPECT_NE(text_of("approach_told"), first);
    EXPECT_TRUE(text_of("approach_told").contains("R1 38.000 mm")) << text_of("approach_told").toStdString();
    part<QAbstractButton>("program_delete").click();
    window_->refresh();
    // Read anew it may be by now.
    EXPECT_TRUE(!is_card_shown() || desk().program()->request.skips_deleted) << "a card of the old reading";
    ASSERT_TRUE(comes_true([&] { return is_card_shown(); }));
    EXPECT_TRUE(desk().program()->request.skips_deleted);
}

TEST_F(ProgramGuardOf, MarksNoLineOfAnotherFileAndNamesWhatRuns) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens(kShortProgram));
    ASSERT_TRUE(click("program_optional"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    window_->open(QString::fromStdString(program("G21 G90\nG0 X40\nG0 X41\nM2\n", "other.ngc")));
    ASSERT_TRUE(comes_true([&] {
        return !desk().is_reading() && desk().program() &&
               desk().program()->request.path.ends_with("other.ngc");
    }));
    EXPECT_TRUE(state_of_page().startsWith("part.ngc runs. Line 3: ")) << state_of_page().toStdString();
    EXPECT_EQ(text_view().running_line(), 0U);
    EXPECT_TRUE(part<QAbstractButton>("program_optional").isChecked()) << "what runs was started so";
    ASSERT_TRUE(click("program_stop"));
    ASSERT_TRUE(is_over(false));
    EXPECT_TRUE(state_of_page().startsWith("part.ngc ended: ")) << state_of_page().toStdString();
    window_->refresh();
    EXPECT_FALSE(part<QAbstractButton>("program_optional").isChecked());
}

TEST_F(ProgramGuardOf, ALineThatIsTypedIsLeftAloneAndNeverAnotherOne) {
    open_in_front();
    ASSERT_TRUE(opens("G21 G90\nG0 X40\nG0 X41\nG0 X42\nM2\n"));
    auto& from = part<QSpinBox>("program_from_line");
    from.setValue(4);
    auto* const typed = from.findChild<QLineEdit*>();
    typed->clear();
    window_->refresh();
    EXPECT_EQ(typed->text(), "");
    from.setValue(4);
    program("G21 G90\nG0 X40\nM2\n");
    ASSERT_TRUE(click("program_again"));
    ASSERT_TRUE(comes_true([&] { return !desk().is_reading() && desk().program()->facts.line_count == 3; }));
    window_->refresh();
    EXPECT_EQ(desk().switches.from_line, 4U);
    EXPECT_EQ(from.value(), 4);
}

TEST_F(ProgramGuardOf, ABlockIsOneLineAndRunsOnce) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    show_page("program_page");
    auto& line = part<QLineEdit>("mdi_line");
    line.setText("G0 X44\nG0 Y3");
    line.returnPressed();
    window_->refresh();
    EXPECT_EQ(text_of("mdi_said"), "The text has more than one line; only one block is run.");
    line.setText("(" + QString{600, QChar{0x416}} + ")");
    line.returnPressed();
    window_->refresh();
    EXPECT_EQ(text_of("mdi_said"), "The block has 1202 bytes; a line has 1024 at most.");
    line.setText("G0 X44");
    send_return(line, Qt::ControlModifier, false);
    send_return(line, Qt::NoModifier, true);
    EXPECT_FALSE(desk().is_under_way());
    send_return(line, Qt::NoModifier, false);
    EXPECT_TRUE(desk().is_under_way());
    ASSERT_TRUE(is_over(true));
    const std::filesystem::path folder = std::filesystem::path{file("state")} / "psicarve" / "programs";
    std::size_t logs = 0;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        logs += entry.path().string().ends_with(".run.log") ? 1 : 0;
        EXPECT_NE(entry.path().extension(), ".ngc") << entry.path();
        EXPECT_NE(entry.path().extension(), ".toml") << entry.path();
    }
    EXPECT_GE(logs, 1U);
}

TEST_F(ProgramGuardOf, NoShortcutStartsTheJobFromItsPage) {
    open_in_front();
    show_page("program_page");
    EXPECT_TRUE(button("start").shortcut().isEmpty());
    show_page("model_page");
    EXPECT_EQ(button("start").shortcut(), QKeySequence{Qt::CTRL | Qt::Key_Return});
}

}  // namespace
}  // namespace psicarve::ui
