// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever ended a job: what the window knows of it, and how it goes on.
#include <gtest/gtest.h>

#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <QSlider>
#include <QSpinBox>
#include <QTest>

#include <functional>
#include <stdexcept>
#include <string>

#include "shared/segment/checkpoint.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/ui/hands_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;
/// Of the long job.
constexpr int kLayers = two_process::kLongLayers;

class GoingOn : public test::HandsRig {
protected:
    QString label(const char* name) { return part<QLabel>(name).text(); }
    /// Somewhere behind the third layer of a long job.
    void carve_some_layers() {
        ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
        ASSERT_TRUE(comes_true([&] { return machine_view().resumable_layer.value_or(0) >= 3; }));
    }
    void kill_core() {
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
        ASSERT_TRUE(comes_true([&] { return !machine_view().is_heard(); }));
    }
    /// A window that sees nothing but what a core has left behind.
    void open_on_dead_core() {
        start_core();
        open_window();
        ASSERT_NO_FATAL_FAILURE(carve_some_layers());
        ASSERT_NO_FATAL_FAILURE(kill_core());
        window_.reset();
        open_in_front();
        ASSERT_TRUE(comes_true([&] { return machine_view().resumable_layer.has_value(); }));
    }
    /// The first of forty.
    void carve_of_forty(std::uint32_t layers) {
        publish_job(two_process::lobed_job(40, 40));
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
        window_->context().machine.start(0, layers);
        ASSERT_TRUE(comes_true([&] {
            return machine_view().state() == S::ready && machine_view().resumable_layer == layers;
        })) << all_messages().toStdString();
        ASSERT_TRUE(comes_true([&] { return part<QWidget>("unfinished").isVisible(); }));
    }
    /// As another run of the same job would.
    void leave_checkpoint(std::uint32_t next_layer, std::uint32_t earlier_layer) {
        auto& record = segment_->header().checkpoint;
        const auto before = read_record(record);
        ASSERT_TRUE(before);
        write_record(record,
                     checkpoint_at(before->job_checksum, next_layer, before->layer_count, earlier_layer));
    }
    static QAbstractButton& button_of(QDialog& dialog, const char* name) {
        auto* const found = dialog.findChild<QAbstractButton*>(name);
        if (found == nullptr) throw std::runtime_error{std::string{"no "} + name};
        return *found;
    }
    void home_on_new_core() {
        start_core();
        ASSERT_TRUE(click("home")) << all_messages().toStdString();
        ASSERT_TRUE(comes_to(S::ready));
    }
};

TEST_F(GoingOn, FillsInTheLayerOfAWindowThatWasOpenedOnADeadCore) {
    ASSERT_NO_FATAL_FAILURE(open_on_dead_core());
    const int next = static_cast<int>(*machine_view().resumable_layer) + 1;
    ASSERT_NO_FATAL_FAILURE(home_on_new_core());
    ASSERT_TRUE(comes_true([&] { return part<QSpinBox>("layer").maximum() == kLayers; }));
    EXPECT_TRUE(
        comes_true([&] { return part<QSpinBox>("layer").value() == next; }, two_process::milliseconds{2000}))
        << part<QSpinBox>("layer").value() << " of " << next;
}

TEST_F(GoingOn, KnowsTheJobOfACoreThatIsNoMore) {
    ASSERT_NO_FATAL_FAILURE(open_on_dead_core());
    ASSERT_TRUE(comes_true([&] { return window_->context().open_job.job() != nullptr; }))
        << all_messages().toStdString();
    EXPECT_EQ(window_->context().open_job.job()->view.layer_count(), two_process::kLongLayers);
    EXPECT_TRUE(comes_true([&] {
        return part<QSpinBox>("layer").value() == static_cast<int>(*machine_view().resumable_layer) + 1;
    }));
    EXPECT_FALSE(button("publish").isEnabled());
    ASSERT_NO_FATAL_FAILURE(home_on_new_core());
    EXPECT_TRUE(comes_to(session::OpenJobState::published)) << "it is the job that the new core has taken";
}

TEST_F(GoingOn, ShowsNoAxisOfADeadCoreAsHomed) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_some_layers());
    EXPECT_EQ(label("homed_r1"), "homed");
    ASSERT_NO_FATAL_FAILURE(kill_core());
    for (const Axis axis : kAllAxes) {
        const std::string name{name_of(axis)};
        EXPECT_EQ(label(("homed_" + name).c_str()), "home ?") << name;
        EXPECT_EQ(part<QLabel>(("homed_" + name).c_str()).property("lamp").toString(), "unsure") << name;
        const QString sensor = label(("sensor_" + name).c_str());
        EXPECT_TRUE(sensor.startsWith('?')) << name << ": " << sensor.toStdString();
        EXPECT_EQ(part<QLabel>(("sensor_" + name).c_str()).property("lamp").toString(), "off") << name;
    }
    take_picture("lamps_of_dead_core_light");
    start_core();
    ASSERT_TRUE(comes_true([&] { return label("sensor_r1") == QString::fromUtf8("○ limit"); }));
}

TEST_F(GoingOn, NoKeyReachesTheFeedOverride) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    auto& slider = part<QSlider>("override");
    ASSERT_TRUE(comes_true([&] { return slider.isEnabled(); }));
    button("start").setFocus(Qt::TabFocusReason);
    for (int i = 0; i < 60; ++i) {
        press_key(Qt::Key_Tab);
        ASSERT_FALSE(slider.hasFocus()) << "after " << i + 1 << " tabs";
    }
    QTest::mouseClick(&slider, Qt::LeftButton, {}, slider.rect().center());
    EXPECT_FALSE(slider.hasFocus());
    slider.setFocus();  // whatever gave it the focus
    for (const Qt::Key key :
         {Qt::Key_Right, Qt::Key_Up, Qt::Key_PageUp, Qt::Key_End, Qt::Key_Left, Qt::Key_Home})
        QTest::keyClick(&slider, key);
    EXPECT_TRUE(comes_true([&] { return !window_->context().machine.is_override_under_way(); }));
    EXPECT_EQ(slider.value(), 100);
    EXPECT_EQ(machine_view().status->override_percent, 100U);
    press_key(Qt::Key_Plus, Qt::ControlModifier);  // has keys of its own
    ASSERT_TRUE(comes_true([&] { return machine_view().status->override_percent == 105; }));
    EXPECT_TRUE(comes_true([&] { return label("reason").contains("Feed override: 105 %"); }))
        << label("reason").toStdString();
    ASSERT_TRUE(click("full"));
    EXPECT_TRUE(comes_true([&] { return machine_view().status->override_percent == 100; }));
}

TEST_F(GoingOn, ContinuesByItsButtonAndItsKeyAsTheySay) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(carve_some_layers());
    EXPECT_EQ(button("start").text(), "Start") << "while it is carved";
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    const std::uint32_t next = *machine_view().resumable_layer;
    const auto point = machine_view().resumable_point;
    const QString says = point ? QString{"Continue from layer %1, point %2"}.arg(next + 1).arg(*point + 1)
                               : QString{"Continue from layer %1"}.arg(next + 1);
    // In two lines where it is too long for one.
    const auto text_of = [this](const char* name) { return button(name).text().replace(",\n", ", "); };
    ASSERT_TRUE(comes_true([&] { return text_of("start") == says; })) << text_of("start").toStdString();
    EXPECT_EQ(text_of("motion_start"), says);
    EXPECT_TRUE(part<QWidget>("unfinished").isVisible());
    EXPECT_EQ(label("unfinished_title"),
              QString{"Unfinished: %1 of %2 layers are carved"}.arg(next).arg(kLayers));
    const QString good = QString{"Last good: layer %1, to its point %2. "};
    EXPECT_TRUE(label("unfinished_details")
                    .startsWith(point ? good.arg(next + 1).arg(*point + 1) : good.arg(next).arg(201)))
        << label("unfinished_details").toStdString();
    EXPECT_TRUE(label("unfinished_details").contains("Then: heads out, Ψ to "))
        << label("unfinished_details").toStdString();
    take_picture("unfinished_light");
    ASSERT_TRUE(comes_true([&] { return button("start").isEnabled(); }));
    press_key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(comes_to(S::carving)) << all_messages().toStdString();
    EXPECT_GE(machine_view().status->layer, next);
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    const std::uint32_t later = *machine_view().resumable_layer;
    EXPECT_GE(later, next);
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_GE(machine_view().status->layer, later);
}

TEST_F(GoingOn, BeginsAnewOnlyOnceItWasAsked) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(carve_some_layers());
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    const std::uint32_t carved = *machine_view().resumable_layer;
    const std::uint64_t started = machine_view().status->job_start_tick;
    QString question;
    QSize picture;
    const auto answers = [&](const char* name) {
        return [&, name](QDialog& dialog) {
            auto& box = dynamic_cast<QMessageBox&>(dialog);
            question = box.text();
            picture = box.iconPixmap().size();
            test::keep_picture(box, "anew_question_light");
            QTest::mouseClick(dialog.findChild<QAbstractButton*>(name), Qt::LeftButton);
        };
    };
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("start_anew")); }, {answers("anew_cancel")}));
    EXPECT_TRUE(question.startsWith(
        QString{"Layers 1 to %1 of %2 are carved and would be carved again."}.arg(carved).arg(kLayers)))
        << question.toStdString();
    EXPECT_FALSE(picture.isEmpty());
    part<QSpinBox>("layer").setValue(1);  // what comes to the same
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("from_layer")); }, {answers("anew_cancel")}));
    EXPECT_TRUE(comes_true([&] { return !window_->context().machine.has_orders(); }));
    EXPECT_EQ(machine_view().status->job_start_tick, started) << "nothing was started";
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("start_anew")); }, {answers("anew_go")}));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_NE(machine_view().status->job_start_tick, started);
    ASSERT_TRUE(click("hold"));  // however busy the computer is, it does not pass the layers of before
    EXPECT_TRUE(comes_true([&] {
        return machine_view().earlier_layer == carved || machine_view().resumable_layer.value_or(0) >= carved;
    })) << carved;
}

TEST_F(GoingOn, SaysNothingOfAnotherJobThatIsOpenWithoutACore) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_of_forty(4));
    ASSERT_NO_FATAL_FAILURE(kill_core());
    EXPECT_TRUE(comes_true([&] { return button("start").text() == "Continue from layer 5"; }))
        << button("start").text().toStdString();
    const auto opens = [&](const JobTable& table, const char* name) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, file(name)));
        const std::uint64_t edition = window_->context().open_job.edition();
        window_->open(QString::fromStdString(file(name)));
        ASSERT_TRUE(comes_true([&] { return window_->context().open_job.edition() != edition; }));
        ASSERT_TRUE(comes_to(session::OpenJobState::job));
    };
    opens(two_process::lobed_job(40, 44), "other.job");  // as many layers
    EXPECT_TRUE(comes_true([&] { return button("start").text() == "Start"; }))
        << button("start").text().toStdString();
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
    opens(two_process::lobed_job(40, 40), "same.job");
    EXPECT_TRUE(comes_true([&] { return button("start").text() == "Continue from layer 5"; }));
    EXPECT_TRUE(comes_true([&] { return part<QWidget>("unfinished").isVisible(); }));
}

TEST_F(GoingOn, StartsADryRunAnewThatWasChosenBeforeItWasAsked) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_of_forty(4));
    button("dry_run").click();
    QString question;
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("start_anew")); }, {[&](QDialog& dialog) {
                             question = dynamic_cast<QMessageBox&>(dialog).text();
                             button("dry_run").click();  // the window is not shut out
                             button_of(dialog, "anew_go").click();
                         }}));
    EXPECT_TRUE(question.startsWith("Dry run from layer 1: ")) << question.toStdString();
    ASSERT_TRUE(comes_true([&] { return machine_view().status->is_dry == 1; }))
        << all_messages().toStdString();
    EXPECT_EQ(machine_view().resumable_layer, 4U) << "nothing is cut";
}

TEST_F(GoingOn, AsksBeforeItBeginsAnewThoughNoLayerIsFinished) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_of_forty(4));
    leave_checkpoint(0, 4);
    ASSERT_TRUE(comes_true([&] { return label("unfinished_title").startsWith("Begun anew"); }))
        << label("unfinished_title").toStdString();
    const std::uint64_t started = machine_view().status->job_start_tick;
    part<QSpinBox>("layer").setValue(1);
    for (const char* name : {"start_anew", "from_layer"}) {
        QString question;
        EXPECT_TRUE(answered([&] { EXPECT_TRUE(click(name)); }, {[&](QDialog& dialog) {
                                 question = dynamic_cast<QMessageBox&>(dialog).text();
                                 button_of(dialog, "anew_cancel").click();
                             }}))
            << name;
        EXPECT_TRUE(question.startsWith("The run before came to layer 4 of 40: ")) << question.toStdString();
    }
    EXPECT_TRUE(comes_true([&] { return !window_->context().machine.has_orders(); }));
    EXPECT_EQ(machine_view().status->job_start_tick, started) << "nothing was started";
}

TEST_F(GoingOn, AQuestionIsClosedOnceItIsAboutAnotherPieceOrTheMachineLeavesRest) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_of_forty(4));
    const std::uint64_t started = machine_view().status->job_start_tick;
    const auto is_closed_by = [&](const char* name, const std::function<void()>& change) {
        bool is_closed = false;
        EXPECT_TRUE(answered([&] { EXPECT_TRUE(click(name)); }, {[&](QDialog& dialog) {
                                 change();
                                 is_closed = comes_true([&] { return !dialog.isVisible(); });
                             }}));
        return is_closed;
    };
    for (const char* name : {"start_anew", "from_layer"}) {
        part<QSpinBox>("layer").setValue(3);
        leave_checkpoint(4, 0);
        ASSERT_TRUE(comes_true([&] { return machine_view().resumable_layer == 4; }));
        EXPECT_TRUE(is_closed_by(name, [&] { leave_checkpoint(7, 0); })) << name;
        ASSERT_TRUE(comes_true([&] { return button(name).isEnabled(); }));
        EXPECT_TRUE(is_closed_by(name, [&] { window_->context().open_job.publish(); })) << name;
        ASSERT_TRUE(comes_true([&] { return button(name).isEnabled(); })) << name;
    }
    part<QSpinBox>("layer").setValue(3);
    EXPECT_TRUE(is_closed_by("from_layer", [&] { request_emergency_stop(*segment_); }));
    EXPECT_EQ(machine_view().status->job_start_tick, started) << "nothing was started";
}

TEST_F(GoingOn, TheNextPieceThatComesAsFarIsNotDismissed) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_of_forty(4));
    ASSERT_TRUE(click("unfinished_dismiss"));
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
    leave_checkpoint(40, 0);  // it was carved to its end
    ASSERT_TRUE(comes_true([&] { return !machine_view().resumable_layer; }));
    window_->context().machine.start(0, 4);
    ASSERT_TRUE(comes_true(
        [&] { return machine_view().state() == S::ready && machine_view().resumable_layer == 4; }));
    EXPECT_TRUE(comes_true([&] { return part<QWidget>("unfinished").isVisible(); }));
}

TEST_F(GoingOn, TellsWhereTheRunBeforeASlipCameTo) {
    start_core();
    open_window();
    publish_job(two_process::lobed_job(40, 40));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    const auto carve = [&](std::uint32_t layers) {
        window_->context().machine.start(0, layers);
        ASSERT_TRUE(comes_true([&] {
            return machine_view().state() == S::ready && machine_view().resumable_layer == layers;
        })) << all_messages().toStdString();
    };
    carve(9);
    EXPECT_FALSE(label("unfinished_details").contains("run before"));
    carve(2);
    ASSERT_TRUE(comes_true([&] {
        return label("unfinished_details").contains("From layer 10 goes on with it.");
    })) << label("unfinished_details").toStdString();
    EXPECT_EQ(button("start").text(), "Continue from layer 3");
}

TEST_F(GoingOn, IsDismissedUntilMoreIsCarved) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(carve_some_layers());
    kill_core();
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible()) << "the red one says it";
    EXPECT_TRUE(button("start").text().startsWith("Continue from layer "))
        << button("start").text().toStdString();
    start_core();
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("unfinished").isVisible(); }));
    EXPECT_TRUE(comes_true([&] {
        return label("unfinished_details").contains("First Home all: R1 R2 Ψ Y are not homed.");
    })) << label("unfinished_details").toStdString();
    take_picture("unfinished_new_core_light");
    ASSERT_TRUE(click("unfinished_dismiss"));
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
    ASSERT_TRUE(click("start"));
    const std::uint32_t before = *machine_view().resumable_layer;
    ASSERT_TRUE(comes_true([&] { return machine_view().resumable_layer.value_or(0) > before; }));
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(comes_true([&] { return part<QWidget>("unfinished").isVisible(); }));
}

}  // namespace
}  // namespace psicarve::ui
