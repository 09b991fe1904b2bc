// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QString>
#include <QTabWidget>

#include <fstream>
#include <string>

#include "hmi/ui/program_path_view.hpp"
#include "hmi/ui/program_text_view.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/hmi/ui/hands_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui::test {

/// Its windows find `psicarve` where the build has it.
class ProgramRig : public HandsRig {
protected:
    ProgramRig() : path_before_(qgetenv("PATH")) {
        qputenv("PATH", QByteArray::fromStdString(in_build("bin:")) + path_before_);
    }
    ~ProgramRig() override { qputenv("PATH", path_before_); }

    program::ProgramDesk& desk() { return window_->context().program; }
    const ProgramStatus& running() { return window_->context().program_report.status; }
    ProgramTextView& text_view() { return static_cast<ProgramTextView&>(part<QWidget>("program_text")); }
    ProgramPathView& path_view() { return static_cast<ProgramPathView&>(part<QWidget>("program_path")); }
    std::string program(const std::string& text, const char* name = "part.ngc") {
        std::ofstream{file(name)} << text;
        return file(name);
    }
    bool is_read() {
        return comes_true([&] { return !desk().is_reading() && desk().program() != nullptr; });
    }
    ::testing::AssertionResult opens(const std::string& text) {
        window_->open(QString::fromStdString(program(text)));
        if (is_read()) return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure() << all_messages().toStdString();
    }
    void have_homed_window() {
        start_core();
        attach();
        open_in_front();
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(MachineState::ready));
    }
    ::testing::AssertionResult holds_in_line(std::uint64_t line, ProgramHold hold) {
        if (comes_true([&] {
                return machine_view().state() == MachineState::held && running().line == line &&
                       running().hold == hold;
            }))
            return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure()
               << "line " << running().line << ", " << name_of(running().hold) << ", "
               << name_of(machine_view().state()) << ": " << text_of("program_state").toStdString() << "\n"
               << all_messages().toStdString();
    }
    /// The command's process has ended, too.
    ::testing::AssertionResult is_over(bool is_done) {
        if (comes_true([&] {
                return desk().ended() && desk().ended()->is_done == is_done && !desk().is_under_way() &&
                       machine_view().state() == MachineState::ready;
            }))
            return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure() << text_of("program_state").toStdString() << "\n"
                                             << all_messages().toStdString();
    }
    double place(Axis axis) {
        return static_cast<double>(machine_view().status->position_pulses[index_of(axis)]) /
               axis_motion(Profile{}, axis).pulses_per_unit;
    }
    QString page_name() {
        const QWidget* const page = part<QTabWidget>("tabs").currentWidget();
        for (const char* name : {"program_page", "model_page"}) {
            if (page->isAncestorOf(window_->findChild<QWidget*>(name))) return name;
        }
        return {};
    }
    QString state_of_page() {
        window_->refresh();
        return text_of("program_state");
    }

private:
    QByteArray path_before_;
};

}  // namespace psicarve::ui::test
