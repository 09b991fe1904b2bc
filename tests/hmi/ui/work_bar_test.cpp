// SPDX-License-Identifier: GPL-3.0-or-later
// What a window had on the desk that did not end in order is offered to be taken up again.
#include <gtest/gtest.h>

#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QSpinBox>
#include <QVariantMap>

#include <filesystem>
#include <string>

#include "hmi/ui/work_keeper.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

using session::DeskState;

class UnfinishedWorks : public test::WindowRig {
protected:
    UnfinishedWorks() { std::filesystem::copy_file(example("small.stl"), path_); }
    /// As a window that is gone has left it.
    void leave_behind(const QVariantMap& otherwise = {}) {
        open_window();
        ASSERT_TRUE(opens_and_slices());
        QVariantMap kept = read().first().toMap();
        ASSERT_EQ(kept.value("path").toString().toStdString(), path_);
        window_->close();
        window_.reset();
        EXPECT_TRUE(read().isEmpty()) << "a window that goes in order leaves nothing";
        kept["start"] = "another start";
        for (auto one = otherwise.begin(); one != otherwise.end(); ++one) kept[one.key()] = one.value();
        put({{"gone", kept}});
    }
    bool opens_and_slices() {
        window_->open(QString::fromStdString(path_));
        if (!comes_to(DeskState::model)) return false;
        part<QSpinBox>("layers").setValue(17);
        part<QSpinBox>("points").setValue(24);
        if (!click("slice") || !comes_to(DeskState::job)) return false;
        return comes_true(
            [] { return !read().isEmpty() && read().first().toMap().value("sliced").toBool(); });
    }
    static QVariantMap read() { return test::KeptStore{}.store.value(WorkKeeper::kKey).toMap(); }
    static void put(const QVariantMap& all) { test::KeptStore{}.store.set(WorkKeeper::kKey, all); }
    bool is_offered() { return !part<QWidget>("unfinished_work").isHidden(); }

    const psicarve::test::TemporaryFolder folder_;
    const std::string path_ = folder_.path("piece.stl");
};

TEST_F(UnfinishedWorks, AreTakenUpAsTheyWere) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    open_window();
    part<QSpinBox>("layers").setValue(400);
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    EXPECT_EQ(part<QLabel>("work_offer").text(), "Take up again: piece.stl, 17 layers × 24 points, sliced");
    EXPECT_TRUE(all_messages().contains("Not published when a window ended: piece.stl"));
    EXPECT_EQ(window_->bench().desk.sight().state, DeskState::empty) << "nothing is done unasked";
    take_picture("unfinished_light");
    ASSERT_TRUE(click("work_take"));
    ASSERT_TRUE(comes_to(DeskState::job));
    EXPECT_EQ(window_->bench().desk.job()->view.layer_count(), 17U);
    EXPECT_EQ(window_->bench().desk.job()->view.point_count(), 24U);
    EXPECT_FALSE(is_offered());
    // It is this window's now.
    ASSERT_TRUE(comes_true([] { return read().size() == 1 && !read().contains("gone"); }));
}

TEST_F(UnfinishedWorks, AreForgottenWhenNobodyWantsThem) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    ASSERT_TRUE(click("work_forget"));
    EXPECT_FALSE(is_offered());
    ASSERT_TRUE(comes_true([] { return read().isEmpty(); }));
    EXPECT_TRUE(QFile::exists(QString::fromStdString(path_)));
}

TEST_F(UnfinishedWorks, OfAFileThatChangedAreNotSliced) {
    ASSERT_NO_FATAL_FAILURE(leave_behind({{"bytes", 1}}));
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    EXPECT_TRUE(part<QLabel>("work_note").text().contains("was written since"));
    ASSERT_TRUE(click("work_take"));
    ASSERT_TRUE(comes_true([this] { return part<QSpinBox>("layers").value() == 17 && !is_offered(); }));
    EXPECT_TRUE(comes_to(DeskState::model));
    for (int i = 0; i < 20; ++i) window_->refresh();
    EXPECT_EQ(window_->bench().desk.sight().state, DeskState::model);
}

TEST_F(UnfinishedWorks, OfAFileThatIsGoneCanOnlyBeForgotten) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    std::filesystem::remove(path_);
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    EXPECT_FALSE(button("work_take").isEnabled());
    EXPECT_EQ(button("work_take").toolTip(), "The file is not there any more");
    ASSERT_TRUE(click("work_forget"));
    ASSERT_TRUE(comes_true([] { return read().isEmpty(); }));
}

// Written by hand, by another version, by a window that runs, or by one of another computer.
TEST_F(UnfinishedWorks, ThatAreNoneAreNotOffered) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    QVariantMap kept = read().first().toMap();
    QVariantMap of_others = kept;
    of_others["host"] = "another computer";
    QVariantMap without_path = kept;
    without_path.remove("path");
    const QVariantMap all{{"a", "no record"}, {"b", of_others}, {"c", without_path}, {"d", 7}};
    put(all);
    open_window();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(comes_true([] { return true; }));
    EXPECT_FALSE(is_offered());
    EXPECT_EQ(read().keys(), all.keys());
    window_.reset();
    test::KeptStore{}.store.set(WorkKeeper::kKey, "no records");
    open_window();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(comes_true([] { return true; }));
    EXPECT_FALSE(is_offered());
}

TEST_F(UnfinishedWorks, AreNoneOncePublishedOrSaved) {
    start_core();
    open_window();
    ASSERT_TRUE(opens_and_slices());
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(DeskState::published));
    EXPECT_TRUE(comes_true([] { return read().isEmpty(); }));
    part<QSpinBox>("layers").setValue(18);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(DeskState::job));
    ASSERT_TRUE(comes_true([] { return read().size() == 1; }));
    window_->bench().files.save_job(folder_.path("kept.psi"), window_->bench().desk.job());
    EXPECT_TRUE(comes_true([] { return read().isEmpty(); }));
}

}  // namespace
}  // namespace psicarve::ui
