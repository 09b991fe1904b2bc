// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever ended a carving, it goes on behind the last finished layer.
#include <string>

#include "shared/segment/checkpoint.hpp"
#include "tests/two_process/core_rig.hpp"
#include "tests/two_process/pin_walk.hpp"

namespace psicarve::two_process {
namespace {

class CoreCheckpoint : public CoreRig {
protected:
    Command resuming(std::uint64_t layers = 0) const {
        Command command{};
        command.kind = CommandKind::start;
        command.axis = kStartResumes;
        command.value2 = layers;
        return command;
    }
    Checkpoint checkpoint() const {
        return read_record(segment_->header().checkpoint).value_or(Checkpoint{});
    }
    void carve_some_layers() {
        ASSERT_EQ(publish(long_job()), "");
        home();
        start_carving();
        ASSERT_TRUE(eventually([&] { return checkpoint().next_layer >= 3; }));
    }
    void wait_for_job() {
        ASSERT_TRUE(eventually([&] { return status().job_generation != 0; })) << text_of(file("core.err"));
    }
    /// To their end.
    void carve(std::uint32_t first, std::uint64_t layers) {
        Command command{};
        command.kind = CommandKind::start;
        command.value = first;
        command.value2 = layers;
        const auto before = status().job_start_tick;
        ASSERT_EQ(refusal_of(command), "");
        ASSERT_TRUE(reaches(MachineState::waiting));
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        ASSERT_TRUE(eventually([&] {
            const CoreStatus now = status();
            return now.job_start_tick != before && now.job_end_tick != 0 && now.state == MachineState::ready;
        }));
    }
    bool comes_to(std::uint32_t next_layer, std::uint32_t earlier_layer) {
        return eventually([&] {
            return checkpoint().next_layer == next_layer && checkpoint().earlier_layer == earlier_layer;
        });
    }
    /// As many layers as `command` says, on a core of its own with its pins in `trace`.
    void carve_on_new_core(const Command& command, const std::string& trace) {
        start_core({"--trace", trace});
        wait_for_job();
        home();
        ASSERT_EQ(refusal_of(command), "");
        ASSERT_TRUE(reaches(MachineState::waiting));
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(core_->wait_for_exit(), 0);
    }
};

TEST_F(CoreCheckpoint, AfterTheCoreWasKilledTheSamePulsesGoOn) {
    constexpr std::uint32_t kLayersMore = 2;
    start_core();
    carve_some_layers();
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    const std::uint32_t layer = checkpoint().next_layer;
    ASSERT_GE(layer, 3U);
    const Checkpoint before = checkpoint();
    start_core();
    wait_for_job();
    EXPECT_NE(refusal_of(resuming()).find("home"), std::string::npos) << "not before it was homed";
    EXPECT_EQ(checkpoint().next_layer, before.next_layer);
    EXPECT_EQ(checkpoint().check, before.check);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);

    carve_on_new_core(resuming(kLayersMore), file("resumed.trace"));
    EXPECT_EQ(checkpoint().next_layer, layer + kLayersMore);
    Command whole{};
    whole.kind = CommandKind::start;
    whole.value2 = layer + kLayersMore;
    carve_on_new_core(whole, file("whole.trace"));

    const auto blob = job_blob_from_table(long_job());
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job.has_value());
    const PinWalk resumed = walk_of(file("resumed.trace"), Profile{});
    const PinWalk undisturbed = walk_of(file("whole.trace"), Profile{});
    const std::size_t resumed_first = first_step_at(resumed, *job, layer, 0);
    const std::size_t first = first_step_at(undisturbed, *job, layer, 0);
    ASSERT_LT(resumed_first, resumed.steps.size());
    ASSERT_LT(first, undisturbed.steps.size());
    const auto order = order_from(undisturbed, first, undisturbed.steps.size());
    EXPECT_GT(order.size(), 2000U);
    EXPECT_TRUE(order_from(resumed, resumed_first, resumed.steps.size()) == order);
    // Nothing of what was carved before was carved again.
    EXPECT_EQ(first_step_at(resumed, *job, layer - 1, 100), resumed.steps.size());
}

TEST_F(CoreCheckpoint, AnEmergencyStopAStopAndAnotherStartOverAreNoHindrance) {
    start_core();
    carve_some_layers();
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    home();
    const std::uint32_t layer = checkpoint().next_layer;
    ASSERT_GE(layer, 3U);
    ASSERT_EQ(refusal_of(resuming()), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    EXPECT_EQ(status().layer, layer);
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(checkpoint().next_layer, layer) << "nothing was carved since";

    // The same job published anew is the same job.
    ASSERT_EQ(publish(long_job()), "");
    ASSERT_EQ(refusal_of(resuming(1)), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    ASSERT_TRUE(eventually([&] { return checkpoint().next_layer == layer + 1; }));

    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    EXPECT_NE(refusal_of(resuming()).find("another job"), std::string::npos) << refusal_of(resuming());
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    ASSERT_TRUE(eventually([&] { return checkpoint().next_layer == 3; }));
    EXPECT_NE(refusal_of(resuming()).find("carved to its end"), std::string::npos);
    ASSERT_TRUE(reaches(MachineState::ready));
}

TEST_F(CoreCheckpoint, StaysAtTheFirstLayerThatIsNotCarved) {
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    carve(0, 4);
    EXPECT_TRUE(eventually([&] { return checkpoint().next_layer == 4; })) << checkpoint().next_layer;
    carve(30, 1);
    EXPECT_EQ(checkpoint().next_layer, 4U) << "layers 4 to 29 are not carved";
    carve(1, 1);
    EXPECT_EQ(checkpoint().next_layer, 4U) << "one that is done again";
    carve(3, 3);
    EXPECT_TRUE(eventually([&] { return checkpoint().next_layer == 6; })) << checkpoint().next_layer;
    carve(0, 1);
    EXPECT_TRUE(eventually([&] { return checkpoint().next_layer == 1; })) << "another piece";
}

TEST_F(CoreCheckpoint, AStartByMistakeLeavesTheWayBack) {
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    carve(0, 6);
    ASSERT_TRUE(comes_to(6, 0)) << checkpoint().next_layer;
    carve(0, 2);
    EXPECT_TRUE(comes_to(2, 6)) << checkpoint().next_layer << ", " << checkpoint().earlier_layer;
    carve(0, 1);
    EXPECT_TRUE(comes_to(1, 2)) << "the run before is the one that was begun by mistake";
    // What may be a new blank is not taken for the old piece unasked.
    ASSERT_EQ(refusal_of(resuming()), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    EXPECT_EQ(status().layer, 1U);
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    carve(30, 1);
    EXPECT_TRUE(comes_to(1, 2)) << "layers are left out of either";
    carve(2, 1);
    EXPECT_TRUE(comes_to(3, 0)) << "the piece of before goes on";
    carve(3, 4);
    ASSERT_TRUE(comes_to(7, 0));
    carve(0, 2);
    ASSERT_TRUE(comes_to(2, 7));
    carve(2, 8);
    EXPECT_TRUE(comes_to(10, 0)) << "passed";
}

TEST_F(CoreCheckpoint, OnlyTheLayerBehindTheRunBeforeGoesBackToIt) {
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    carve(0, 6);
    carve(0, 2);
    ASSERT_TRUE(comes_to(2, 6)) << checkpoint().next_layer << ", " << checkpoint().earlier_layer;
    for (const std::uint32_t between : {3U, 4U, 5U}) {
        carve(between, 1);
        EXPECT_TRUE(comes_to(2, 6)) << "a gap in the one, and done again in the other: " << between << ", "
                                    << checkpoint().next_layer << ", " << checkpoint().earlier_layer;
    }
    carve(2, 1);
    EXPECT_TRUE(comes_to(3, 6)) << "goes on: " << checkpoint().next_layer << ", "
                                << checkpoint().earlier_layer;
    carve(7, 1);
    EXPECT_TRUE(comes_to(3, 6)) << "behind both";
    carve(6, 2);
    EXPECT_TRUE(comes_to(8, 0)) << "back";
}

TEST_F(CoreCheckpoint, AStartByMistakeWithoutALayerSaysWhereTheRunBeforeCameTo) {
    // So many that a core on the virtual clock, which takes milliseconds for a layer, is not past them again
    // before anyone looks.
    constexpr std::uint32_t before = 150;
    start_core();
    ASSERT_EQ(publish(long_job()), "");
    home();
    carve(0, before);
    ASSERT_TRUE(comes_to(before, 0));
    start_carving();
    ASSERT_TRUE(eventually([&] { return checkpoint().earlier_layer == before; }));
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    if (checkpoint().next_layer == 0) {
        const std::string refusal = refusal_of(resuming());
        EXPECT_NE(refusal.find("no layer was finished"), std::string::npos) << refusal;
        EXPECT_NE(refusal.find("--from-layer " + std::to_string(before)), std::string::npos) << refusal;
    }
    // A whole piece is no way back.
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    home();
    carve(0, 3);
    ASSERT_TRUE(comes_to(3, 0));
    carve(0, 1);
    EXPECT_TRUE(comes_to(1, 0)) << checkpoint().earlier_layer;
}

TEST_F(CoreCheckpoint, IsNoneBeforeAnythingWasCarved) {
    start_core();
    home();
    EXPECT_NE(refusal_of(resuming()).find("no job"), std::string::npos);
    ASSERT_EQ(publish(long_job()), "");
    EXPECT_NE(refusal_of(resuming()).find("nothing was carved"), std::string::npos);
    ASSERT_TRUE(reaches(MachineState::ready));
}

TEST_F(CoreCheckpoint, AnyBitOfItChangedIsRefusedAndNothingMoves) {
    start_core();
    carve_some_layers();
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    const CoreStatus before = status();
    auto& record = segment_->header().checkpoint;
    for (AtomicWord64& word : record.words) {
        for (unsigned bit = 0; bit < 64; ++bit) {
            word.fetch_xor(std::uint64_t{1} << bit);
            ASSERT_NE(refusal_of(resuming()), "") << "word " << &word - record.words << ", bit " << bit;
            word.fetch_xor(std::uint64_t{1} << bit);
        }
    }
    record.sequence.fetch_or(1);
    EXPECT_NE(refusal_of(resuming()).find("damaged"), std::string::npos);
    record.sequence.fetch_add(1);
    const CoreStatus after = status();
    EXPECT_EQ(after.state, MachineState::ready);
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(after.sim_true_position_pulses[index_of(axis)],
                  before.sim_true_position_pulses[index_of(axis)]);
    }
    ASSERT_EQ(refusal_of(resuming()), "") << "and whole again it is good";
    ASSERT_TRUE(reaches(MachineState::waiting));
}

}  // namespace
}  // namespace psicarve::two_process
