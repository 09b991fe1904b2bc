// SPDX-License-Identifier: GPL-3.0-or-later
// A job that ended within a layer goes on with its last good point, with the layer's begin, or wherever the
// operator wants it to.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <QSpinBox>
#include <QTest>

#include <string>

#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/ui/fit_rig.hpp"
#include "tests/hmi/ui/hands_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class GoingOnWithin : public test::HandsRig {
protected:
    QString label(const char* name) { return part<QLabel>(name).text(); }
    /// Behind some layers, and within the next one, as after a stop there.
    void stop_within() {
        start_core();
        open_in_front();
        ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
        ASSERT_TRUE(comes_true([&] { return machine_view().resumable_layer.value_or(0) >= 3; }));
        ASSERT_TRUE(click("stop"));
        ASSERT_TRUE(comes_to(S::ready));
        ASSERT_NO_FATAL_FAILURE(leave_point(56));
    }
    /// Wherever it was stopped: at this point, from 0.
    void leave_point(std::uint32_t point) {
        const auto known = read_record(segment_->header().checkpoint);
        ASSERT_TRUE(known);
        layer_ = known->next_layer;
        segment_->header().reached_point.store(reached_word(known->job_checksum, layer_, point));
        ASSERT_TRUE(comes_true([&] { return machine_view().resumable_point == point; }));
    }
    bool waits_or_carves() {
        return comes_true([&] {
            const S state = machine_view().state();
            return state == S::positioning || state == S::waiting || state == S::carving;
        });
    }
    QString place() const { return QString{"layer %1, point 57"}.arg(layer_ + 1); }

    std::uint32_t layer_ = 0;
};

TEST_F(GoingOnWithin, TheMainButtonGoesOnWithTheLastGoodPoint) {
    ASSERT_NO_FATAL_FAILURE(stop_within());
    ASSERT_TRUE(comes_true([&] { return button("start").text() == "Continue from " + place(); }))
        << button("start").text().toStdString();
    EXPECT_EQ(button("motion_start").text(), "Continue from " + place());
    EXPECT_TRUE(label("unfinished_details")
                    .startsWith(QString{"Last good: layer %1, to its point 57. "}.arg(layer_ + 1)))
        << label("unfinished_details").toStdString();
    EXPECT_EQ(button("continue_layer").text(), QString{"Continue from layer %1"}.arg(layer_ + 1));
    take_picture("unfinished_within_light");
    const auto job = window_->context().open_job.core_job();
    ASSERT_TRUE(job);
    press_key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(comes_to(S::carving)) << all_messages().toStdString();
    // Where the carving began is written in the core's words.
    EXPECT_TRUE(all_messages().contains("Start from " + place())) << all_messages().toStdString();
    EXPECT_GE(machine_view().status->points_done, layer_ * std::uint64_t{job->view.point_count()} + 57);
}

TEST_F(GoingOnWithin, BesideItTheLayersBegin) {
    ASSERT_NO_FATAL_FAILURE(stop_within());
    ASSERT_TRUE(comes_true([&] { return button("continue_layer").isVisible(); }));
    ASSERT_TRUE(click("continue_layer"));
    ASSERT_TRUE(comes_to(S::carving)) << all_messages().toStdString();
    EXPECT_FALSE(all_messages().contains("point 57")) << all_messages().toStdString();
    EXPECT_FALSE(part<QWidget>("unfinished").isVisible());
}

TEST_F(GoingOnWithin, AnyPointOfAnyLayerIsAskedForWithTheWayThere) {
    ASSERT_NO_FATAL_FAILURE(stop_within());
    auto& layer = part<QSpinBox>("layer");
    auto& point = part<QSpinBox>("point");
    ASSERT_TRUE(comes_true([&] { return point.isEnabled() && point.maximum() > 100; }));
    EXPECT_EQ(point.text(), QString::fromUtf8("–")) << "the layer's begin";
    layer.setValue(3);
    point.setValue(21);
    layer.setValue(2);
    EXPECT_EQ(point.value(), 0) << "it was of another layer";
    point.setValue(21);
    QString question;
    QString go;
    const auto answer = [&](const char* name) {
        return [&, name](QDialog& dialog) {
            question = dynamic_cast<QMessageBox&>(dialog).text();
            go = dialog.findChild<QAbstractButton*>("from_layer_go")->text();
            test::keep_picture(dialog, "from_point_question_light");
            QTest::mouseClick(dialog.findChild<QAbstractButton*>(name), Qt::LeftButton);
        };
    };
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("from_layer")); }, {answer("from_layer_cancel")}));
    EXPECT_TRUE(question.contains("Then: heads out, Ψ to ")) << question.toStdString();
    EXPECT_EQ(go, "Start from layer 2, point 21");
    EXPECT_EQ(machine_view().state(), S::ready);
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("one_layer")); }, {answer("from_layer_go")}));
    ASSERT_TRUE(waits_or_carves()) << all_messages().toStdString();
    // The machine may be seen at work before the order's answer is.
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("Start from layer 2, point 21"); }))
        << all_messages().toStdString();
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(machine_view().resumable_point, 56U) << "that layer was carved before: the place stays";
}

// The layer's number stays where both begin with the first.
TEST_F(GoingOnWithin, ThePointInItsBoxIsOfOneJobAlone) {
    start_core();
    open_in_front();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    auto& point = part<QSpinBox>("point");
    ASSERT_TRUE(comes_true([&] { return point.maximum() > 100; }));
    point.setValue(21);
    for (int look = 0; look < 3; ++look) QApplication::processEvents();
    window_->context().open_job.publish();
    ASSERT_TRUE(comes_to(session::OpenJobState::published));
    EXPECT_EQ(point.value(), 21) << "the same job";
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::lobed_job(30, 90)));
    EXPECT_TRUE(comes_true([&] { return point.maximum() == 90; }));
    EXPECT_EQ(part<QSpinBox>("layer").value(), 1);
    EXPECT_EQ(point.value(), 0);
}

class FitWithin : public Fit {};

TEST_P(FitWithin, WithAPieceThatEndedWithinALayer) {
    open_small();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    window_->context().machine.start(0, 2);
    ASSERT_TRUE(
        comes_true([&] { return machine_view().state() == S::ready && machine_view().resumable_layer; }));
    auto& record = segment_->header().checkpoint;
    const Checkpoint own = read_record(record).value_or(Checkpoint{});
    // As much of it as can be, in its longest words.
    const std::uint32_t count = own.layer_count;
    write_record(record, checkpoint_at(own.job_checksum, count - 2, count, count - 1, own.origin));
    segment_->header().reached_point.store(reached_word(own.job_checksum, count - 2, 198));
    ASSERT_TRUE(comes_true([&] { return machine_view().resumable_point == 198; }));
    part<QSpinBox>("layer").setValue(static_cast<int>(count));
    part<QSpinBox>("point").setValue(199);
    expect_fit("within");
    expect_panels_fit("within");
}

INSTANTIATE_TEST_SUITE_P(OfTheWindow, FitWithin,
                         ::testing::Values(Language::english, Language::chinese, Language::russian),
                         [](const auto& named) {
                             return std::string{kLanguages[static_cast<std::size_t>(named.param)].code};
                         });

}  // namespace
}  // namespace psicarve::ui
