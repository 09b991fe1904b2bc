// SPDX-License-Identifier: GPL-3.0-or-later
// Files that cannot be opened: the window says so until the next one, whatever else there is to be told.
#include <gtest/gtest.h>

#include <QLabel>

#include <filesystem>
#include <fstream>

#include "hmi/ui/words.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using DS = session::OpenJobState;

class WindowThatRefuses : public WindowRig {
protected:
    QString text_of(const char* label) { return part<QLabel>(label).text(); }
    bool is_refusal_there() { return part<QWidget>("refusal").isVisible(); }
    bool has(const char* said) { return all_messages().contains(said); }
    /// The first bytes of a file.
    std::string cut(const std::string& path, std::size_t bytes, const char* name) {
        std::ofstream{file(name), std::ios::binary} << two_process::text_of(path).substr(0, bytes);
        return file(name);
    }
    void open(const std::string& path) { window_->open(QString::fromStdString(path)); }
    /// What the view of page Model says in the model's place.
    QString said_in_the_view() {
        for (const QLabel* label : part<QWidget>("model_view").findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains("No model.")) return label->text();
        }
        return {};
    }
};

TEST_F(WindowThatRefuses, SaysSoLargeAndKeepsSayingItWhileACoreWithAnOlderJobIsFound) {
    start_core();
    open_window();
    publish_job(two_process::long_job());
    open_window();  // another one, which finds core and job by itself
    open(cut(example("figurine.stl"), 100'000, "trunc.stl"));
    ASSERT_TRUE(comes_true([&] { return has("Core found") && has("cut off"); }));
    ASSERT_TRUE(comes_to(DS::published));
    ASSERT_TRUE(comes_true([&] { return button("publish").toolTip() != "" && is_refusal_there(); }));
    EXPECT_EQ(text_of("refusal_title"), "trunc.stl was not opened");
    EXPECT_TRUE(text_of("refusal_why").contains("cut off, or not an STL file"));
    EXPECT_TRUE(text_of("refusal_stays").contains("Start carves")) << text_of("refusal_stays").toStdString();
    EXPECT_TRUE(said_in_the_view().startsWith("trunc.stl was not opened\n"))
        << said_in_the_view().toStdString();
    EXPECT_TRUE(part<QLabel>("last_message").toolTip().contains("cut off"))
        << part<QLabel>("last_message").toolTip().toStdString();
    EXPECT_EQ(part<QLabel>("last_message").property("trouble"), "yes");
    take_picture("refused_light");
    window_->set_theme(ThemeChoice::dark);
    take_picture("refused_dark");
}

TEST_F(WindowThatRefuses, SaysSoBesideTheModelThatStaysAndForgetsItWithTheNextOne) {
    open_window();
    open(example("small.stl"));
    ASSERT_TRUE(comes_to(DS::model));
    EXPECT_FALSE(is_refusal_there());
    open(file("gone.stl"));  // as from the recent ones
    ASSERT_TRUE(comes_true([&] { return is_refusal_there(); }));
    EXPECT_EQ(text_of("refusal_title"), "gone.stl was not opened");
    EXPECT_EQ(text_of("refusal_stays"), "Still open: small.stl");
    EXPECT_EQ(window_->context().open_job.view().state, DS::model);
    take_picture("refused_beside_a_model");
    open(example("letter.stl"));
    ASSERT_TRUE(comes_true([&] { return has("Opened letter.stl"); }));
    EXPECT_FALSE(is_refusal_there());
}

TEST_F(WindowThatRefuses, SaysSoOfSnapshotsAndTracesToo) {
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(two_process::long_job());
    ASSERT_TRUE(save_snapshot(snapshot, file("run.job")));
    open_window();
    open(cut(file("run.job"), 5000, "cut.job"));
    ASSERT_TRUE(comes_true([&] { return is_refusal_there(); }));
    EXPECT_EQ(text_of("refusal_title"), "cut.job was not opened");
    // Begins as a trace does, and ends there.
    std::ofstream{file("cut.trace"), std::ios::binary} << "PSCATRC1" << std::string(42, '\0');
    open(file("cut.trace"));
    ASSERT_TRUE(comes_true([&] { return text_of("refusal_title") == "cut.trace was not opened"; }));
    EXPECT_TRUE(is_refusal_there());
    EXPECT_EQ(text_of("refusal_stays"), "");
}

TEST_F(WindowThatRefuses, TakesItAwayOnceSomebodyHasReadIt) {
    open_window();
    open(file("gone.stl"));
    ASSERT_TRUE(comes_true([&] { return is_refusal_there(); }));
    ASSERT_TRUE(click("refusal_read"));
    EXPECT_FALSE(is_refusal_there());
    window_->refresh();
    EXPECT_FALSE(said_in_the_view().contains("gone.stl"));
}

TEST_F(WindowThatRefuses, SaysThatOneJobIsMadeAtATime) {
    open_window();
    open(example("figurine.stl"));
    open(example("small.stl"));  // before the first one is there
    window_->refresh();
    EXPECT_TRUE(is_refusal_there());
    EXPECT_EQ(text_of("refusal_title"), "small.stl was not opened");
    ASSERT_TRUE(comes_to(DS::model));
}

}  // namespace
}  // namespace psicarve::ui
