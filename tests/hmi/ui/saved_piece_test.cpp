// SPDX-License-Identifier: GPL-3.0-or-later
// The computer was switched off in mid-job: what the window offers when it is opened again.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QMessageBox>
#include <QTest>

#include <cstdlib>
#include <filesystem>

#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "tests/hmi/ui/hands_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class SavedPiece : public test::HandsRig {
protected:
    SavedPiece() { setenv("PSICARVE_STATE", state().c_str(), 1); }
    ~SavedPiece() override { setenv("PSICARVE_STATE", "", 1); }

    std::string state() const { return file("state"); }
    QString label(const char* name) { return part<QLabel>(name).text(); }
    /// Of forty; and then nothing is left but the disk.
    void carve_six_layers_and_cut_the_power() {
        start_core({"--state", state()});
        const JobTable table = two_process::lobed_job(40, 40);
        ASSERT_EQ(publish(table), "");
        home();
        Command some{};
        some.kind = CommandKind::start;
        some.value2 = 6;
        ASSERT_EQ(refusal_of(some), "");
        ASSERT_TRUE(reaches(S::waiting));
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        ASSERT_TRUE(eventually([&] {
            const auto found = find_unfinished(segment_name_);
            return found && found->saved.checkpoint.next_layer == 6 && !found->job_path.empty();
        }));
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
        segment_.reset();
        ASSERT_TRUE(Segment::remove(segment_name_));
    }
    Answer answers(const char* name) {
        return [this, name](QDialog& dialog) {
            question_ = dynamic_cast<QMessageBox&>(dialog).text();
            test::keep_picture(dialog, dialog.objectName() + "_light");
            QTest::mouseClick(dialog.findChild<QAbstractButton*>(name), Qt::LeftButton);
        };
    }
    QString question_;
    bool is_shown() { return part<QWidget>("unfinished").isVisible(); }
};

TEST_F(SavedPiece, IsOfferedAtTheStartAndGoesOn) {
    ASSERT_NO_FATAL_FAILURE(carve_six_layers_and_cut_the_power());
    open_in_front();
    ASSERT_TRUE(comes_true([&] { return is_shown(); }));
    EXPECT_EQ(label("unfinished_title"), "Unfinished: 6 of 40 layers of lobed are carved");
    EXPECT_TRUE(label("unfinished_details").startsWith("Since 20"))
        << label("unfinished_details").toStdString();
    EXPECT_TRUE(label("unfinished_details")
                    .endsWith(" UTC, tool point. First start psicarve-rtcore. Open its job, publish it, Home "
                              "all, then go on from layer 7."))
        << label("unfinished_details").toStdString();
    EXPECT_FALSE(button("start_anew").isVisible()) << "there is no job yet";
    take_picture("saved_piece_light");
    ASSERT_TRUE(click("unfinished_open"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job)) << all_messages().toStdString();
    EXPECT_FALSE(is_shown());
    EXPECT_EQ(window_->context().open_job.job()->view.layer_count(), 40U);

    start_core({"--state", state()});
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(session::OpenJobState::published)) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return is_shown(); }));
    EXPECT_EQ(label("unfinished_title"), "Unfinished: 6 of 40 layers are carved");
    EXPECT_TRUE(button("start_anew").isVisible());
    EXPECT_FALSE(button("unfinished_open").isVisible());
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(comes_true([&] { return button("start").text() == "Continue from layer 7"; }));
    // A disk's word is not taken without a question, however the layer is started.
    ASSERT_TRUE(comes_true([&] { return machine_view().saved_piece.has_value(); }));
    for (const char* name : {"start", "one_layer", "from_layer"}) {
        EXPECT_TRUE(answered([&] { EXPECT_TRUE(click(name)); }, {answers("disk_cancel")})) << name;
        EXPECT_TRUE(question_.startsWith("Unfinished: 6 of 40 layers of lobed are carved\n\nSince 20"))
            << question_.toStdString();
        EXPECT_TRUE(question_.contains(" UTC, tool point.")) << question_.toStdString();
    }
    EXPECT_TRUE(comes_true([&] { return !window_->context().machine.has_orders(); }));
    EXPECT_EQ(machine_view().status->job_start_tick, 0U) << "nothing was started";
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("start")); }, {answers("disk_go")}));
    EXPECT_TRUE(comes_true([&] { return machine_view().status && machine_view().status->layer >= 6; }));
    EXPECT_TRUE(comes_true([&] { return !machine_view().is_checkpoint_from_disk; }))
        << "now it is the machine's own";
    EXPECT_TRUE(comes_true([&] {
        return machine_view().status->points_done == machine_view().status->points_total;
    })) << all_messages().toStdString();
}

TEST_F(SavedPiece, IsForgottenForGoodOnceItWasAsked) {
    ASSERT_NO_FATAL_FAILURE(carve_six_layers_and_cut_the_power());
    open_in_front();
    ASSERT_TRUE(comes_true([&] { return is_shown(); }));
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("unfinished_forget")); }, {answers("forget_cancel")}));
    EXPECT_TRUE(question_.startsWith("Unfinished: 6 of 40 layers of lobed are carved\n\nHow far"))
        << question_.toStdString();
    ASSERT_TRUE(find_unfinished(segment_name_));
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("unfinished_forget")); }, {answers("forget_go")}));
    EXPECT_TRUE(comes_true([&] { return !is_shown(); }));
    EXPECT_FALSE(find_unfinished(segment_name_));
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("The unfinished piece is forgotten."); }));
}

TEST_F(SavedPiece, OfWhichItIsAskedIsTheOneThatIsForgotten) {
    ASSERT_NO_FATAL_FAILURE(carve_six_layers_and_cut_the_power());
    open_in_front();
    ASSERT_TRUE(comes_true([&] { return is_shown(); }));
    // Another record comes while it is asked.
    const Answer changes = [&](QDialog& dialog) {
        auto found = find_unfinished(segment_name_);
        ASSERT_TRUE(found);
        ++found->saved.sequence;
        found->saved.checkpoint.job_checksum += 1;
        found->saved.checkpoint =
            checkpoint_at(found->saved.checkpoint.job_checksum, 9, 40, 0, found->saved.checkpoint.origin);
        ASSERT_TRUE(save_checkpoint(found->saved, found->path));
        QTest::mouseClick(dialog.findChild<QAbstractButton*>("forget_go"), Qt::LeftButton);
    };
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(click("unfinished_forget")); }, {changes}));
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("another unfinished piece has come"); }))
        << all_messages().toStdString();
    const auto left = find_unfinished(segment_name_);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->saved.checkpoint.next_layer, 9U);
}

TEST_F(SavedPiece, IsForgottenByTheCoreWhereItIsAskedFor) {
    ASSERT_NO_FATAL_FAILURE(carve_six_layers_and_cut_the_power());
    start_core({"--state", state()});
    ASSERT_EQ(publish(two_process::lobed_job(40, 40)), "");
    home();
    open_in_front();
    ASSERT_TRUE(comes_true([&] { return button("start").text() == "Continue from layer 7"; }));
    EXPECT_TRUE(
        answered([&] { EXPECT_TRUE(click("start")); }, {answers("disk_forget"), answers("forget_go")}));
    EXPECT_TRUE(comes_true([&] { return button("start").text() == "Start"; }));
    EXPECT_TRUE(comes_true([&] { return !find_unfinished(segment_name_); }));
}

TEST_F(SavedPiece, WithoutACopyOfItsJobSaysSoAndIsDismissed) {
    ASSERT_NO_FATAL_FAILURE(carve_six_layers_and_cut_the_power());
    std::filesystem::remove(find_unfinished(segment_name_)->job_path);
    start_core();
    open_in_front();
    ASSERT_TRUE(comes_true([&] { return is_shown(); }));
    EXPECT_FALSE(button("unfinished_open").isVisible());
    EXPECT_TRUE(
        label("unfinished_details")
            .endsWith("No copy of its job is there: open that very job, publish it, Home all, then go "
                      "on from layer 7."))
        << label("unfinished_details").toStdString();
    ASSERT_TRUE(click("unfinished_dismiss"));
    EXPECT_FALSE(is_shown());
    EXPECT_FALSE(comes_true([&] { return is_shown(); }, two_process::milliseconds{0}));
    // Another job of the machine's is another piece.
    publish_job(two_process::lobed_job(3, 33));
    EXPECT_TRUE(comes_true([&] { return !machine_view().saved_piece; }));
}

}  // namespace
}  // namespace psicarve::ui
