// SPDX-License-Identifier: GPL-3.0-or-later
// Page Program: a program is read, judged, drawn, run and watched; one block by hand.
#include <gtest/gtest.h>

#include <unistd.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScopeGuard>
#include <QSpinBox>

#include <sstream>
#include <string>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/language.hpp"
#include "tests/hmi/ui/program_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class ProgramPageOf : public test::ProgramRig {};

TEST_F(ProgramPageOf, ShowsErrorsBesideTheirLinesAndStartsNoneThatIsWrong) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    show_page("program_page");
    EXPECT_EQ(button("program_start").toolTip(), "Start: no program is open");
    EXPECT_FALSE(button("program_again").isEnabled());
    ASSERT_TRUE(opens("G21 G90\nG0 X40\nG1 X30\nG1 F300 X99\nS1000 M7\nM2\n"));
    EXPECT_EQ(page_name(), "program_page");
    auto& problems = part<QListWidget>("program_problems");
    ASSERT_EQ(problems.count(), 4) << "warnings, too";
    EXPECT_TRUE(problems.item(0)->text().startsWith("Line 3, column 4: feed_missing: "))
        << problems.item(0)->text().toStdString();
    EXPECT_TRUE(problems.item(0)->text().contains("; give F before the first move that cuts"));
    EXPECT_TRUE(problems.item(1)->text().startsWith("Line 4, column 9: outside_travel: "))
        << problems.item(1)->text().toStdString();
    EXPECT_TRUE(problems.item(2)->text().startsWith("Line 5"));
    problems.setCurrentRow(1);
    EXPECT_EQ(text_view().chosen_line(), 4U);
    EXPECT_TRUE(comes_true([&] { return desk().text().line(4) != nullptr; }));
    take_picture("program_errors_light");
    window_->set_theme(ThemeChoice::dark);
    take_picture("program_errors_dark");
    window_->set_theme(ThemeChoice::light);
    window_->refresh();
    EXPECT_EQ(button("program_start").toolTip(), "Start: errors in the program: 2");
    EXPECT_FALSE(button("program_start").isEnabled());
    program("G21 G90 F300\nG0 X40\nG1 X30\nM2\n");
    ASSERT_TRUE(click("program_again"));
    ASSERT_TRUE(comes_true([&] { return desk().program() && desk().program()->is_right(); }));
    EXPECT_TRUE(comes_true([&] { return button("program_start").isEnabled(); }));
    EXPECT_EQ(problems.count(), 0);
    EXPECT_FALSE(problems.isVisible());
    EXPECT_TRUE(text_of("program_facts").startsWith("Lines: 4, moves: 2"));
}

TEST_F(ProgramPageOf, OpensAMillionLinesWithoutWaitingAndCanBeCancelled) {
    constexpr int kLines = 1'000'000;
    std::ostringstream text;
    text << "G21 G90 F600\nG0 X50 Z50 Y10 C0\n";
    for (int i = 3; i < kLines; ++i) text << "G1 X" << 50 - i % 10 << " C" << i % 360 << "\n";
    text << "M2\n";
    open_window();
    window_->open(QString::fromStdString(program(text.str())));
    EXPECT_TRUE(desk().is_reading());
    window_->refresh();
    EXPECT_TRUE(button("program_cancel").isEnabled());
    ASSERT_TRUE(click("program_cancel"));
    ASSERT_TRUE(comes_true([&] { return !desk().is_reading(); }));
    EXPECT_EQ(desk().program(), nullptr) << "it was given up";
    EXPECT_EQ(button("program_cancel").toolTip(), "Cancel: nothing is being read");
    ASSERT_TRUE(click("program_again"));
    ASSERT_TRUE(is_read());
    EXPECT_EQ(desk().program()->lines.line_count(), std::uint64_t{kLines});
    text_view().go_to(kLines);
    EXPECT_LE(text_view().first_line(), std::uint64_t{kLines});
    EXPECT_GE(text_view().first_line() + text_view().seen_lines(), std::uint64_t{kLines});
    EXPECT_TRUE(comes_true([&] { return desk().text().line(kLines) != nullptr; }));
    EXPECT_EQ(*desk().text().line(kLines), "M2");
    EXPECT_EQ(desk().text().line(1), nullptr) << "and holds what is looked at alone";
    window_->refresh();
    EXPECT_EQ(part<QSpinBox>("program_from_line").maximum(), kLines);
}

TEST_F(ProgramPageOf, DrawsThePathInEachPlane) {
    open_in_front();
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Y5 C0\nG1 X35\nG1 Y12 C800\nG0 Z40\nM2\n"));
    EXPECT_EQ(path_view().plane(), ProgramPathView::Plane::r1);
    EXPECT_EQ(path_view().drawn_pieces(), 3U) << "the way to the first place begins anywhere";
    ASSERT_TRUE(click("program_plane_unrolled"));
    EXPECT_EQ(path_view().plane(), ProgramPathView::Plane::unrolled);
    take_picture("program_unrolled_light");
    ASSERT_TRUE(click("program_plane_r2"));
    EXPECT_EQ(path_view().plane(), ProgramPathView::Plane::r2);
    EXPECT_EQ(path_view().drawn_pieces(), 0U);
    text_view().go_to(4);
    EXPECT_EQ(path_view().marked_piece(), 3U);
    ASSERT_TRUE(click("program_plane_r1"));
    EXPECT_EQ(path_view().marked_piece(), 3U);
}

TEST_F(ProgramPageOf, RunsAProgramToItsEndAndFollowsItsLine) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    std::string text = "G21 G90 F300\nG0 X40 Z41 Y5 C0\n";
    for (int i = 3; i < 100; ++i)
        text += "G1 X" + std::to_string(40 - i % 3) + " C" + std::to_string(i) + "\n";
    ASSERT_TRUE(opens(text + "M0\nG1 Y6\nM2\n"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(100, ProgramHold::program));
    window_->refresh();
    EXPECT_EQ(text_view().running_line(), 100U);
    EXPECT_LE(text_view().first_line(), 100U);
    EXPECT_GT(text_view().first_line() + text_view().seen_lines(), 100U) << "it is followed";
    EXPECT_TRUE(
        state_of_page().startsWith("The program runs. Line 100: a stop of the program (M0); Resume goes on"))
        << state_of_page().toStdString();
    EXPECT_EQ(button("program_start").toolTip(), "Start: another program runs; stop it first");
    EXPECT_TRUE(button("program_optional").isEnabled());
    EXPECT_FALSE(button("program_delete").isEnabled());
    take_picture("program_running_light");
    part<QAbstractButton>("program_follow").click();
    text_view().go_to(1);
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(is_over(true));
    EXPECT_EQ(text_view().first_line(), 1U) << "it is followed no more";
    EXPECT_EQ(text_view().running_line(), 0U);
    EXPECT_NEAR(place(Axis::y), 6.0, 0.01);
    EXPECT_EQ(state_of_page(), "part.ngc is run.");
    EXPECT_TRUE(comes_true([&] { return button("program_start").isEnabled(); }));
}

TEST_F(ProgramPageOf, SaysWhatHoldsWhereTheMachineIs) {
    const QByteArray state = qgetenv("PSICARVE_STATE");
    qputenv("PSICARVE_STATE", QByteArray::fromStdString(file("")));
    const auto restored = qScopeGuard([&] { qputenv("PSICARVE_STATE", state); });
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    show_page("program_page");
    ASSERT_TRUE(
        opens("G21 G90 F300 G10 L2 P2 X30 Y4\nG0 X40 Z41 Y5\nG55 G91 G1 X-1\nM0\nG54 G90 G0 X45\nM2\n"));
    window_->refresh();
    const QString whose = QString::fromStdString(desk().program()->offsets_path);
    ASSERT_FALSE(whose.isEmpty());
    EXPECT_TRUE(text_of("program_facts")
                    .contains(QStringLiteral("Begins in G54 at the machine's zero, as ") +
                              (whose.size() <= 40 ? whose : QChar{0x2026} + whose.right(39)) + " has it."))
        << text_of("program_facts").toStdString();
    EXPECT_TRUE(part<QLabel>("program_facts").toolTip().contains(whose))
        << part<QLabel>("program_facts").toolTip().toStdString();
    EXPECT_FALSE(part<QLabel>("program_modes").isVisible());
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(4, ProgramHold::program));
    EXPECT_TRUE(comes_true([&] {
        return text_of("program_modes") ==
               "G1 G17 G21 G91 G94 G55 G64 G40 G49 G99 G91.1 G13.1 M5 M9 M48   F 300  S 0  T 0\n"
               "Zero of G55: R1 30.000 · R2 0.000 · Y 4.000 mm · Ψ 0.000°\n"
               "To go: R1 0.000 · R2 0.000 · Y 0.000 mm · Ψ 0.000° · queue: 0 of 8192";
    })) << text_of("program_modes").toStdString();
    EXPECT_FALSE(text_of("program_facts").contains("Begins in"));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(is_over(true));
    EXPECT_FALSE(part<QLabel>("program_modes").isVisible());
}

TEST_F(ProgramPageOf, LeavesAProgramRunningWhenTheWindowIsClosed) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Z41 Y5\nM0\nG1 Y7\nM2\n"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    const auto writer = static_cast<pid_t>(program_report(*segment_).writer_pid);
    ASSERT_GT(writer, 0);
    EXPECT_EQ(getsid(writer), writer) << "a session of its own";
    window_.reset();
    EXPECT_EQ(kill(writer, 0), 0);
    EXPECT_EQ(program_report(*segment_).status.is_running, 1U);
    open_in_front();
    show_page("program_page");
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    EXPECT_TRUE(state_of_page().contains(" runs, of another process. Line 3: "))
        << state_of_page().toStdString();
    EXPECT_EQ(text_view().running_line(), 0U) << "nobody knows which file it is of";
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(comes_true([&] { return machine_view().state() == S::ready && running().is_done != 0; }));
    EXPECT_NEAR(place(Axis::y), 7.0, 0.01);
}

TEST_F(ProgramPageOf, StopsAProgramAndTellsWhatItsProcessSaid) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Z41 Y5\nM0\nG1 Y7\nM2\n"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    ASSERT_TRUE(click("program_stop"));
    ASSERT_TRUE(is_over(false));
    EXPECT_EQ(state_of_page(), "part.ngc ended: it was stopped in line 3; it can go on from there");
    EXPECT_TRUE(all_messages().contains("Program ended")) << all_messages().toStdString();
}

TEST_F(ProgramPageOf, RunsAsTheSwitchesSay) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Z41 Y5\n/M0\nM1\nG1 Y7\nM2\n"));
    ASSERT_TRUE(click("program_delete"));
    ASSERT_TRUE(comes_true([&] { return !desk().is_reading() && desk().program()->request.skips_deleted; }));
    ASSERT_TRUE(click("program_optional"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(4, ProgramHold::optional));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(is_over(true));
    ASSERT_TRUE(click("program_optional"));
    ASSERT_TRUE(click("program_single"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(2, ProgramHold::single));
    ASSERT_TRUE(click("program_stop"));
    ASSERT_TRUE(is_over(false));
    ASSERT_TRUE(click("program_single"));
    ASSERT_TRUE(click("program_dry"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(is_over(true)) << "with the heads outside";
    EXPECT_GT(place(Axis::r1), 45.0);
    EXPECT_NEAR(place(Axis::y), 7.0, 0.01);
}

TEST_F(ProgramPageOf, SwitchesSingleBlockWhileItRuns) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Z41 Y5\nM0\nG1 Y7\nG1 X39\nG1 Y8\nM2\n"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    window_->refresh();
    EXPECT_TRUE(button("program_single").isEnabled());
    EXPECT_FALSE(button("program_single").isChecked());
    ASSERT_TRUE(click("program_single"));
    ASSERT_TRUE(comes_true([&] { return window_->context().program_report.status.is_single != 0; }));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(holds_in_line(4, ProgramHold::single));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(holds_in_line(5, ProgramHold::single));
    window_->refresh();
    EXPECT_TRUE(button("program_single").isChecked());
    ASSERT_TRUE(click("program_single"));
    ASSERT_TRUE(comes_true([&] { return window_->context().program_report.status.is_single == 0; }));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(is_over(true));
    EXPECT_FALSE(desk().switches.is_single) << "that of the next start is as it was";
}

TEST_F(ProgramPageOf, SwitchesOptionalStopWhileItRuns) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Z41 Y5\nM0\nG1 Y7\nM1\nG1 X39\nM1\nG1 Y8\nM2\n"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    window_->refresh();
    EXPECT_TRUE(button("program_optional").isEnabled());
    EXPECT_FALSE(button("program_optional").isChecked());
    EXPECT_FALSE(button("program_delete").isEnabled()) << "that is decided where the block is read";
    ASSERT_TRUE(click("program_optional"));
    ASSERT_TRUE(comes_true([&] { return window_->context().program_report.status.stops_at_optional != 0; }));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(holds_in_line(4, ProgramHold::optional));
    window_->refresh();
    EXPECT_TRUE(button("program_optional").isChecked());
    ASSERT_TRUE(click("program_optional"));
    ASSERT_TRUE(comes_true([&] { return window_->context().program_report.status.stops_at_optional == 0; }));
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(is_over(true));
    EXPECT_FALSE(desk().switches.stops_at_optional) << "that of the next start is as it was";
}

TEST_F(ProgramPageOf, RunsFromALineOnceItWasToldWhatComesBeforeIt) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nM3\nG0 X40 Z41 Y5 C370\nG1 X38\nG1 Y7\nM2\n"));
    part<QSpinBox>("program_from_line").setValue(5);
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("approach_card").isVisible(); }));
    EXPECT_EQ(machine_view().state(), S::ready) << "nothing moves before it is confirmed";
    EXPECT_EQ(text_of("approach_title"), "Run from line 5: first the machine does this");
    EXPECT_EQ(text_of("approach_told"),
              "The spindle goes on.\nBoth heads go out to the end of their travel.\nΨ turns to 370.000°, all "
              "turns.\nY goes to 5.000 mm.\nThe heads come in: R1 38.000 mm, R2 41.000 mm.");
    take_picture("program_from_line_light");
    ASSERT_TRUE(click("approach_back"));
    EXPECT_FALSE(part<QWidget>("approach_card").isVisible());
    EXPECT_FALSE(desk().is_under_way());
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("approach_card").isVisible(); }));
    ASSERT_TRUE(click("approach_confirm"));
    ASSERT_TRUE(is_over(true));
    EXPECT_FALSE(part<QWidget>("approach_card").isVisible());
    EXPECT_NEAR(place(Axis::r1), 38.0, 0.01);
    EXPECT_NEAR(place(Axis::y), 7.0, 0.01);
    EXPECT_NEAR(place(Axis::psi), 370.0, 0.1);
}

TEST_F(ProgramPageOf, RunsABlockThatIsTypedAndBringsBackThoseBefore) {
    start_core();
    open_in_front();
    show_page("program_page");
    auto& line = part<QLineEdit>("mdi_line");
    line.setFocus();
    line.setText("G0 X44");
    press_key(Qt::Key_Return);
    EXPECT_EQ(text_of("mdi_said"), "Start: axis R1 is not homed");
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    line.setFocus();
    press_key(Qt::Key_Return);
    ASSERT_TRUE(is_over(true));
    EXPECT_NEAR(place(Axis::r1), 44.0, 0.01);
    EXPECT_EQ(text_of("mdi_said"), "The block is run.");
    line.setText("G1 X43 F3OO");
    press_key(Qt::Key_Return);
    ASSERT_TRUE(comes_true([&] { return desk().ended() && desk().ended()->problems.error_count() > 0; }));
    window_->refresh();
    EXPECT_TRUE(text_of("mdi_said").startsWith("Column 10: ")) << text_of("mdi_said").toStdString();
    EXPECT_NEAR(place(Axis::r1), 44.0, 0.01);
    line.setText("G0");
    press_key(Qt::Key_Up);
    EXPECT_EQ(line.text(), "G1 X43 F3OO");
    press_key(Qt::Key_Up);
    EXPECT_EQ(line.text(), "G0 X44");
    press_key(Qt::Key_Up);
    EXPECT_EQ(line.text(), "G0 X44");
    press_key(Qt::Key_Down);
    press_key(Qt::Key_Down);
    EXPECT_EQ(line.text(), "G0") << "what was being typed";
}

TEST_F(ProgramPageOf, KeepsWhatItShowsInAnotherLanguage) {
    ASSERT_NO_FATAL_FAILURE(have_homed_window());
    ASSERT_TRUE(opens("G21 G90 F300\nG0 X40 Z41 Y5\nM0\nM2\n"));
    part<QLineEdit>("mdi_line").setText("G0 X1");
    ASSERT_TRUE(click("program_plane_unrolled"));
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(holds_in_line(3, ProgramHold::program));
    window_->findChild<QAction*>("language_ru")->trigger();
    ASSERT_TRUE(comes_true([&] { return used_language() == Language::russian; }));
    EXPECT_EQ(button("program_start").text(), QString::fromUtf8("Пуск программы"));
    EXPECT_EQ(page_name(), "program_page");
    EXPECT_EQ(part<QLineEdit>("mdi_line").text(), "G0 X1");
    EXPECT_EQ(path_view().plane(), ProgramPathView::Plane::unrolled);
    EXPECT_TRUE(comes_true([&] { return text_view().running_line() == 3U; }));
    EXPECT_FALSE(state_of_page().contains("Line")) << state_of_page().toStdString();
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(is_over(true));
}

TEST_F(ProgramPageOf, OpensAFileByItsDialogAndItsMenu) {
    open_in_front();
    const std::string path = program("G21 G90 F300\nG0 X40\nM2\n");
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("program_action")); }, ""));
    EXPECT_EQ(page_name(), "program_page");
    EXPECT_EQ(desk().path(), "") << "Esc only closes it";
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("program_open")); }, path));
    ASSERT_TRUE(is_read());
    EXPECT_EQ(text_of("program_name"), QString::fromStdString(path));
    window_->open(QString::fromStdString(file("none.ngc")));
    ASSERT_TRUE(comes_true([&] { return !desk().is_reading() && !desk().problem().is_empty(); }));
    window_->refresh();
    EXPECT_TRUE(text_of("program_facts").contains("none.ngc")) << text_of("program_facts").toStdString();
    EXPECT_EQ(desk().program(), nullptr);
}

}  // namespace
}  // namespace psicarve::ui
