// SPDX-License-Identifier: GPL-3.0-or-later
// Page Program cuts nothing off, in any language, on small screens, with all that it can show.
#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QScopeGuard>
#include <QSpinBox>
#include <QTabWidget>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "hmi/offsets/offsets_file.hpp"
#include "hmi/ui/language.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/ui/fit_audit.hpp"
#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::ui {
namespace {

class ProgramFit : public test::PagesRig {
protected:
    /// One window walks through all.
    void expect_fit(const char* what) {
        for (const Language language : {Language::chinese, Language::russian, Language::english}) {
            if (psicarve::test::kIsSanitized && language != Language::chinese) continue;
            const QString code = QLatin1String(kLanguages[static_cast<std::size_t>(language)].code);
            part<QAction>(("language_" + code).toUtf8().constData()).trigger();
            ASSERT_TRUE(comes_true([&] { return used_language() == language; }));
            // There and back: to stay costs nothing.
            std::ranges::reverse(screens_);
            for (const QSize& screen : screens_) {
                window_->resize(screen);
                show_page("program_page");
                for (int look = 0; look < 5; ++look) {
                    window_->refresh();
                    QApplication::processEvents();
                }
                const QString where =
                    QStringLiteral("program_%1_%2_%3").arg(what, code, QString::number(screen.width()));
                EXPECT_EQ(window_->size(), screen) << where.toStdString();
                for (const std::string& misfit : test::misfits(*window_)) {
                    // As with all pages: there are more than 640 pixels have names for.
                    const bool is_excused =
                        screen.width() == 640 && misfit.find("tab out of sight") != std::string::npos;
                    if (!is_excused && seen_.insert(misfit).second)
                        ADD_FAILURE() << where.toStdString() << ": " << misfit;
                }
                take_picture(where);
            }
        }
        // What follows reads its words, whichever languages were looked at.
        part<QAction>("language_en").trigger();
        ASSERT_TRUE(comes_true([&] { return used_language() == Language::english; }));
        show_page("program_page");
        for (int look = 0; look < 5; ++look) {
            window_->refresh();
            QApplication::processEvents();
        }
    }
    void open_text(const std::string& text) {
        const std::string path =
            file("a_name_without_a_space_as_programs_for_drawing_make_them_by_themselves_1234.ngc");
        std::ofstream{path} << text;
        window_->open(QString::fromStdString(path));
        ASSERT_TRUE(comes_true([&] {
            return !window_->context().program.is_reading() && window_->context().program.program();
        }));
    }

private:
    std::vector<QSize> screens_{{640, 360}, {960, 515}, {1280, 690}};
    std::set<std::string> seen_;
};

TEST_F(ProgramFit, WithErrorsAndWithWhatComesBeforeALine) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    open_text("G21 G90\nG0 X40\nG1 X30\nG1 F300 X99\nS1000 M7\nM2\n");
    ASSERT_NO_FATAL_FAILURE(expect_fit("errors"));
    open_text("G21 G90 F300\nM3\nG0 X40 Z41 Y5 C370\nG1 X38\nG1 Y7\nM2\n");
    window_->refresh();
    part<QSpinBox>("program_from_line").setValue(5);
    ASSERT_TRUE(click("program_start"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("approach_card").isVisible(); }));
    ASSERT_NO_FATAL_FAILURE(expect_fit("from_line"));
}

TEST_F(ProgramFit, WithAllThatHoldsInAProgram) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    open_text("G21 G90 F300\nG0 X40 Z41 Y5\nG1 X38\nM2\n");
    core_->send_signal(SIGSTOP);  // its words are ours
    auto status = load_words<CoreStatus>(segment_->header().status.words);
    status.state = MachineState::held;
    ProgramStatus program{};
    program.program = 1;
    program.line = 10'000'000;
    program.sequence = 10'000'000;
    program.is_running = 1;
    program.starvations = 12;
    program.hold = ProgramHold::tool_change;
    write_record(segment_->header().program.status, program);
    ProgramModes modes{};
    modes.program = 1;
    modes.line = 10'000'000;
    modes.sequence = 10'000'000;
    modes.g_codes = {20, 180, 200, 910, 940, 593, 611, 400, 431, 990, 911, 131, -1, -1, -1, -1};
    modes.m_codes = {3, 7, 8, 48, -1, -1, -1, -1};
    modes.feed = 1234.5678;
    modes.speed_rpm = 24'000;
    modes.tool = 12;
    modes.rotation_deg = -12.345;
    modes.zero = {-123.4567, -123.4567, -12'345.678, -123.4567};
    modes.end = {-40.0, -40.0, -12'345.678, -10.0};
    write_record(segment_->header().program.modes, modes);
    ASSERT_TRUE(comes_true([&] {
        ++status.heartbeat;
        write_record(segment_->header().status, status);
        window_->refresh();
        return machine_view().runs_program();
    }));
    ASSERT_NO_FATAL_FAILURE(expect_fit("modes"));

    // What is told is old, and its words are another process's.
    const auto shown_with = [&](const auto& change) {
        ProgramModes changed = modes;
        change(changed);
        write_record(segment_->header().program.modes, changed);
        ++status.heartbeat;
        write_record(segment_->header().status, status);
        window_->refresh();
        return part<QLabel>("program_modes").text();
    };
    const QString stale = shown_with([](ProgramModes& told) { told.sequence = told.line = 8; });
    EXPECT_TRUE(stale.section('\n', 0, 0).endsWith("F 1234.5678  S 24000  T 12 (told of line 8)"))
        << stale.toStdString();
    EXPECT_TRUE(stale.section('\n', 2, 2).startsWith(QString::fromUtf8("To go: – · queue: ")))
        << stale.toStdString();
    const QString wrong = shown_with([](ProgramModes& told) {
        told.g_codes[5] = 541;
        told.feed = 1e300;
        told.speed_rpm = std::numeric_limits<double>::quiet_NaN();
        told.end[2] = std::numeric_limits<double>::infinity();
    });
    EXPECT_TRUE(wrong.startsWith("G2 G18 G20 G91 G94 G61.1 G40 G43.1 G99 G91.1 G13.1 M3 M7 M8 M48   T 12\n"))
        << wrong.toStdString();
    EXPECT_TRUE(wrong.section('\n', 1, 1).startsWith(QString::fromUtf8("To go: – · queue: ")))
        << wrong.toStdString();
    const QString turned = shown_with([](ProgramModes& told) { told.rotation_deg = 1e300; });
    EXPECT_FALSE(turned.contains("turned")) << turned.toStdString();
    const QString nowhere = shown_with([](ProgramModes& told) { told.zero[1] = -1e300; });
    EXPECT_FALSE(nowhere.contains("Zero of")) << nowhere.toStdString();
    status.state = MachineState::stopping;
    const QString given_up = shown_with([](ProgramModes&) {});
    EXPECT_TRUE(given_up.contains(QString::fromUtf8("To go: – · "))) << given_up.toStdString();
}

// Where a program begins, and in a folder whose path is longer than the page is wide.
TEST_F(ProgramFit, WithWorkOffsetsOfALongPath) {
    const QByteArray before = qgetenv("PSICARVE_STATE");
    const std::string folder = file("a_folder_whose_path_has_no_spaces_in_it") +
                               "/and_one_below_it_with_an_even_longer_name_0123456789_0123456789";
    std::filesystem::create_directories(folder);
    qputenv("PSICARVE_STATE", QByteArray::fromStdString(folder));
    const auto restored = qScopeGuard([&] { qputenv("PSICARVE_STATE", before); });
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    open_text("G21 G90 F300\nG0 X40 Z41 Y5\nG1 X38\nM2\n");
    ASSERT_NO_FATAL_FAILURE(expect_fit("at_zero"));
    gcode::KeptOffsets kept;
    kept.systems[0].origin.fill(-123.4567);
    kept.systems[0].rotation_deg = -12.345;
    const auto read = window_->context().program.program();
    ASSERT_NE(read->offsets_path.find(folder), std::string::npos) << read->offsets_path;
    ASSERT_TRUE(offsets::write_offsets({read->offsets_path}, {kept}, read->request.profile.gcode));
    open_text("G21 G90 F300\nG0 X40 Z41 Y5\nG1 X38\nM2\n");
    window_->refresh();
    const QString facts = part<QLabel>("program_facts").text();
    EXPECT_TRUE(facts.contains(QString::fromUtf8("turned by −12.345°"))) << facts.toStdString();
    ASSERT_NO_FATAL_FAILURE(expect_fit("offsets"));
}

}  // namespace
}  // namespace psicarve::ui
