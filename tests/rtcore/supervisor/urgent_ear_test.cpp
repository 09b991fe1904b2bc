// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/urgent_ear.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace psicarve::supervisor {
namespace {

class UrgentEarTest : public testing::Test {
protected:
    void SetUp() override {
        SegmentOptions options;
        options.name = name_;
        options.capacity_layers = 1;
        options.capacity_points = 2;
        auto made = Segment::create_or_attach(options);
        ASSERT_TRUE(made) << made.error().message;
        segment_ = std::make_shared<Segment>(std::move(*made));
    }
    void TearDown() override { EXPECT_TRUE(Segment::remove(name_)); }
    std::uint32_t stops() const { return urgent_.stop_requests.load(); }
    std::uint32_t emergency_stops() const { return urgent_.estop_requests.load(); }

    std::string name_ = "/psicarve-test-ear-" + std::to_string(getpid());
    std::shared_ptr<Segment> segment_;
    cycle::UrgentWords urgent_;
};

TEST_F(UrgentEarTest, HandsOnWhatIsAskedForFromNowOnAndEachOnce) {
    request_stop(*segment_);
    UrgentEar ear{segment_, urgent_, UrgentEar::as_they_stand(*segment_)};
    EXPECT_FALSE(ear.look());
    request_stop(*segment_);
    EXPECT_TRUE(ear.look());
    EXPECT_FALSE(ear.look());
    request_emergency_stop(*segment_);
    EXPECT_TRUE(ear.look());
    EXPECT_EQ(stops(), 1U);
    EXPECT_EQ(emergency_stops(), 1U);
}

TEST_F(UrgentEarTest, HearsWhatANewSegmentWasAskedBeforeItCame) {
    request_emergency_stop(*segment_);
    UrgentEar ear{segment_, urgent_, UrgentEar::Seen{}};
    EXPECT_TRUE(ear.look());
    EXPECT_EQ(emergency_stops(), 1U);
}

TEST_F(UrgentEarTest, ListensWithoutBeingLookedAfter) {
    UrgentEar ear{segment_, urgent_, UrgentEar::as_they_stand(*segment_)};
    ear.listen();
    request_stop(*segment_);
    while (stops() == 0) std::this_thread::yield();
    request_emergency_stop(*segment_);
    while (emergency_stops() == 0) std::this_thread::yield();
    EXPECT_EQ(stops(), 1U);
}

// Two who see the same change hand it on once; each change that one of them has seen alone is handed on.
TEST_F(UrgentEarTest, CountsNoChangeTwiceHoweverManyLook) {
    constexpr std::uint32_t kChanges = 300;
    UrgentEar ear{segment_, urgent_, UrgentEar::as_they_stand(*segment_)};
    ear.listen();
    std::atomic<bool> must_end{false};
    std::vector<std::thread> others;
    for (int i = 0; i < 2; ++i) {
        others.emplace_back([&] {
            while (!must_end) ear.look();
        });
    }
    for (std::uint32_t i = 0; i < kChanges; ++i) {
        const std::uint32_t before = stops();
        request_stop(*segment_);
        while (stops() == before) std::this_thread::yield();
    }
    must_end = true;
    for (std::thread& other : others) other.join();
    EXPECT_EQ(stops(), kChanges);
    EXPECT_EQ(emergency_stops(), 0U);
}

}  // namespace
}  // namespace psicarve::supervisor
