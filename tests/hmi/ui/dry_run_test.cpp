// SPDX-License-Identifier: GPL-3.0-or-later
// A dry run from the window: chosen, said, done, and nothing of it taken for carving.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMessageBox>
#include <QSpinBox>
#include <QTabWidget>
#include <QTimer>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/ports_page.hpp"
#include "hmi/ui/report_dialog.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

class DryRun : public WindowRig {
protected:
    void open_homed(const JobTable& job) {
        start_core();
        open_window();
        ASSERT_NO_FATAL_FAILURE(publish_job(job));
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
    }
    QString state_word() { return part<QWidget>("state_pill").accessibleName(); }
    bool is_over() { return machine_view().state() == S::ready && machine_view().status->job_end_tick != 0; }
};

TEST_F(DryRun, GoesThroughTheJobWithTheSpindleOffAndIsNotTakenForCarving) {
    ASSERT_NO_FATAL_FAILURE(open_homed(two_process::lobed_job(3, 40)));
    EXPECT_EQ(button("start").text(), "Start");
    button("dry_run").click();
    EXPECT_EQ(button("start").text(), "Start dry run");
    EXPECT_EQ(button("start").shortcut(), QKeySequence{"Ctrl+Return"});
    take_picture("dry_run_light");
    auto& ports = static_cast<PortsPage&>(part<QWidget>("ports_page"));
    ports.record_to(QString::fromStdString(file("dry.trace")));
    ASSERT_TRUE(comes_true([&] {
        return window_->context().pins.state() == session::PinRecorder::State::recording;
    })) << all_messages().toStdString();
    ASSERT_TRUE(click("start"));
    bool was_spindle_on = false;
    ASSERT_TRUE(comes_true([&] {
        was_spindle_on = was_spindle_on || machine_view().is_active(Signal::spindle);
        return machine_view().status->is_dry != 0 && is_over();
    })) << all_messages().toStdString();
    EXPECT_FALSE(was_spindle_on);
    EXPECT_EQ(machine_view().status->points_done, machine_view().status->points_total);
    ASSERT_TRUE(click("record_pins"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Pins recorded: "); }));
    EXPECT_FALSE(all_messages().contains("Verif")) << all_messages().toStdString();
    ASSERT_TRUE(click("report_button"));
    auto& report = static_cast<ReportDialog&>(part<QDialog>("report"));
    QStringList texts;
    for (const QLabel* label : report.findChildren<QLabel*>()) texts += label->text();
    EXPECT_TRUE(texts.contains("dry run to the last point: nothing was carved"));
    EXPECT_TRUE(texts.contains("no: a dry run carves nothing"));
}

TEST_F(DryRun, SaysItsStateAndGoesOnFromWhereItWaits) {
    ASSERT_NO_FATAL_FAILURE(open_homed(two_process::long_job()));
    button("dry_run").click();
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    ASSERT_TRUE(comes_true([&] { return state_word().startsWith("DRY RUN, Layer "); }))
        << state_word().toStdString();
    EXPECT_FALSE(machine_view().is_active(Signal::spindle));
    ASSERT_TRUE(comes_true([&] { return machine_view().status->layer > 2; }));
    window_->findChild<QTabWidget*>()->setCurrentIndex(2);
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("carving_point").text().startsWith("Layer "); }));
    EXPECT_FALSE(machine_view().resumable_layer);
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(part<QSpinBox>("layer").value(), 1) << "nothing was carved: the first layer is the next";
    button("dry_run").click();
    EXPECT_EQ(button("start").text(), "Start");
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_EQ(machine_view().status->is_dry, 0U);
    EXPECT_TRUE(machine_view().is_active(Signal::spindle));
    EXPECT_TRUE(comes_true([&] { return state_word().startsWith("CARVING, "); }));
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(DryRun, FromALayerIsAskedForAsWhatItWasWhenItWasAsked) {
    ASSERT_NO_FATAL_FAILURE(open_homed(two_process::lobed_job(5, 40)));
    button("dry_run").click();
    part<QSpinBox>("layer").setValue(3);
    QString question;
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, [&] {
        auto* const box = qobject_cast<QMessageBox*>(open_dialog());
        if (box == nullptr) return;
        hand.stop();
        question = box->text();
        button("dry_run").click();  // the window is not shut out
        EXPECT_EQ(box->buttons().front()->text(), "Start dry run from layer 3");
        box->buttons().front()->click();
    });
    hand.start(1);
    ASSERT_TRUE(click("from_layer"));
    EXPECT_TRUE(question.startsWith("Dry run from layer 3: ")) << question.toStdString();
    ASSERT_TRUE(comes_true([&] { return is_over(); })) << all_messages().toStdString();
    EXPECT_EQ(machine_view().status->is_dry, 1U);
}

}  // namespace
}  // namespace psicarve::ui
