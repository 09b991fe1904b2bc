// SPDX-License-Identifier: GPL-3.0-or-later
// The machine's job and the one on the desk, told apart in the Job panel.
#include <gtest/gtest.h>

#include <QLabel>

#include <string>

#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using DS = session::OpenJobState;
using S = MachineState;

class JobPair : public test::WindowRig {
protected:
    std::string text(const char* label) { return part<QLabel>(label).text().toStdString(); }
    bool is_shown(const char* name) { return part<QWidget>(name).isVisible(); }
    bool is_above(const char* upper, const char* lower) {
        QApplication::processEvents();  // what is new is laid out with the next look
        const auto y_of = [this](const char* name) {
            return part<QWidget>(name).mapTo(window_.get(), QPoint{}).y();
        };
        return y_of(upper) < y_of(lower);
    }
    void open_example(const char* name, DS state) {
        window_->open(QString::fromStdString(example(name)));
        ASSERT_TRUE(comes_to(state));
    }
    /// As another window does: to the same core.
    void publish_from_elsewhere(const JobTable& table) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, file("other.job")));
        session::MessageLog log;
        session::OpenJob other{segment_name_, {}, log};
        other.open(file("other.job"));
        const auto comes = [&](DS state) {
            return comes_true([&] {
                other.poll(machine_view());
                return other.view().state == state;
            });
        };
        ASSERT_TRUE(comes(DS::job));
        other.publish();
        ASSERT_TRUE(comes(DS::published));
    }
    void carve_to_the_end() {
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
        ASSERT_TRUE(click("start"));
        ASSERT_TRUE(comes_true([&] { return text("machine_job_note") == "no. 1, 100 % done"; }))
            << text("machine_job_note");
        ASSERT_TRUE(comes_to(S::ready)) << "the heads are on their way out";
    }
};

TEST_F(JobPair, SaysWhatIsWhereBeforeAnythingIs) {
    open_window();
    window_->refresh();
    EXPECT_EQ(text("machine_job"), "–");
    EXPECT_EQ(text("machine_job_note"), "no core");
    EXPECT_EQ(text("desk_job_note"), "nothing");
    EXPECT_FALSE(is_shown("desk_job"));
    EXPECT_FALSE(is_shown("take_over"));
    start_core();
    ASSERT_TRUE(comes_true([&] { return text("machine_job") == "No job"; }));
    EXPECT_EQ(text("machine_job_note"), "");
    open_example("small.stl", DS::model);
    EXPECT_EQ(text("machine_job"), "No job");
    EXPECT_EQ(text("desk_job"), "small.stl");
    EXPECT_EQ(text("desk_job_note"), "not sliced");
}

TEST_F(JobPair, KeepsTheDoneJobApartFromTheOneThatWasSlicedAgain) {
    start_core();
    open_window();
    open_example("small.stl", DS::model);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(DS::job));
    EXPECT_EQ(text("desk_job_note"), "not published");
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(DS::published));
    EXPECT_EQ(text("machine_job"), "small.stl");
    EXPECT_EQ(text("desk_job_note"), "the same job");
    EXPECT_FALSE(is_shown("desk_job")) << "its name stands above";
    EXPECT_TRUE(is_above("job_counts", "desk_block"));
    ASSERT_NO_FATAL_FAILURE(carve_to_the_end());
    part<QAbstractSpinBox>("layers").stepUp();
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(DS::job));
    EXPECT_EQ(text("machine_job_note"), "no. 1, 100 % done");
    EXPECT_EQ(text("desk_job"), "small.stl");
    EXPECT_EQ(text("desk_job_note"), "not published");
    EXPECT_TRUE(is_above("desk_job", "job_time")) << "what the numbers are of";
    take_picture("job_pair_sliced_again");
    ASSERT_TRUE(click("take_over"));
    ASSERT_TRUE(comes_to(DS::published));
    EXPECT_EQ(text("desk_job_note"), "the same job");
    EXPECT_TRUE(text("desk_state").starts_with("Changed since")) << "the form has one layer more";
    EXPECT_FALSE(is_shown("take_over"));
    EXPECT_TRUE(button("start").isEnabled());
}

TEST_F(JobPair, SaysAllThatThereIsRoomForAndIsBriefWhereThereIsNone) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::lobed_job(7, 30)));
    ASSERT_TRUE(comes_true([&] { return text("desk_job_note") == "the same job"; }));
    const auto shows_all = [&] { return is_shown("reference") && !is_shown("job_brief"); };
    window_->resize(1280, 720);
    EXPECT_TRUE(comes_true(shows_all));
    window_->resize(1280, 690);
    EXPECT_TRUE(comes_true([&] { return is_shown("job_brief") && !is_shown("reference"); }));
    EXPECT_TRUE(text("job_brief").starts_with("7 × 30, ")) << text("job_brief");
    window_->resize(1280, 860);
    EXPECT_TRUE(comes_true(shows_all));
    EXPECT_EQ(button("start").property("low"), "no") << "as high as it should be";
}

TEST_F(JobPair, TakesOverTheJobThatAnotherProgramHasPublished) {
    start_core();
    open_window();
    open_example("figurine.stl", DS::model);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(DS::job));
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(DS::published));
    ASSERT_NO_FATAL_FAILURE(publish_from_elsewhere(two_process::lobed_job(7, 30)));
    ASSERT_TRUE(comes_true([&] { return text("machine_job") == "lobed"; }));
    EXPECT_EQ(text("machine_job_note"), "no. 2");
    EXPECT_EQ(text("desk_job"), "figurine.stl");
    EXPECT_EQ(text("desk_job_note"), "no longer in the machine");
    EXPECT_FALSE(button("start").isEnabled());
    EXPECT_EQ(button("take_over").toolTip(), "Puts this job on the desk in place of figurine.stl");
    take_picture("job_pair_published_elsewhere_light");
    window_->set_theme(ThemeChoice::dark);
    take_picture("job_pair_published_elsewhere_dark");
    ASSERT_TRUE(click("take_over"));
    ASSERT_TRUE(comes_to(DS::published));
    EXPECT_EQ(window_->context().open_job.job(), window_->context().open_job.core_job());
    EXPECT_EQ(window_->context().open_job.mesh(), nullptr);
    ASSERT_TRUE(comes_true([&] { return text("job_counts") == "7 × 30"; }));
    EXPECT_EQ(text("desk_job_note"), "the same job");
    EXPECT_TRUE(all_messages().contains("Taken over from the machine: lobed"));
}

}  // namespace
}  // namespace psicarve::ui
