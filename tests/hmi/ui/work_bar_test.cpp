// SPDX-License-Identifier: GPL-3.0-or-later
// What a window had on the desk that did not end in order is offered to be taken up again.
#include <gtest/gtest.h>

#include <unistd.h>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QSpinBox>
#include <QSysInfo>
#include <QVariantMap>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "hmi/ui/work_keeper.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;

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
    /// Turned, so that taking it up makes another body of it.
    void leave_turned_behind() {
        ASSERT_NO_FATAL_FAILURE(leave_behind());
        QVariantMap all = read();
        QVariantMap kept = all["gone"].toMap();
        QVariantMap fields = kept["fields"].toMap();
        ASSERT_TRUE(fields.contains("turn") && fields.contains("turn_x"));
        fields["turn"] = true;
        fields["turn_x"] = 90.0;
        kept["fields"] = fields;
        all["gone"] = kept;
        put(all);
    }
    bool opens_and_slices() {
        window_->open(QString::fromStdString(path_));
        if (!comes_to(OpenJobState::model)) return false;
        part<QSpinBox>("layers").setValue(17);
        part<QSpinBox>("points").setValue(24);
        if (!click("slice") || !comes_to(OpenJobState::job)) return false;
        return comes_true(
            [] { return !read().isEmpty() && read().first().toMap().value("sliced").toBool(); });
    }
    static QVariantMap read() { return test::KeptStore{}.store.value(WorkKeeper::kKey).toMap(); }
    static void put(const QVariantMap& all) { test::KeptStore{}.store.set(WorkKeeper::kKey, all); }
    /// As the window has them by now, whether they are in the file or not.
    QVariantMap records() { return window_->context().settings->value(WorkKeeper::kKey).toMap(); }
    OpenJobState desk_state() { return window_->context().open_job.view().state; }
    /// What is done unasked is done by then.
    void look_on() {
        constexpr int kLooks = 20;
        for (int i = 0; i < kLooks; ++i) ASSERT_TRUE(comes_true([] { return true; }));
    }
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
    EXPECT_EQ(window_->context().open_job.view().state, OpenJobState::empty) << "nothing is done unasked";
    take_picture("unfinished_light");
    ASSERT_TRUE(click("work_take"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    EXPECT_EQ(window_->context().open_job.job()->view.layer_count(), 17U);
    EXPECT_EQ(window_->context().open_job.job()->view.point_count(), 24U);
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
    EXPECT_TRUE(comes_to(OpenJobState::model));
    for (int i = 0; i < 20; ++i) window_->refresh();
    EXPECT_EQ(window_->context().open_job.view().state, OpenJobState::model);
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
    ASSERT_TRUE(comes_to(OpenJobState::published));
    EXPECT_TRUE(comes_true([] { return read().isEmpty(); }));
    part<QSpinBox>("layers").setValue(18);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    ASSERT_TRUE(comes_true([] { return read().size() == 1; }));
    window_->context().files.save_job(folder_.path("kept.psi"), window_->context().open_job.job());
    EXPECT_TRUE(comes_true([] { return read().isEmpty(); }));
}

// In containers, and where the window is started with the computer, its number comes again.
TEST_F(UnfinishedWorks, OfAnotherOfTheSameProcessNumberStay) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    const QVariant kept = read().first();
    QVariantMap all;
    constexpr int kMostWindows = 300;  // that this program had before
    for (int i = 1; i <= kMostWindows; ++i)
        all[QString{"%1 %2 %3"}.arg(QSysInfo::machineHostName()).arg(::getpid()).arg(i)] = kept;
    put(all);
    open_window();
    window_->open(QString::fromStdString(example("letter.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    look_on();
    EXPECT_EQ(records().size(), kMostWindows + 1);
    window_->close();
    window_.reset();
    EXPECT_TRUE(read() == all) << "a window that goes takes its own record alone";
}

TEST_F(UnfinishedWorks, AreNeverWithoutARecordWhileTakenUp) {
    ASSERT_NO_FATAL_FAILURE(leave_turned_behind());
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    ASSERT_TRUE(click("work_take"));
    int without = 0;
    ASSERT_TRUE(comes_true([&] {
        without += records().isEmpty() ? 1 : 0;
        return desk_state() == OpenJobState::job;
    }));
    EXPECT_EQ(without, 0);
    EXPECT_EQ(part<QDoubleSpinBox>("turn_x").value(), 90.0);
    EXPECT_FALSE(records().contains("gone"));
    EXPECT_FALSE(is_offered());
}

TEST_F(UnfinishedWorks, AreOfferedStillWhenTurningThemIsCancelled) {
    ASSERT_NO_FATAL_FAILURE(leave_turned_behind());
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    ASSERT_TRUE(click("work_take"));
    // Look by look, without the window's own clock: the look after the one that begins the turn may end it.
    ASSERT_TRUE(eventually([this] {
        window_->refresh();
        return part<QCheckBox>("turn").isChecked() && desk_state() == OpenJobState::opening;
    }));
    window_->context().open_job.cancel();
    ASSERT_TRUE(comes_to(OpenJobState::empty));
    look_on();
    EXPECT_TRUE(is_offered());
    EXPECT_TRUE(records().contains("gone"));
    // By hand it is not sliced unasked.
    window_->open(QString::fromStdString(path_));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    look_on();
    EXPECT_EQ(desk_state(), OpenJobState::model);
    EXPECT_TRUE(is_offered());
    ASSERT_TRUE(click("work_take"));
    EXPECT_TRUE(comes_to(OpenJobState::job));
    EXPECT_FALSE(is_offered());
}

TEST_F(UnfinishedWorks, AreOfferedStillWhenOpeningThemIsCancelled) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    open_window();
    part<QSpinBox>("layers").setValue(400);
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    ASSERT_TRUE(click("work_take"));
    window_->context().open_job.cancel();
    ASSERT_TRUE(comes_to(OpenJobState::empty));
    look_on();
    window_->open(QString::fromStdString(path_));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    look_on();
    EXPECT_EQ(desk_state(), OpenJobState::model);
    EXPECT_EQ(part<QSpinBox>("layers").value(), 400);
    EXPECT_TRUE(is_offered());
}

TEST_F(UnfinishedWorks, OfAFileThatChangesWhileOfferedAreNotSliced) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    std::filesystem::copy_file(example("letter.stl"), path_,
                               std::filesystem::copy_options::overwrite_existing);
    ASSERT_TRUE(click("work_take"));
    ASSERT_TRUE(comes_true([this] { return part<QSpinBox>("layers").value() == 17 && !is_offered(); }));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    look_on();
    EXPECT_EQ(desk_state(), OpenJobState::model);
}

// On a stick that is plugged in later.
TEST_F(UnfinishedWorks, OfAFileThatComesBackCanBeTakenUp) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    const std::string away = folder_.path("away.stl");
    std::filesystem::rename(path_, away);
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    EXPECT_FALSE(button("work_take").isEnabled());
    std::filesystem::rename(away, path_);
    ASSERT_TRUE(comes_true([this] { return button("work_take").isEnabled(); }));
    EXPECT_TRUE(part<QLabel>("work_note").text().contains("Nothing is published"));
    std::filesystem::rename(path_, away);
    ASSERT_TRUE(comes_true([this] { return !button("work_take").isEnabled(); }));
    std::filesystem::rename(away, path_);
    ASSERT_TRUE(click("work_take"));
    EXPECT_TRUE(comes_to(OpenJobState::job));
}

TEST_F(UnfinishedWorks, AreNoneOncePublishedThoughTheCoreEnds) {
    start_core();
    open_window();
    ASSERT_TRUE(opens_and_slices());
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(OpenJobState::published));
    ASSERT_TRUE(comes_true([this] { return records().isEmpty(); }));
    core_.reset();
    ASSERT_TRUE(comes_to(OpenJobState::job));
    look_on();
    EXPECT_TRUE(records().isEmpty());
    part<QSpinBox>("layers").setValue(18);
    EXPECT_TRUE(comes_true([this] { return records().size() == 1; })) << "what is changed is not published";
}

TEST_F(UnfinishedWorks, ThatAreSavedAreNotHeldInMemory) {
    open_window();
    ASSERT_TRUE(opens_and_slices());
    cam::PreparedJob copy;
    copy.blob = window_->context().open_job.job()->blob;
    auto job = std::make_shared<const cam::PreparedJob>(std::move(copy));
    session::FileSaver& files = window_->context().files;
    files.save_job(folder_.path("kept.psi"), job);
    ASSERT_TRUE(comes_true([&] { return files.saved_job() == job; }));
    job.reset();
    EXPECT_EQ(files.saved_job(), nullptr);
}

TEST_F(UnfinishedWorks, AreOpenedAsEveryFileIs) {
    ASSERT_NO_FATAL_FAILURE(leave_behind());
    test::KeptStore{}.store.set("files/recent", QStringList{});
    open_window();
    ASSERT_TRUE(comes_true([this] { return is_offered(); }));
    // Nobody knows the machine yet.
    window_->begin_with(QString::fromStdString(folder_.path("none.toml")), {});
    button("work_take").click();
    EXPECT_TRUE(all_messages().contains("the machine's profile is still being read"))
        << all_messages().toStdString();
    EXPECT_EQ(desk_state(), OpenJobState::empty);
    ASSERT_TRUE(comes_true([this] { return all_messages().contains("none.toml"); }));
    look_on();
    ASSERT_TRUE(is_offered());
    ASSERT_TRUE(click("work_take"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    EXPECT_EQ(WindowSettings{*window_->context().settings}.recent_files(),
              QStringList{QString::fromStdString(path_)});
}

}  // namespace
}  // namespace psicarve::ui
