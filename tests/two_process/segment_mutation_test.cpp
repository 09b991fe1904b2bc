// SPDX-License-Identifier: GPL-3.0-or-later
// Shared memory that anything may have been written to: the core does not crash, and moves nothing.
#include <random>
#include <string>
#include <thread>

#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr int kRounds = 100;
constexpr int kMutationsInRound = 100;
constexpr std::size_t kControlBytes = offsetof(SegmentHeader, status);

class SegmentMutation : public CoreRig {
protected:
    bool has_core_ended() const { return waitpid(core_->pid(), nullptr, WNOHANG) != 0; }

    /// What was spoilt is replaced by a new segment, or written over by what the core says next.
    ::testing::AssertionResult comes_back() {
        std::string problem;
        const bool is_back = eventually([&] {
            if (has_core_ended()) return true;
            auto fresh = Segment::attach(segment_name_);
            if (!fresh) {
                problem = fresh.error().message;
                return false;
            }
            segment_ = std::make_unique<Segment>(std::move(*fresh));
            const auto first = read_record(segment_->header().status);
            std::this_thread::sleep_for(milliseconds{20});
            const auto second = read_record(segment_->header().status);
            return segment_->core_pid() && first && second && second->heartbeat > first->heartbeat;
        });
        if (has_core_ended()) return ::testing::AssertionFailure() << "the core has ended";
        if (!is_back) return ::testing::AssertionFailure() << "no segment: " << problem;
        return ::testing::AssertionSuccess();
    }
    /// Bits, bytes or a whole word, mostly where locks, counters and commands stand.
    void mutate() {
        auto* const bytes = reinterpret_cast<unsigned char*>(&segment_->header());
        const std::size_t within = random_() % 4 == 0 ? sizeof(SegmentHeader) : kControlBytes;
        const std::size_t count = random_() % 3 == 0 ? 1 : 1 + random_() % 16;
        const std::size_t at = random_() % (within - count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto bits = static_cast<unsigned char>(count == 1 ? 1U << random_() % 8 : random_());
            __atomic_fetch_xor(bytes + at + i, bits, __ATOMIC_RELAXED);
        }
    }
    std::mt19937 random_{40977};
};

TEST_F(SegmentMutation, TenThousandMoveNothingAndEndNothing) {
    start_core();
    const std::vector<std::byte> job = job_blob_from_table(lobed_job(2, 9));
    int refusals = 0;
    for (int round = 0; round < kRounds; ++round) {
        ASSERT_TRUE(comes_back()) << "before round " << round;
        if (status().state == MachineState::alarm) (void)refusal_of(CommandKind::reset_alarm);
        if (round % 10 == 0 && status().state == MachineState::off) {
            ASSERT_EQ(refusal_of(CommandKind::home), "") << round;
            ASSERT_TRUE(reaches(MachineState::ready)) << round;
        }
        const CoreStatus before = status();
        for (int i = 0; i < kMutationsInRound; ++i) {
            mutate();
            if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::microseconds{200});
        }
        // A process that uses what is left gets an error that names the fault, or succeeds; none waits
        // forever.
        const auto published = publish_job(*segment_, job, milliseconds{300});
        if (!published) {
            EXPECT_NE(published.error().message, "");
            ++refusals;
        }
        ASSERT_TRUE(comes_back()) << "after round " << round;
        const CoreStatus after = status();
        for (const Axis axis : kAllAxes) {
            const std::size_t k = index_of(axis);
            ASSERT_EQ(after.sim_true_position_pulses[k], before.sim_true_position_pulses[k])
                << name_of(axis) << " in round " << round;
        }
    }
    EXPECT_GT(refusals, 0) << "nothing that matters was hit";
    // And it is as good as new.
    if (status().state == MachineState::alarm) (void)refusal_of(CommandKind::reset_alarm);
    home();
    // Its mutex the core does not touch: if that was hit, a core that is started anew makes it anew.
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    start_core();
    home();
    ASSERT_EQ(publish(lobed_job(2, 9)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
}

}  // namespace
}  // namespace psicarve::two_process
