// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line does besides carving, in the window: go to, spindle, recordings, verification, this
// computer.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <chrono>
#include <thread>

#include "hmi/ui/compare_tool.hpp"
#include "hmi/ui/latency_panel.hpp"
#include "hmi/ui/ports_page.hpp"
#include "hmi/ui/report_dialog.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

constexpr int kPorts = 3;
constexpr int kRealTime = 4;

class Tools : public WindowRig {
protected:
    void open_homed(const JobTable* job = nullptr) {
        start_core();
        open_window();
        window_->activateWindow();
        if (job != nullptr) publish_job(*job);
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
    }
    void show_page(int index) { window_->findChild<QTabWidget*>()->setCurrentIndex(index); }
    std::int64_t pulses(Axis axis) { return machine_view().status->position_pulses[index_of(axis)]; }
    void save_picture_of(const char* dialog, const char* name) {
        test::keep_picture(part<QDialog>(dialog), name);
    }
    CompareTool& compare_tool() { return static_cast<CompareTool&>(part<QObject>("compare_tool")); }
    PortsPage& ports() { return *static_cast<PortsPage*>(&part<QWidget>("ports_page")); }
};

TEST_F(Tools, GoToAPositionStraightAndOnAnArcAndSayWhatIsInTheWay) {
    open_homed();
    ASSERT_TRUE(click("go_to"));
    ASSERT_TRUE(comes_true([&] { return part<QDialog>("move_dialog").isVisible(); }));
    for (const char* axis : {"move_r1", "move_r2", "move_psi", "move_y"}) {
        EXPECT_TRUE(comes_true([&] { return button("move_go").toolTip() == "Go to: choose an axis"; }))
            << axis;
        button(axis).click();
        EXPECT_TRUE(comes_true([&] { return button("move_go").toolTip() != "Go to: choose an axis"; }))
            << axis;
        button(axis).click();
    }
    EXPECT_TRUE(comes_true([&] { return button("move_go").toolTip() == "Go to: choose an axis"; }));
    part<QDoubleSpinBox>("move_to_r1").setValue(30.0);
    part<QDoubleSpinBox>("move_to_y").setValue(20.0);
    EXPECT_TRUE(part<QCheckBox>("move_r1").isChecked()) << "who writes a position wants it";
    EXPECT_FALSE(part<QCheckBox>("move_r2").isChecked());
    ASSERT_TRUE(click("move_go"));
    ASSERT_TRUE(comes_true([&] { return pulses(Axis::y) == 8000 && machine_view().state() == S::ready; }))
        << all_messages().toStdString();
    EXPECT_EQ(pulses(Axis::r1), 12000);
    auto& shape = part<QComboBox>("move_shape");
    shape.setCurrentIndex(shape.findData(static_cast<int>(MoveShape::arc)));
    part<QDoubleSpinBox>("move_to_r1").setValue(20.0);
    part<QDoubleSpinBox>("move_to_y").setValue(30.0);
    part<QDoubleSpinBox>("move_centre_r1").setValue(20.0);
    part<QDoubleSpinBox>("move_centre_y").setValue(20.0);
    save_picture_of("move_dialog", "go_to_light");
    ASSERT_TRUE(click("move_go"));
    ASSERT_TRUE(comes_true([&] { return pulses(Axis::y) == 12000 && machine_view().state() == S::ready; }))
        << all_messages().toStdString();
    EXPECT_EQ(pulses(Axis::r1), 8000);
    button("move_psi").click();
    EXPECT_TRUE(
        comes_true([&] { return button("move_go").toolTip() == "Go to: Ψ moves in straight lines only"; }));
}

TEST_F(Tools, SwitchTheSpindleByHand) {
    open_homed();
    EXPECT_EQ(button("spindle").text(), "Start spindle");
    ASSERT_TRUE(click("spindle"));
    ASSERT_TRUE(comes_true([&] { return machine_view().is_active(Signal::spindle); }))
        << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return button("spindle").text() == "Stop spindle"; }));
    ASSERT_TRUE(click("spindle"));
    ASSERT_TRUE(comes_true([&] { return !machine_view().is_active(Signal::spindle); }));
}

TEST_F(Tools, RecordThePinsOfARunWhichIsThenVerifiedInItsReport) {
    const JobTable job = two_process::lobed_job(3, 40);
    open_homed(&job);
    show_page(kPorts);
    ASSERT_TRUE(comes_true([&] { return button("record_pins").isEnabled(); }));
    take_picture("ports_light");
    ports().record_to(QString::fromStdString(file("run.trace")));
    ASSERT_TRUE(comes_true([&] {
        return window_->context().pins.state() == session::PinRecorder::State::recording;
    })) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return button("record_pins").text() == "Stop recording"; }));
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Verified: the pins carve the job"); }))
        << all_messages().toStdString();
    EXPECT_GT(QFile{QString::fromStdString(file("run.trace"))}.size(), 1000);
    ASSERT_TRUE(click("report_button"));
    auto* const report = static_cast<ReportDialog*>(&part<QDialog>("report"));
    report->save(QString::fromStdString(file("report.json")));
    EXPECT_FALSE(all_messages().contains("report.json")) << "a disk that sleeps does not stop the window";
    ASSERT_TRUE(comes_true([&] {
        return all_messages().contains("Saved: " + QString::fromStdString(file("report.json")));
    })) << all_messages().toStdString();
    QFile saved{QString::fromStdString(file("report.json"))};
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    const QJsonObject object = QJsonDocument::fromJson(saved.readAll()).object();
    EXPECT_TRUE(object["verified"].toBool());
    EXPECT_TRUE(object["verification"].isObject());
}

TEST_F(Tools, JudgeARunOfWhichTheWindowSawOnlyTheEnd) {
    const JobTable job = two_process::lobed_job(3, 40);
    open_homed(&job);
    ports().record_to(QString::fromStdString(file("run.trace")));
    ASSERT_TRUE(comes_true(
        [&] { return window_->context().pins.state() == session::PinRecorder::State::recording; }));
    ASSERT_TRUE(click("start"));
    // A computer that is busy elsewhere: from the first layer on the window does nothing until the last is
    // carved.
    ASSERT_TRUE(comes_true([&] { return machine_view().status->points_done != 0; }))
        << all_messages().toStdString();
    const auto segment = Segment::attach(segment_name_);
    ASSERT_TRUE(segment.has_value());
    const auto given_up = std::chrono::steady_clock::now() + std::chrono::seconds{60};
    const auto is_over = [&] {
        const auto status = read_record(segment->header().status);
        return status && status->job_end_tick != 0;
    };
    while (!is_over() && std::chrono::steady_clock::now() < given_up)
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    ASSERT_TRUE(is_over());
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("Verified: the pins carve the job"); }))
        << all_messages().toStdString();
}

TEST_F(Tools, DoNotJudgeARunThatLeavesOutLayers) {
    const JobTable job = two_process::lobed_job(3, 40);
    open_homed(&job);
    ports().record_to(QString::fromStdString(file("part.trace")));
    ASSERT_TRUE(comes_true(
        [&] { return window_->context().pins.state() == session::PinRecorder::State::recording; }));
    window_->context().machine.start(1);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->job_end_tick != 0; }))
        << all_messages().toStdString();
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(window_->context().pins.state(), session::PinRecorder::State::recording)
        << "goes on until told";
    ASSERT_TRUE(click("record_pins"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Pins recorded: "); }))
        << all_messages().toStdString();
    EXPECT_FALSE(all_messages().contains("Verif")) << all_messages().toStdString();
}

TEST_F(Tools, RecordNothingWithoutAJobAndDoNotJudgeAJobThatWasStopped) {
    start_core();
    open_window();
    show_page(kPorts);
    ASSERT_TRUE(
        comes_true([&] { return button("record_pins").toolTip() == "Record pins: publish a job first"; }));
    publish_job(two_process::long_job());
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ports().record_to(QString::fromStdString(file("half.trace")));
    ASSERT_TRUE(comes_true(
        [&] { return window_->context().pins.state() == session::PinRecorder::State::recording; }));
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(click("record_pins"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Pins recorded: "); }))
        << all_messages().toStdString();
    EXPECT_FALSE(all_messages().contains("Verif"));
    EXPECT_TRUE(QFile::exists(QString::fromStdString(file("half.trace"))));
}

TEST_F(Tools, KeepSnapshotJobAndTables) {
    const JobTable job = two_process::lobed_job(3, 40);
    open_homed(&job);
    session::FileSaver& files = window_->context().files;
    files.save_snapshot(file("kept.snap"));
    files.save_job(file("kept.psi"), window_->context().open_job.job());
    files.save_tables(file("kept.csv"), window_->context().open_job.job());
    files.save_tables(file("nowhere/kept.csv"), window_->context().open_job.job());
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Not saved: "); }))
        << all_messages().toStdString();
    const auto snapshot = load_snapshot(file("kept.snap"));
    ASSERT_TRUE(snapshot);
    EXPECT_TRUE(snapshot->status);
    const auto saved = load_snapshot(file("kept.psi"));
    ASSERT_TRUE(saved);
    EXPECT_FALSE(saved->status);
    EXPECT_EQ(saved->job_blob, job_blob_from_table(job));
    QFile table{QString::fromStdString(file("kept.csv"))};
    ASSERT_TRUE(table.open(QIODevice::ReadOnly));
    EXPECT_EQ(table.readLine(), "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n");
    EXPECT_EQ(table.readAll().count('\n'), 3 * 40);
}

TEST_F(Tools, ShowWhatKeepsTheTickInTimeAndLookAtThisComputer) {
    start_core();
    open_window();
    show_page(kRealTime);
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    auto& table = part<QTableWidget>("computer_table");
    ASSERT_TRUE(comes_true([&] {
        return part<QLabel>("computer_note").text() == "On the virtual clock nothing has to be in time";
    }));
    EXPECT_EQ(table.rowCount(), 0);
    ASSERT_TRUE(click("check_computer"));
    ASSERT_TRUE(comes_true([&] { return table.rowCount() >= 10; }));
    EXPECT_EQ(table.item(3, 0)->text(), "kernel");
    take_picture("this_computer_light");
    ASSERT_TRUE(click("show_steps"));
    EXPECT_TRUE(comes_true([&] { return table.rowCount() == 0; }));
}

TEST_F(Tools, GoOnBehindTheCheckpointOfACoreThatIsNoMore) {
    const JobTable job = two_process::long_job();
    open_homed(&job);
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_true([&] { return machine_view().status->layer > 3; }));
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    start_core();
    ASSERT_TRUE(
        comes_true([&] { return machine_view().is_heard() && machine_view().status->job_start_tick == 0; }));
    ASSERT_TRUE(comes_true([&] { return machine_view().resumable_layer.has_value(); }))
        << all_messages().toStdString();
    const std::uint32_t resumable = *machine_view().resumable_layer;
    EXPECT_GE(resumable, 3U);
    ASSERT_TRUE(
        comes_true([&] { return part<QSpinBox>("layer").value() == static_cast<int>(resumable) + 1; }));
    EXPECT_TRUE(comes_true([&] {
        return button("from_layer")
                   .toolTip()
                   .endsWith(QString{"%1 was the last that was finished"}.arg(resumable)) ||
               !button("from_layer").isEnabled();
    }));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    window_->context().machine.start(resumable);
    ASSERT_TRUE(comes_to(S::carving)) << all_messages().toStdString();
    EXPECT_GE(machine_view().status->layer, resumable - 1);
}

TEST_F(Tools, TakeAPanelOutOfTheWindowAndPutItBack) {
    open_homed();
    auto* const panels = window_->findChild<QMenu*>("panels");
    ASSERT_NE(panels, nullptr);
    auto& key = button("jog_y_up");
    EXPECT_EQ(key.window(), window_.get());
    panels->actions()[1]->setChecked(true);
    ASSERT_NE(key.window(), window_.get());
    EXPECT_TRUE(key.isVisible());
    const auto from_pulses = pulses(Axis::y);
    ASSERT_TRUE(click("jog_y_up"));
    ASSERT_TRUE(comes_true([&] {
        return pulses(Axis::y) == from_pulses + 40 && machine_view().state() == S::ready;
    })) << all_messages().toStdString();
    QKeyEvent press{QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier};
    QApplication::sendEvent(key.window(), &press);
    ASSERT_TRUE(comes_to(S::alarm)) << "the emergency stop is in reach there, too";
    window_.reset();
    open_window();
    EXPECT_NE(button("jog_y_up").window(), window_.get()) << "it stays where it was put";
    button("jog_y_up").window()->close();
    EXPECT_TRUE(comes_true([&] { return button("jog_y_up").window() == window_.get(); }));
    EXPECT_FALSE(window_->findChild<QMenu*>("panels")->actions()[1]->isChecked());
    window_->findChild<QMenu*>("panels")->actions()[2]->setChecked(true);
    EXPECT_NE(button("start").window(), window_.get());
    window_->findChild<QAction*>("reset_layout")->trigger();
    EXPECT_EQ(button("start").window(), window_.get());
    EXPECT_TRUE(button("start").isVisible());
}

TEST_F(Tools, MeasureThisComputerAtLengthAndKeepTheFigures) {
    start_core();
    open_window();
    const QByteArray path_before = qgetenv("PATH");
    qputenv("PATH", QByteArray::fromStdString(in_build("bin:")) + path_before);
    show_page(kRealTime);
    ASSERT_TRUE(click("show_measurement"));
    EXPECT_FALSE(button("latency_end").isEnabled());
    EXPECT_FALSE(button("latency_save").isEnabled());
    part<QSpinBox>("latency_seconds").setValue(1);
    part<QSpinBox>("latency_period").setValue(1000);
    ASSERT_TRUE(click("latency_begin"));
    ASSERT_TRUE(comes_true([&] { return button("latency_begin").toolTip() == "Measure: under way"; }));
    EXPECT_FALSE(part<QSpinBox>("latency_seconds").isEnabled());
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Measured "); }))
        << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return button("latency_save").isEnabled(); }));
    take_picture("measured_light");
    EXPECT_EQ(
        static_cast<QScrollArea*>(part<QTabWidget>("tabs").currentWidget())->horizontalScrollBar()->maximum(),
        0)
        << "wider than the screen";
    auto& panel = static_cast<LatencyPanel&>(part<QWidget>("latency_panel"));
    panel.save(QString::fromStdString(file("late.csv")));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("late.csv"); }))
        << all_messages().toStdString();
    QFile saved{QString::fromStdString(file("late.csv"))};
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    EXPECT_EQ(saved.readLine(), "late_us,ticks\n");
    qputenv("PATH", path_before);
    publish_job(two_process::long_job());
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    ASSERT_TRUE(comes_true([&] {
        return button("latency_begin").toolTip() == "Measure: the machine is at work, and would be disturbed";
    }));
}

TEST_F(Tools, EndAMeasurementBeforeItsTime) {
    open_window();
    const QByteArray path_before = qgetenv("PATH");
    qputenv("PATH", QByteArray::fromStdString(in_build("bin:")) + path_before);
    show_page(kRealTime);
    ASSERT_TRUE(click("show_measurement"));
    part<QSpinBox>("latency_seconds").setValue(100'000);
    part<QSpinBox>("latency_period").setValue(1000);
    ASSERT_TRUE(click("latency_begin"));
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("latency_said").text().contains(" of 100000 s"); }));
    ASSERT_TRUE(click("latency_end"));
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("Measured "); }))
        << all_messages().toStdString();
    qputenv("PATH", path_before);
}

TEST_F(Tools, CompareTwoSnapshotsSideBySide) {
    Snapshot one;
    one.job_blob = job_blob_from_table(two_process::lobed_job(3, 40));
    Snapshot other;
    other.job_blob = job_blob_from_table(two_process::lobed_job(4, 40));
    ASSERT_TRUE(save_snapshot(one, file("one.psi")));
    ASSERT_TRUE(save_snapshot(other, file("other.psi")));
    open_window();
    compare_tool().compare(file("one.psi"), file("other.psi"));
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("differences") != nullptr; }))
        << all_messages().toStdString();
    auto& table = part<QTableWidget>("differences_table");
    ASSERT_GE(table.rowCount(), 1);
    EXPECT_EQ(table.item(0, 0)->text(), "layers");
    EXPECT_EQ(table.item(0, 1)->text(), "3");
    EXPECT_EQ(table.item(0, 2)->text(), "4");
    save_picture_of("differences", "differences_light");
    button("differences_close").click();
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("differences") == nullptr; }));
    compare_tool().compare(file("one.psi"), file("one.psi"));
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("differences") != nullptr; }));
    EXPECT_EQ(part<QLabel>("differences_said").text(), "one.psi and one.psi: nothing differs");
    EXPECT_NE(window_->findChild<QAction*>("compare_action"), nullptr);
}

}  // namespace
}  // namespace psicarve::ui
