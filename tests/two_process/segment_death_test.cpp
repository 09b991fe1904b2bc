// SPDX-License-Identifier: GPL-3.0-or-later
// What must be true after one of the two sides was killed or stopped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <random>
#include <string>

#include "shared/computer/event.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/segment/robust_mutex.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/shared/segment_fixture.hpp"
#include "tests/two_process/child_process.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using test::ChildProcess;
using testing::HasSubstr;

constexpr milliseconds kLong{60'000};
constexpr int kRounds = 200;

class SegmentDeath : public testing::Test {
protected:
    void SetUp() override {
        auto segment = Segment::create_or_attach(name_.options());
        ASSERT_TRUE(segment.has_value()) << segment.error().message;
        segment_.emplace(std::move(segment).value());
    }
    Segment attach() const { return Segment::attach(name_.get()).value(); }
    auto hold_the_mutex() const {
        return [this](const ChildProcess::Signal& holding) {
            Segment segment = attach();
            (void)RobustMutex{segment.header().mutex}.lock_within(kLong).has_value();
            holding.raise();
            ::pause();
        };
    }
    auto serve() const {
        return [this](const ChildProcess::Signal& serving) {
            Segment segment = attach();
            ASSERT_TRUE(segment.claim_core().has_value());
            serving.raise();
            ::pause();
        };
    }
    std::size_t used_slots() const {
        std::size_t used = 0;
        for (const CommandSlot& slot : segment_->header().commands) used += slot.state_and_sender.load() != 0;
        return used;
    }
    test::SegmentName name_;
    std::optional<Segment> segment_;
    std::mt19937 random_{20240611};
};

TEST_F(SegmentDeath, MutexHolderKilledDoesNotLockTheNextPublisherOut) {
    ChildProcess holder{hold_the_mutex()};
    ASSERT_TRUE(holder.wait_for_signal());

    holder.kill();

    EXPECT_TRUE(publish_job(*segment_, test::make_job(1), kLong).has_value());
    EXPECT_TRUE(publish_job(*segment_, test::make_job(2), kLong).has_value());
}

TEST_F(SegmentDeath, PublisherAlreadyWaitingGoesOnWhenTheHolderIsKilled) {
    ChildProcess holder{hold_the_mutex()};
    ASSERT_TRUE(holder.wait_for_signal());
    ChildProcess publisher{[this](const ChildProcess::Signal& began) {
        Segment segment = attach();
        began.raise();
        EXPECT_TRUE(publish_job(segment, test::make_job(1), kLong).has_value());
    }};
    ASSERT_TRUE(publisher.wait_for_signal());

    holder.kill();

    EXPECT_TRUE(publisher.ends_well());
    EXPECT_EQ(published_generation(*segment_), 1U);
}

TEST_F(SegmentDeath, StoppedMutexHolderIsNamedWhenTheLimitPasses) {
    ChildProcess holder{hold_the_mutex()};
    ASSERT_TRUE(holder.wait_for_signal());
    holder.stop();

    const auto published = publish_job(*segment_, test::make_job(1), milliseconds{30});

    ASSERT_FALSE(published.has_value());
    EXPECT_EQ(published.error().code, ErrorCode::timed_out);
    EXPECT_THAT(published.error().message, HasSubstr("process " + std::to_string(holder.pid())));
}

TEST_F(SegmentDeath, SecondCoreIsRefusedWithTheFirstOnesPid) {
    ChildProcess core{serve()};
    ASSERT_TRUE(core.wait_for_signal());

    const auto refused = segment_->claim_core();

    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().message, HasSubstr("pid " + std::to_string(core.pid())));
    EXPECT_EQ(segment_->core_pid(), core.pid());
}

TEST_F(SegmentDeath, StoppedCoreStillIsTheCore) {
    ChildProcess core{serve()};
    ASSERT_TRUE(core.wait_for_signal());
    core.stop();

    EXPECT_EQ(segment_->core_pid(), core.pid());
    EXPECT_FALSE(segment_->claim_core().has_value());
    EXPECT_EQ(send_command(*segment_, {CommandKind::home, 0, 0, 0}, milliseconds{10}).error().code,
              ErrorCode::timed_out);
}

TEST_F(SegmentDeath, AnotherCoreServesAsSoonAsTheFirstWasKilled) {
    for (int round = 0; round < 20; ++round) {
        ChildProcess core{serve()};
        ASSERT_TRUE(core.wait_for_signal());
        core.kill();
        EXPECT_FALSE(segment_->core_pid().has_value());
    }

    EXPECT_TRUE(segment_->claim_core().has_value());
}

TEST_F(SegmentDeath, ForkedChildOfTheCoreThatEndsDoesNotEndTheCore) {
    ASSERT_TRUE(segment_->claim_core().has_value());
    ChildProcess child{[this](const ChildProcess::Signal&) { segment_.reset(); }};
    EXPECT_TRUE(child.ends_well());

    EXPECT_EQ(attach().core_pid(), own_pid());
    EXPECT_FALSE(attach().claim_core().has_value());
}

TEST_F(SegmentDeath, SenderLearnsThatTheCoreWasKilledBeforeItAnswered) {
    ChildProcess core{[this](const ChildProcess::Signal& took) {
        Segment segment = attach();
        ASSERT_TRUE(segment.claim_core().has_value());
        took.raise();
        while (!take_command(segment)) ::usleep(100);
        ::raise(SIGKILL);
    }};
    ASSERT_TRUE(core.wait_for_signal());

    const auto result = send_command(*segment_, {CommandKind::home, 0, 0, 0}, kLong);

    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::no_core);
}

TEST_F(SegmentDeath, WaiterKilledNeverHangsTheSignaller) {
    for (int round = 0; round < 40; ++round) {
        ChildProcess waiter{[this](const ChildProcess::Signal& waiting) {
            Segment segment = attach();
            EventWord& event = segment.header().status_changed;
            waiting.raise();
            for (;;) (void)event_wait_past(event, event_count(event), kLong);
        }};
        ASSERT_TRUE(waiter.wait_for_signal());
        waiter.kill();
        event_signal(segment_->header().status_changed);
    }
    SUCCEED();
}

TEST_F(SegmentDeath, SenderKilledAtAnyInstantNeverKeepsASlot) {
    ASSERT_TRUE(segment_->claim_core().has_value());
    std::uniform_int_distribution<int> life_steps{0, 60};
    int rounds_with_commands = 0;
    for (int round = 0; round < 20 * kRounds && rounds_with_commands < kRounds; ++round) {
        bool took_any = false;
        ChildProcess sender{[this](const ChildProcess::Signal& began) {
            Segment segment = attach();
            began.raise();
            for (;;) (void)send_command(segment, {CommandKind::home, 0, 0, 0}, milliseconds{1}).has_value();
        }};
        ASSERT_TRUE(sender.wait_for_signal());
        for (int step = life_steps(random_); step > 0; --step) {
            if (const auto command = take_command(*segment_)) {
                answer_command(*segment_, *command, AnswerKind::done);
                took_any = true;
            }
            ::usleep(10);
        }
        sender.kill();
        while (const auto command = take_command(*segment_)) {
            answer_command(*segment_, *command, AnswerKind::done);
            took_any = true;
        }
        (void)take_command(*segment_).has_value();
        ASSERT_EQ(used_slots(), 0U) << round;
        rounds_with_commands += took_any ? 1 : 0;
    }
    EXPECT_EQ(rounds_with_commands, kRounds);
}

// Each publishes once before its life is measured: killed before that, it would prove nothing.
TEST_F(SegmentDeath, PublisherKilledAtAnyInstantLeavesAWholeJobPublished) {
    std::uniform_int_distribution<useconds_t> life_us{0, 4000};
    const auto first = test::make_job(1, 300, 300);
    const auto second = test::make_job(2, 300, 300);
    for (int round = 0; round < kRounds; ++round) {
        const std::uint64_t published_before = published_generation(*segment_);
        ChildProcess publisher{[&](const ChildProcess::Signal& began) {
            Segment segment = attach();
            (void)publish_job(segment, second, kLong).has_value();
            began.raise();
            for (;;) {
                (void)publish_job(segment, first, kLong).has_value();
                (void)publish_job(segment, second, kLong).has_value();
            }
        }};
        ASSERT_TRUE(publisher.wait_for_signal());
        ::usleep(life_us(random_));
        publisher.kill();

        ASSERT_GT(published_generation(*segment_), published_before) << round;
        const auto taken = take_published_job(*segment_, published_before);
        ASSERT_TRUE(taken.has_value()) << taken.error().message;
        ASSERT_TRUE(taken->has_value()) << round;
        const auto& blob = (*taken)->blob;
        ASSERT_TRUE(blob == first || blob == second) << round;
    }
    EXPECT_TRUE(publish_job(*segment_, test::make_job(3), kLong).has_value());
}

TEST_F(SegmentDeath, CoreKilledWhileWritingItsStatusIsFollowedByOneThatCanBeRead) {
    std::uniform_int_distribution<useconds_t> life_us{0, 300};
    for (int round = 0; round < 60; ++round) {
        ChildProcess core{[this](const ChildProcess::Signal& writes) {
            Segment segment = attach();
            (void)segment.claim_core().has_value();
            CoreStatus status{};
            for (;;) {
                ++status.tick;
                ++status.heartbeat;
                write_record(segment.header().status, status);
                append_to_ring(segment.header().recorder, FlightRecord{});
                if (status.tick == 1) writes.raise();
            }
        }};
        ASSERT_TRUE(core.wait_for_signal());
        ::usleep(life_us(random_));
        core.kill();
        const auto left = read_record(segment_->header().status);
        ASSERT_TRUE(!left || (left->tick == left->heartbeat && left->tick > 0)) << round;

        ASSERT_TRUE(segment_->claim_core().has_value());
        ASSERT_TRUE(read_record(segment_->header().status).has_value());
        ASSERT_FALSE((RingReader{segment_->header().recorder}.next().has_value()));
        segment_->release_core();
    }
}

}  // namespace
}  // namespace psicarve
