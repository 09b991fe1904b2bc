// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/time_estimator.hpp"

#include <gtest/gtest.h>

#include <future>
#include <thread>

namespace psicarve::session {
namespace {

using namespace std::chrono_literals;

class TimeEstimatorTest : public ::testing::Test {
protected:
    static TimeEstimator::Job some_job() { return std::make_shared<const cam::PreparedJob>(); }
    /// As often as it takes for a thread to answer, at one moment of the desk's clock.
    template <typename Condition>
    bool comes_true(TimeEstimator& sut, const TimeEstimator::Job& wanted, Condition condition) {
        for (int i = 0; i < 10'000 && !condition(); ++i) {
            std::this_thread::sleep_for(1ms);
            sut.poll(wanted, now_);
        }
        return condition();
    }

    MessageLog log_;
    TimeEstimator::Clock::time_point now_{};
    TimeEstimator::Job job_ = some_job();
};

TEST_F(TimeEstimatorTest, PlansAJobThatStaysForAMoment) {
    TimeEstimator sut{log_, [](const auto&, const auto&) {
                          return Result<machine::PlannedTime>{machine::PlannedTime{61.0, {}, 60.0}};
                      }};
    sut.poll(job_, now_);
    now_ += TimeEstimator::kPatience - 1ms;
    sut.poll(job_, now_);
    EXPECT_FALSE(sut.is_planning()) << "it may be published at once";
    now_ += 1ms;
    sut.poll(job_, now_);
    EXPECT_TRUE(sut.is_planning());
    ASSERT_TRUE(comes_true(sut, job_, [&] { return sut.planned(job_).has_value(); }));
    EXPECT_EQ(sut.planned(job_)->carve_seconds, 61.0);
    EXPECT_FALSE(sut.planned(some_job())) << "another one's";
    EXPECT_FALSE(sut.planned(nullptr));
    sut.poll(nullptr, now_);
    EXPECT_TRUE(sut.planned(job_)) << "it is still as long";
    now_ += 10s;
    sut.poll(job_, now_);
    now_ += 10s;
    sut.poll(job_, now_);
    EXPECT_FALSE(sut.is_planning()) << "nobody plans it twice";
}

TEST_F(TimeEstimatorTest, GivesWayWhenTheComputerIsNeeded) {
    std::promise<void> has_begun;
    std::promise<void> was_told_to_end;
    TimeEstimator sut{log_, [&](const auto&, const auto& goes_on) -> Result<machine::PlannedTime> {
                          has_begun.set_value();
                          while (goes_on()) std::this_thread::sleep_for(1ms);
                          was_told_to_end.set_value();
                          return Error{ErrorCode::cancelled, "the estimate was cancelled"};
                      }};
    sut.poll(job_, now_);
    now_ += TimeEstimator::kPatience;
    sut.poll(job_, now_);
    ASSERT_TRUE(sut.is_planning());
    has_begun.get_future().wait();
    sut.poll(nullptr, now_);
    EXPECT_FALSE(sut.is_planning());
    was_told_to_end.get_future().wait();
    for (int i = 0; i < 20; ++i) {
        std::this_thread::sleep_for(1ms);
        sut.poll(nullptr, now_);
    }
    EXPECT_FALSE(sut.planned(job_));
    EXPECT_TRUE(log_.messages().empty()) << "nothing went wrong";
}

TEST_F(TimeEstimatorTest, SaysOnceWhyItIsNotKnown) {
    TimeEstimator sut{log_, [](const auto&, const auto&) -> Result<machine::PlannedTime> {
                          return Error{ErrorCode::no_core, "psicarve-rtcore was not found"};
                      }};
    sut.poll(job_, now_);
    now_ += TimeEstimator::kPatience;
    ASSERT_TRUE(comes_true(sut, job_, [&] { return !log_.messages().empty(); }));
    now_ += 10s;
    sut.poll(job_, now_);
    EXPECT_FALSE(sut.is_planning());
    EXPECT_FALSE(sut.planned(job_));
    EXPECT_EQ(log_.messages().size(), 1U);
}

}  // namespace
}  // namespace psicarve::session
