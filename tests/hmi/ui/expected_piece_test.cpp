// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool will leave, looked at before it is carved.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QSpinBox>

#include "hmi/ui/mesh_view.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;

class ExpectedPiece : public test::WindowRig {
protected:
    void open_owl() { open(QString::fromStdString(example("figurine.stl"))); }
    void open_small() { open(QString::fromStdString(example("small.stl"))); }
    void open(const QString& path) {
        open_window();
        window_->open(path);
        ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
        window_->refresh();
    }
    void take_ball() { part<QComboBox>("tool").setCurrentIndex(2); }
    void slice(int layers = 60, int points = 60) {
        part<QSpinBox>("layers").setValue(layers);
        part<QSpinBox>("points").setValue(points);
        ASSERT_TRUE(click("slice"));
        ASSERT_TRUE(comes_to(OpenJobState::job)) << all_messages().toStdString();
    }
    QString facts() { return part<QLabel>("piece_facts").text(); }
    bool tells(const QString& wanted) {
        return comes_true([&] { return facts().contains(wanted); }, two_process::milliseconds{60'000});
    }
    std::shared_ptr<const session::MeshScene> shown_scene() {
        const auto& bodies = part<MeshView>("model_view").picture().bodies;
        return bodies.empty() ? nullptr : bodies.front().scene;
    }
};

TEST_F(ExpectedPiece, OfAJobIsShownBesideItsModelColouredByItsDeviation) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    EXPECT_FALSE(button("view_piece").isEnabled()) << "a point leaves nothing";
    EXPECT_TRUE(button("view_piece").toolTip().contains("slice first"));
    take_ball();
    ASSERT_NO_FATAL_FAILURE(slice());
    const auto model = shown_scene();
    EXPECT_FALSE(part<QLabel>("piece_facts").isVisible());
    ASSERT_TRUE(click("view_piece"));
    ASSERT_TRUE(tells("Left over ")) << facts().toStdString();
    EXPECT_TRUE(facts().contains("Within a pulse")) << facts().toStdString();
    EXPECT_FALSE(facts().contains("Draft")) << facts().toStdString();
    EXPECT_FALSE(part<QProgressBar>("piece_progress").isVisible());
    const auto piece = shown_scene();
    ASSERT_TRUE(piece);
    EXPECT_NE(piece, model);
    EXPECT_GT(piece->vertex_rgb.size(), 10'000U);
    take_picture("expected_piece_light");
    window_->set_theme(ThemeChoice::dark);
    window_->refresh();
    take_picture("expected_piece_dark");
    ASSERT_TRUE(click("view_model"));
    window_->refresh();
    ASSERT_TRUE(comes_true([&] { return shown_scene() && shown_scene()->size[2] < 53.0; }));
    EXPECT_FALSE(part<QLabel>("piece_facts").isVisible());
}

TEST_F(ExpectedPiece, IsADraftBeforeTheModelIsSlicedAndTheJobsAfterwards) {
    ASSERT_NO_FATAL_FAILURE(open_small());
    take_ball();
    ASSERT_TRUE(click("view_piece"));
    ASSERT_TRUE(tells("Draft, of samples")) << facts().toStdString();
    take_picture("expected_draft_light");
    const auto draft = shown_scene();
    part<QDoubleSpinBox>("tool_diameter").setValue(6.0);
    ASSERT_TRUE(comes_true([&] { return shown_scene() != draft && facts().contains("Draft"); },
                           two_process::milliseconds{60'000}))
        << facts().toStdString();
    ASSERT_NO_FATAL_FAILURE(slice());
    ASSERT_TRUE(comes_true([&] { return facts().contains("Left over") && !facts().contains("Draft"); },
                           two_process::milliseconds{60'000}))
        << facts().toStdString();
    window_->open(QString::fromStdString(example("letter.stl")));
    ASSERT_TRUE(comes_true([&] { return button("view_model").isChecked(); }));
}

TEST_F(ExpectedPiece, CanBeCancelled) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    take_ball();
    const int many = psicarve::test::is_thorough() ? 400 : 160;
    ASSERT_NO_FATAL_FAILURE(slice(many, many));
    button("view_piece").click();
    window_->refresh();
    ASSERT_TRUE(part<QProgressBar>("piece_progress").isVisible());
    EXPECT_FALSE(shown_scene()) << "nothing that is not the piece";
    button("piece_cancel").click();
    window_->refresh();
    EXPECT_EQ(facts(), "Working the piece out was cancelled");
    ASSERT_TRUE(click("view_model"));
    EXPECT_TRUE(shown_scene());
}

TEST_F(ExpectedPiece, OfAJobThatWasOpenedHasNoModelToBeComparedWith) {
    ASSERT_NO_FATAL_FAILURE(open_small());
    take_ball();
    ASSERT_NO_FATAL_FAILURE(slice());
    const auto job = window_->context().open_job.job();
    Snapshot snapshot;
    snapshot.job_blob = job->blob;
    ASSERT_TRUE(save_snapshot(snapshot, file("owl.job")));
    window_->open(QString::fromStdString(file("owl.job")));
    ASSERT_TRUE(comes_true([&] {
        return !window_->context().open_job.mesh() && window_->context().open_job.job();
    })) << all_messages().toStdString();
    ASSERT_TRUE(click("view_piece"));
    ASSERT_TRUE(tells("nothing to compare the piece with")) << facts().toStdString();
    EXPECT_TRUE(shown_scene());
}

}  // namespace
}  // namespace psicarve::ui
