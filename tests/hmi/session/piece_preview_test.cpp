// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/piece_preview.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/hmi/cam/built_job.hpp"

namespace psicarve::session {
namespace {

using namespace std::chrono_literals;

Profile ball_machine() {
    Profile profile;
    profile.tool = {ToolShape::ball, 3.0};
    return profile;
}

/// A cylinder that stands on another one: a ball leaves something in the corner between them.
std::shared_ptr<const model::Mesh> stepped_body() {
    auto mesh = std::make_shared<model::Mesh>(shapes::Builder()
                                                  .add(shapes::cylinder(9.0, 0.0, 4.0, 180))
                                                  .add(shapes::cylinder(6.0, 4.0, 8.0, 180))
                                                  .mesh());
    mesh->source_hash = 7;
    return mesh;
}

std::shared_ptr<const cam::PreparedJob> job_of(const model::Mesh& mesh, const Profile& profile) {
    const auto built = cam::built(mesh, profile, cam::small(24, 73));
    auto job = cam::prepare_blob(job_blob_from_table(built.table), profile, "test");
    EXPECT_TRUE(job) << (job ? "" : job.error().message);
    return std::make_shared<const cam::PreparedJob>(std::move(*job));
}

class PiecePreviewTest : public ::testing::Test {
protected:
    PieceRequest of_job() const { return {job_, mesh_, {}, {}}; }
    PieceRequest of_draft() const { return {nullptr, mesh_, profile_, {}}; }
    void poll(const std::optional<PieceRequest>& request, bool is_asked_for = true) {
        sut_.poll(request, plan_, is_asked_for);
    }
    bool is_told(const std::optional<PieceRequest>& request) {
        for (int i = 0; i < 60'000; ++i) {
            poll(request);
            if (!sut_.is_working()) return sut_.view() != nullptr;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }

    Profile profile_ = ball_machine();
    std::shared_ptr<const model::Mesh> mesh_ = stepped_body();
    std::shared_ptr<const cam::PreparedJob> job_ = job_of(*mesh_, profile_);
    PieceScenePlan plan_;
    PiecePreview sut_;
};

TEST_F(PiecePreviewTest, WorksNothingOutBeforeItIsAskedFor) {
    for (int i = 0; i < 3; ++i) poll(of_job(), false);
    EXPECT_FALSE(sut_.is_working());
    EXPECT_FALSE(sut_.view());
    poll(std::nullopt);
    EXPECT_FALSE(sut_.is_working()) << "there is nothing to be worked out";
}

TEST_F(PiecePreviewTest, TellsWhatAJobsToolLeavesOfItsModel) {
    ASSERT_TRUE(is_told(of_job())) << in_english(sut_.problem());
    const auto view = sut_.view();
    EXPECT_TRUE(view->has_model);
    EXPECT_FALSE(view->draft_allowance_mm);
    EXPECT_NEAR(view->deviation->leftover.max_mm, 1.5 * (1.0 - std::sqrt(0.5)), 0.2)
        << "layers of a third of a mm";
    EXPECT_NEAR(view->deviation->leftover.height_mm, 4.3, 0.7);
    poll(of_job(), false);
    poll(of_job());
    EXPECT_EQ(sut_.view(), view) << "nobody works it out twice";
    const auto another = job_of(*mesh_, profile_);
    poll(PieceRequest{another, mesh_, {}, {}}, false);
    EXPECT_FALSE(sut_.view()) << "another job leaves another piece";
}

TEST_F(PiecePreviewTest, HasNothingToCompareAJobWithWithoutItsModel) {
    ASSERT_TRUE(is_told(PieceRequest{job_, nullptr, {}, {}}));
    EXPECT_FALSE(sut_.view()->has_model);
    EXPECT_GT(sut_.view()->removed_mm3, 0.0);
}

TEST_F(PiecePreviewTest, DraftsBeforeThereIsAJob) {
    ASSERT_TRUE(is_told(of_draft())) << in_english(sut_.problem());
    const auto ball = sut_.view();
    ASSERT_TRUE(ball->draft_allowance_mm);
    EXPECT_NEAR(ball->deviation->leftover.max_mm, 1.5 * (1.0 - std::sqrt(0.5)), 0.3);
    PieceRequest flat = of_draft();
    flat.profile.tool.shape = ToolShape::flat;
    poll(flat, false);
    EXPECT_FALSE(sut_.view()) << "another tool leaves another piece";
    PieceRequest larger = of_draft();
    larger.options.scale = 2.0;
    EXPECT_FALSE(larger == of_draft());
    larger.options.scale.reset();
    larger.options.thread_count = 7;
    EXPECT_TRUE(larger == of_draft());
}

TEST_F(PiecePreviewTest, EndsWhenItIsToldToAndBeginsWhenItIsAskedForAgain) {
    poll(of_job());
    ASSERT_TRUE(sut_.is_working());
    sut_.cancel();
    EXPECT_FALSE(sut_.is_working());
    poll(of_job());
    EXPECT_FALSE(sut_.is_working()) << "it stays cancelled";
    EXPECT_EQ(in_english(sut_.problem()), "Working the piece out was cancelled");
    poll(of_job(), false);
    EXPECT_TRUE(is_told(of_job()));
    EXPECT_TRUE(sut_.problem().is_empty());
}

TEST_F(PiecePreviewTest, SaysWhyAPieceCannotBeWorkedOut) {
    auto other = std::make_shared<model::Mesh>(*mesh_);
    other->source_hash = 8;
    EXPECT_FALSE(is_told(PieceRequest{job_, other, {}, {}}));
    EXPECT_NE(in_english(sut_.problem()).find("is not the file that the job was sliced from"),
              std::string::npos)
        << in_english(sut_.problem());
}

TEST_F(PiecePreviewTest, IsCancelledInEachOfItsParts) {
    for (const PieceRequest& request : {of_job(), of_draft()}) {
        for (const double end_ratio : {0.0, 0.3, 0.6, 0.75, 0.9}) {
            double last_ratio = 0.0;
            const auto worked_out = work_out_piece(request, plan_, {1, [&](double done_ratio) {
                                                                        EXPECT_LE(done_ratio, 1.0);
                                                                        last_ratio = done_ratio;
                                                                        return done_ratio < end_ratio;
                                                                    }});
            ASSERT_FALSE(worked_out) << end_ratio;
            EXPECT_EQ(worked_out.error().code, ErrorCode::cancelled);
            EXPECT_LT(last_ratio, end_ratio + 0.15);
        }
    }
}

}  // namespace
}  // namespace psicarve::session
