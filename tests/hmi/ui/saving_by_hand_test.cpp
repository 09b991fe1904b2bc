// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons that ask where to save, that end what is under way, and some others, pressed with the mouse.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>

#include <array>
#include <cmath>
#include <fstream>

#include "shared/trace/trace_format.hpp"
#include "tests/hmi/replay/recorded_run.hpp"
#include "tests/hmi/ui/hands_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;
using S = MachineState;

class SavingByHand : public replay::test::RecordedOn<test::HandsRig> {
protected:
    QByteArray content_of(const std::string& name) const {
        QFile saved{QString::fromStdString(file(name))};
        return saved.open(QIODevice::ReadOnly) ? saved.readAll() : QByteArray{};
    }
    bool is_told(const QString& text) {
        return comes_true([&] { return all_messages().contains(text); });
    }
    std::int64_t pulses(Axis axis) { return machine_view().status->position_pulses[index_of(axis)]; }
    /// Of one pin that goes up and down for `count` ticks, and of no end.
    void write_long_trace(const std::string& path, std::size_t count) {
        TraceHeader header{};
        header.magic = kTraceMagic;
        header.version = kTraceVersion;
        header.period_ns = 20'000;
        std::string text(reinterpret_cast<const char*>(&header), sizeof header);
        std::array<std::uint8_t, kLeb128MaxBytes> word{};
        const auto* const end = encode_leb128(word.data(), 1);
        std::string record(1, static_cast<char>(trace_record_head(1, TraceRecordKind::pins)));
        record.append(reinterpret_cast<const char*>(word.data()),
                      static_cast<std::size_t>(end - word.data()));
        for (std::size_t i = 0; i < count; ++i) text += record;
        std::ofstream(path, std::ios::binary) << text;
    }
};

TEST_F(SavingByHand, KeepsLogBundleAndReport) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::lobed_job(3, 40)));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_true([&] { return window_->context().runs.is_over(); }))
        << all_messages().toStdString();
    show_page("messages_page");
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("save_log")); }, file("kept.log")));
    ASSERT_TRUE(is_told("Log saved: ")) << all_messages().toStdString();
    EXPECT_TRUE(content_of("kept.log").contains("Job no. 1 accepted"))
        << content_of("kept.log").toStdString();
    ASSERT_TRUE(QDir{}.mkdir(QString::fromStdString(file("bundles"))));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("save_bundle")); }, file("bundles")));
    ASSERT_TRUE(is_told("Support bundle: ")) << all_messages().toStdString();
    const auto bundles = QDir{QString::fromStdString(file("bundles"))}.entryInfoList({"psicarve-support-*"});
    ASSERT_EQ(bundles.size(), 1) << "where it was asked for";
    EXPECT_TRUE(QDir{bundles.front().filePath()}.exists("snapshot.psi"));
    ASSERT_TRUE(click("report_button"));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("report_save")); }, file("report.json")));
    ASSERT_TRUE(is_told("report.json")) << all_messages().toStdString();
    EXPECT_EQ(QJsonDocument::fromJson(content_of("report.json")).object()["layers"].toInt(), 3);
    ASSERT_TRUE(click("report_close"));
    EXPECT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("report") == nullptr; }));
}

TEST_F(SavingByHand, SavesNothingWhenNobodyNamesAFile) {
    open_in_front();
    show_page("messages_page");
    const auto count = window_->context().log.count();
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("save_log")); }, ""));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("save_bundle")); }, ""));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("save_snapshot")); }, ""));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("open_action")); }, ""));
    window_->refresh();
    EXPECT_EQ(window_->context().log.count(), count) << all_messages().toStdString();
}

TEST_F(SavingByHand, KeepsAMeasurement) {
    open_in_front();
    const QByteArray path_before = qgetenv("PATH");
    qputenv("PATH", QByteArray::fromStdString(in_build("bin:")) + path_before);
    show_page("realtime_page");
    ASSERT_TRUE(click("show_measurement"));
    part<QSpinBox>("latency_seconds").setValue(1);
    part<QSpinBox>("latency_period").setValue(1000);
    ASSERT_TRUE(click("latency_begin"));
    EXPECT_TRUE(is_told("Measured ")) << all_messages().toStdString();
    qputenv("PATH", path_before);
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(click("latency_save")); }, file("late.csv")));
    ASSERT_TRUE(is_told("late.csv")) << all_messages().toStdString();
    EXPECT_TRUE(content_of("late.csv").startsWith("late_us,ticks\n"));
}

TEST_F(SavingByHand, EndsSlicingAndTheModelCanBeSlicedAgain) {
    open_in_front();
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    part<QSpinBox>("layers").setValue(4000);
    part<QSpinBox>("points").setValue(3201);  // as many as psi has pulses for
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(OpenJobState::slicing));
    ASSERT_TRUE(comes_true([&] { return button("cancel").isVisible(); }));
    ASSERT_TRUE(click("cancel"));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    EXPECT_EQ(window_->context().open_job.job(), nullptr);
    EXPECT_FALSE(button("cancel").isVisible());
    part<QSpinBox>("layers").setValue(10);
    part<QSpinBox>("points").setValue(40);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
}

TEST_F(SavingByHand, EndsTheReadingOfARecording) {
    write_long_trace(file("long.trace"), 10'000'000);
    open_in_front();
    window_->open(QString::fromStdString(file("long.trace")));
    ASSERT_TRUE(comes_true([&] { return button("replay_cancel").isVisible(); }));
    ASSERT_TRUE(click("replay_cancel"));
    ASSERT_TRUE(comes_true([&] { return !window_->context().replay.is_opening(); }));
    EXPECT_FALSE(window_->context().replay.is_open());
    EXPECT_TRUE(is_told("cancelled")) << all_messages().toStdString();
    EXPECT_FALSE(part<QWidget>("replay_bar").isVisible());
}

TEST_F(SavingByHand, TakesPresentPositionsIntoTheDialogOfAMove) {
    start_core();
    open_in_front();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(click("go_to"));
    auto& target = part<QDoubleSpinBox>("move_to_y");
    const double homed_mm = target.value();
    ASSERT_TRUE(click("jog_y_up"));
    ASSERT_TRUE(comes_true([&] { return machine_view().state() == S::ready && pulses(Axis::y) != 0; }));
    target.setValue(homed_mm + 7.0);
    EXPECT_TRUE(part<QCheckBox>("move_y").isChecked());
    ASSERT_TRUE(click("move_here"));
    const double now_mm = static_cast<double>(pulses(Axis::y)) / Profile{}.y.pulses_per_mm;
    EXPECT_NEAR(target.value(), now_mm, 0.001);
    EXPECT_FALSE(part<QCheckBox>("move_y").isChecked()) << "nothing is asked for yet";
}

TEST_F(SavingByHand, MovesBothHeadsOutTogether) {
    start_core();
    open_in_front();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    const auto r1 = pulses(Axis::r1);
    const auto r2 = pulses(Axis::r2);
    const auto step = std::llround(0.1 * Profile{}.r1.pulses_per_mm);
    const auto come_to = [&](std::int64_t pulses_in) {
        return comes_true([&] {
            return machine_view().state() == S::ready && pulses(Axis::r1) == r1 - pulses_in &&
                   pulses(Axis::r2) == r2 - pulses_in;
        });
    };
    ASSERT_TRUE(click("jog_heads_in"));
    ASSERT_TRUE(come_to(step)) << all_messages().toStdString();
    ASSERT_TRUE(click("jog_heads_out"));
    EXPECT_TRUE(come_to(0)) << pulses(Axis::r1) - r1 << " " << pulses(Axis::r2) - r2;
}

TEST_F(SavingByHand, ChoosesStepsOfAJog) {
    start_core();
    open_in_front();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    for (const char* unit : {"mm", "deg"}) {
        for (const char* step : {"0.01", "0.1", "1", "10", "90"}) {
            const std::string name = std::string{"jog_step_"} + step + "_" + unit;
            auto* const found = window_->findChild<QAbstractButton*>(QString::fromStdString(name));
            if (found == nullptr) continue;
            ASSERT_TRUE(click(name.c_str()));
            EXPECT_TRUE(found->isChecked()) << name;
        }
    }
    ASSERT_TRUE(click("jog_step_1_mm"));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    const auto from = pulses(Axis::y);
    ASSERT_TRUE(click("jog_y_up"));
    EXPECT_TRUE(comes_true([&] {
        return machine_view().state() == S::ready &&
               pulses(Axis::y) == from + std::llround(Profile{}.y.pulses_per_mm);
    }));
}

TEST_F(SavingByHand, DrivesAJobFromTheBlockOfASmallWindow) {
    start_core();
    open_in_front();
    window_->resize(800, 500);
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(button("motion_start").isVisible());
    ASSERT_TRUE(click("motion_start"));
    ASSERT_TRUE(comes_to(S::carving));
    ASSERT_TRUE(click("motion_hold"));
    ASSERT_TRUE(comes_to(S::held));
    ASSERT_TRUE(click("motion_resume"));
    ASSERT_TRUE(comes_to(S::carving));
    ASSERT_TRUE(click("motion_stop"));
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(SavingByHand, ChoosesTheSpeedOfARecording) {
    record();
    open_in_front();
    window_->open(QString::fromStdString(trace()));
    auto& desk = window_->context().replay;
    ASSERT_TRUE(comes_true([&] { return desk.is_open() && desk.is_settled(); }));
    const std::pair<const char*, double> speeds[] = {{"replay_speed_0.1", 0.1},
                                                     {"replay_speed_10", 10.0},
                                                     {"replay_speed_100", 100.0},
                                                     {"replay_speed_1", 1.0}};
    for (const auto& [name, speed] : speeds) {
        ASSERT_TRUE(click(name));
        EXPECT_EQ(desk.clock().speed(), speed);
    }
}

TEST_F(SavingByHand, LeavesEverythingAsItIsWhenAQuestionIsCancelled) {
    start_core();
    open_in_front();
    const auto cancels = [this](const std::function<void()>& ask, const char* name) {
        return answered(ask, {[name](QDialog& dialog) {
                            auto* const no = dialog.findChild<QAbstractButton*>(name);
                            ASSERT_NE(no, nullptr) << name;
                            QTest::mouseClick(no, Qt::LeftButton);
                        }});
    };
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    ASSERT_TRUE(click("model_report_open"));
    ASSERT_TRUE(click("model_report_close"));
    EXPECT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("model_report") == nullptr; }));
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    part<QSpinBox>("layer").setValue(3);
    EXPECT_TRUE(cancels([&] { EXPECT_TRUE(click("from_layer")); }, "from_layer_cancel"))
        << all_messages().toStdString() << button("from_layer").toolTip().toStdString();
    EXPECT_EQ(machine_view().state(), S::ready);
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_TRUE(cancels([&] { window_->close(); }, "close_cancel"));
    EXPECT_TRUE(window_->isVisible());
    ASSERT_TRUE(comes_to(S::carving));
    edit("core_radius_mm", "1.7");
    EXPECT_TRUE(cancels([&] { window_->close(); }, "profile_keep"));
    EXPECT_TRUE(window_->isVisible());
    EXPECT_EQ(profile().draft().changed_count(), 1U);
}

TEST_F(SavingByHand, ClosesAsItIsAnswered) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
    const std::pair<const char*, S> answers[] = {
        {"close_leave_running", S::carving}, {"close_hold", S::held}, {"close_stop", S::ready}};
    for (const auto& [name, state] : answers) {
        EXPECT_TRUE(answered([&] { window_->close(); }, {[name = name](QDialog& dialog) {
                                 QTest::mouseClick(dialog.findChild<QAbstractButton*>(name), Qt::LeftButton);
                             }}));
        ASSERT_TRUE(comes_true([&] { return !window_->isVisible(); })) << name;
        EXPECT_TRUE(reaches(state)) << name;
        open_window();
        ASSERT_TRUE(comes_to(state)) << name;
    }
}

}  // namespace
}  // namespace psicarve::ui
