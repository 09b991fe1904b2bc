// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/stop_listener.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace psicarve::supervisor {
namespace {

class StopListenerTest : public testing::Test {
protected:
    void SetUp() override { make(segment_, name_); }
    void TearDown() override {
        EXPECT_TRUE(Segment::remove(name_));
        if (other_ != nullptr) {
            EXPECT_TRUE(Segment::remove(name_ + "-other"));
        }
    }
    static void make(std::shared_ptr<Segment>& segment, const std::string& name) {
        SegmentOptions options;
        options.name = name;
        options.capacity_layers = 1;
        options.capacity_points = 2;
        auto made = Segment::create_or_attach(options);
        ASSERT_TRUE(made) << made.error().message;
        segment = std::make_shared<Segment>(std::move(*made));
    }
    void make_other() { make(other_, name_ + "-other"); }

    /// As the tick sees them.
    std::uint32_t stops() const { return static_cast<std::uint32_t>(urgent_.stop_word.load()); }
    std::uint32_t emergency_stops() const { return static_cast<std::uint32_t>(urgent_.estop_word.load()); }
    template <typename Condition>
    static bool comes(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{60};
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::yield();
        }
        return true;
    }

    std::string name_ = "/psicarve-test-ear-" + std::to_string(getpid());
    std::shared_ptr<Segment> segment_;
    std::shared_ptr<Segment> other_;
    cycle::UrgentWords urgent_;
};

TEST_F(StopListenerTest, HandsOnWhatIsAskedForFromNowOnAndEachOnce) {
    request_stop(*segment_);
    StopListener listener{segment_, urgent_};
    EXPECT_FALSE(listener.look());
    request_stop(*segment_);
    EXPECT_TRUE(listener.look());
    EXPECT_FALSE(listener.look());
    request_emergency_stop(*segment_);
    EXPECT_TRUE(listener.look());
    EXPECT_EQ(stops(), 1U);
    EXPECT_EQ(emergency_stops(), 1U);
}

// Whoever overwrites a word has asked for a stop, and nobody's later one is lost for it.
TEST_F(StopListenerTest, HandsOnAnyChange) {
    StopListener listener{segment_, urgent_};
    for (const std::uint32_t word : {0xFFFF'FFFFU, 0U, 0x8000'0001U, 0x8000'0000U}) {
        const std::uint32_t before = stops();
        segment_->header().stop_requests.store(word);
        EXPECT_TRUE(listener.look());
        EXPECT_NE(stops(), before);
    }
}

TEST_F(StopListenerTest, TurnsToAnotherSegmentWithoutAStopAndMissesNone) {
    request_stop(*segment_);
    StopListener listener{segment_, urgent_};
    request_stop(*segment_);
    listener.look();
    request_emergency_stop(*segment_);
    make_other();
    request_stop(*other_);
    listener.turn_to(other_);
    EXPECT_EQ(stops(), 2U) << "asked for in the new one before we came";
    EXPECT_EQ(emergency_stops(), 1U) << "asked for in the old one at the last moment";
    EXPECT_FALSE(listener.look());
    request_stop(*segment_);
    EXPECT_FALSE(listener.look());
    request_emergency_stop(*other_);
    EXPECT_TRUE(listener.look());
    EXPECT_EQ(stops(), 2U);
    EXPECT_EQ(emergency_stops(), 2U);
}

TEST_F(StopListenerTest, CountsWhatASenderHadSeenAsTheTickDoes) {
    request_stop(*segment_);
    StopListener listener{segment_, urgent_};
    const auto seen_now = [&](const Segment& segment) {
        ReceivedCommand command{};
        command.stops_seen = stops_seen(segment);
        cycle::Request request{};
        listener.note_stops_seen(command, request);
        EXPECT_EQ(request.has_sender, 1);
        return std::pair{request.stops_seen, request.emergency_stops_seen};
    };
    request_stop(*segment_);
    EXPECT_EQ(seen_now(*segment_), std::pair(1U, 0U));
    EXPECT_EQ(stops(), 1U) << "it comes before whatever its sender asks for next";
    make_other();
    listener.turn_to(other_);
    request_emergency_stop(*other_);
    EXPECT_EQ(seen_now(*other_), std::pair(1U, 1U));
}

TEST_F(StopListenerTest, ListensWithoutBeingLookedAfterWhateverSegmentItIs) {
    StopListener listener{segment_, urgent_};
    listener.listen();
    request_stop(*segment_);
    EXPECT_TRUE(comes([&] { return stops() == 1; }));
    make_other();
    listener.turn_to(other_);
    request_emergency_stop(*other_);
    EXPECT_TRUE(comes([&] { return emergency_stops() == 1; }));
    EXPECT_EQ(stops(), 1U);
}

TEST_F(StopListenerTest, CountsNoChangeTwiceHoweverManyListen) {
    constexpr std::uint32_t kChanges = 300;
    StopListener listener{segment_, urgent_};
    listener.listen();
    std::atomic<bool> must_end{false};
    std::thread other{[&] {
        while (!must_end) {
            listener.look();
            listener.note_crowd();
        }
    }};
    for (std::uint32_t count = 1; count <= kChanges; ++count) {
        request_stop(*segment_);
        if (comes([&] { return stops() == count; })) continue;
        ADD_FAILURE() << stops() << " of " << count;
        break;
    }
    must_end = true;
    other.join();
    EXPECT_EQ(stops(), kChanges);
    EXPECT_EQ(emergency_stops(), 0U);
}

}  // namespace
}  // namespace psicarve::supervisor
