// SPDX-License-Identifier: GPL-3.0-or-later
// The core's job, put on the desk in place of what is open.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "hmi/session/action_lock.hpp"
#include "tests/hmi/session/session_rig.hpp"

namespace psicarve::session {
namespace {

class TakeOver : public test::SessionRig {
protected:
    void open_model(const char* name) {
        desk_->open(example(name));
        ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; })) << all_messages();
    }
    /// As another window does.
    void publish_from_elsewhere(const JobTable& table) {
        auto ours = std::exchange(desk_, std::make_unique<OpenJob>(segment_name_, std::string{}, log_));
        open_and_publish(table);
        desk_ = std::move(ours);
    }
};

TEST_F(TakeOver, TakesTheJobThatAnotherProgramHasPublished) {
    start_core();
    open_session();
    desk_->open(example("small.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; })) << all_messages();
    slice_and_publish(12);
    EXPECT_FALSE(desk_->can_take_over()) << "it is the machine's";
    const auto ours = std::exchange(desk_, std::make_unique<OpenJob>(segment_name_, std::string{}, log_));
    open_and_publish(two_process::lobed_job(7, 30));
    desk_->open(example("letter.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; }));
    desk_->take_over();
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }));
    EXPECT_EQ(desk_->mesh(), nullptr) << "that job is not of this model";
    EXPECT_EQ(desk_->path(), "");
    EXPECT_FALSE(desk_->view().can_be_sliced);
    // The window whose job it was: its own waits, and says that the machine has it no more.
    desk_ = nullptr;
    ASSERT_TRUE(eventually([&] {
        session_->poll();
        ours->poll(session_->view());
        return ours->can_take_over();
    }));
    EXPECT_EQ(ours->view().state, OpenJobState::job);
    EXPECT_TRUE(ours->view().was_published);
    EXPECT_EQ(ours->job()->view.layer_count(), 12U);
    ours->take_over();
    ours->poll(session_->view());
    EXPECT_EQ(ours->view().state, OpenJobState::published);
    EXPECT_EQ(ours->job()->view.layer_count(), 7U);
    EXPECT_EQ(ours->scene(), nullptr);
    EXPECT_FALSE(ours->can_take_over());
}

TEST_F(TakeOver, OfItsOwnJobDoesNotLoseTheModel) {
    start_core();
    open_session();
    desk_->open(example("small.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; })) << all_messages();
    slice_and_publish(12);
    slice_to(14);
    EXPECT_FALSE(desk_->view().was_published);
    EXPECT_FALSE(desk_->is_taken_over());
    const auto model = desk_->mesh();
    desk_->take_over();
    desk_->poll(session_->view());
    EXPECT_EQ(desk_->view().state, OpenJobState::published);
    EXPECT_EQ(desk_->job()->view.layer_count(), 12U);
    EXPECT_EQ(desk_->mesh(), model);
    EXPECT_EQ(desk_->job_mesh(), model);
    EXPECT_TRUE(desk_->is_taken_over()) << "the form has another number of layers";
    slice_to(14);
    EXPECT_FALSE(desk_->is_taken_over());
}

TEST_F(TakeOver, StaysWhateverIsPublishedNext) {
    start_core();
    open_session();
    ASSERT_NO_FATAL_FAILURE(open_model("small.stl"));
    ASSERT_NO_FATAL_FAILURE(publish_from_elsewhere(two_process::lobed_job(7, 30)));
    ASSERT_TRUE(comes_true([&] { return desk_->can_take_over(); }));
    desk_->take_over();
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }));
    const auto taken = desk_->job();
    ASSERT_NO_FATAL_FAILURE(publish_from_elsewhere(two_process::lobed_job(9, 30)));
    ASSERT_TRUE(comes_true([&] { return desk_->core_job() && desk_->core_job()->view.layer_count() == 9U; }))
        << all_messages();
    EXPECT_EQ(desk_->job(), taken);
    EXPECT_EQ(desk_->view().state, OpenJobState::job);
    EXPECT_TRUE(desk_->can_take_over());
    EXPECT_TRUE(lock_of(Action::start, session_->view(), desk_->view()));
    desk_->take_over();
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }));
    EXPECT_EQ(desk_->job()->view.layer_count(), 9U);
}

TEST_F(TakeOver, KeepsTheFileThoughItsBodyWasMadeAnewSince) {
    start_core();
    open_session();
    ASSERT_NO_FATAL_FAILURE(open_model("small.stl"));
    ASSERT_NO_FATAL_FAILURE(slice_and_publish(12));
    const auto sliced_from = desk_->mesh();
    model::MeshTurn turn;
    turn.mirror = 0;
    desk_->turn(turn);
    ASSERT_TRUE(comes_true([&] { return desk_->mesh() != sliced_from && !desk_->view().is_busy(); }));
    ASSERT_NO_FATAL_FAILURE(slice_to(14));
    const auto open = desk_->mesh();
    desk_->take_over();
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }));
    EXPECT_EQ(desk_->job()->view.layer_count(), 12U);
    EXPECT_EQ(desk_->path(), example("small.stl"));
    EXPECT_EQ(desk_->mesh(), open);
    EXPECT_EQ(desk_->job_mesh(), sliced_from) << "as it was turned then";
    EXPECT_TRUE(desk_->is_taken_over());
}

TEST_F(TakeOver, TellsWhatGoesWithoutHavingBeenKept) {
    start_core();
    open_session();
    const auto take_over_from_sliced = [&](bool is_saved) {
        ASSERT_NO_FATAL_FAILURE(open_model("small.stl"));
        ASSERT_NO_FATAL_FAILURE(slice_to(12));
        const auto sliced = desk_->job();
        ASSERT_NO_FATAL_FAILURE(publish_from_elsewhere(two_process::lobed_job(7, 30)));
        ASSERT_TRUE(comes_true([&] { return desk_->can_take_over(); }));
        desk_->take_over(is_saved ? sliced.get() : nullptr);
        ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; }));
    };
    const auto is_told = [&] {
        return all_messages().find("Closed: small.stl, neither published nor saved") != std::string::npos;
    };
    ASSERT_NO_FATAL_FAILURE(take_over_from_sliced(true));
    EXPECT_FALSE(is_told()) << all_messages();
    ASSERT_NO_FATAL_FAILURE(take_over_from_sliced(false));
    EXPECT_TRUE(is_told()) << all_messages();
}

}  // namespace
}  // namespace psicarve::session
