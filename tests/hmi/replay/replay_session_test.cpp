// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/replay_session.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

using test::PlainTrace;
using test::RecordedRun;

class ReplayOnDesk : public RecordedRun {
protected:
    template <typename Condition>
    bool comes_true(Condition condition) {
        return eventually([&] {
            sut_.poll(ReplaySession::Clock::now());
            return condition();
        });
    }
    bool settles() {
        return comes_true([&] { return sut_.is_settled(); });
    }
    std::string all_messages() const {
        std::string text;
        for (const session::Message& message : log_.messages()) text += "\n  " + in_english(message.what);
        return text;
    }

    session::MessageLog log_;
    ReplaySession sut_{log_};
};

TEST_F(ReplayOnDesk, OpensATraceShowsAnyTimeAndLeavesAgain) {
    record();
    EXPECT_FALSE(sut_.is_open());
    sut_.open(trace(), Profile{});
    EXPECT_TRUE(sut_.is_opening());
    ASSERT_TRUE(comes_true([&] { return sut_.is_open(); })) << all_messages();
    ASSERT_TRUE(settles());
    EXPECT_EQ(sut_.shown().time_ns, 0);
    const PlainTrace plain{trace()};
    for (const int part : {7, 3, 9, 1, 10}) {
        sut_.clock().seek(sut_.facts().end_ns / 10 * part);
        ASSERT_TRUE(settles());
        const auto& expected = plain.at(sut_.clock().now_ns());
        for (std::size_t k = 0; k < kAxisCount; ++k)
            EXPECT_EQ(sut_.view().status->position_pulses[k], expected.position_pulses[k]);
        EXPECT_EQ(sut_.view().status->signals, expected.levels);
    }
    EXPECT_TRUE(sut_.view().is_heard());
    const auto edition = sut_.edition();
    sut_.leave();
    EXPECT_FALSE(sut_.is_open());
    EXPECT_GT(sut_.edition(), edition);
}

TEST_F(ReplayOnDesk, TakesAJobLaterAndStaysWhereItWas) {
    record();
    sut_.open(trace(), Profile{});
    ASSERT_TRUE(comes_true([&] { return sut_.is_open(); })) << all_messages();
    EXPECT_EQ(sut_.carving(), nullptr);
    sut_.clock().seek(sut_.facts().end_ns);
    sut_.add_job(job());
    ASSERT_TRUE(comes_true([&] { return sut_.carving() != nullptr; })) << all_messages();
    EXPECT_EQ(sut_.clock().now_ns(), sut_.facts().end_ns);
    ASSERT_TRUE(settles());
    EXPECT_EQ(sut_.carving_ratio(), 1.0);
    const auto blank = static_cast<float>(sut_.carving()->geometry().blank_radius_mm());
    EXPECT_LT(sut_.carving()->surface().radii_mm(0)[3], blank);
    sut_.clock().seek(0);
    ASSERT_TRUE(settles());
    EXPECT_EQ(sut_.carving()->surface().radii_mm(0)[3], blank);
    sut_.clock().seek(sut_.facts().end_ns / 2);
    ASSERT_TRUE(comes_true([&] {
        if (sut_.shown().place || sut_.clock().now_ns() >= sut_.facts().end_ns) return true;
        if (sut_.is_settled()) sut_.clock().seek(sut_.clock().now_ns() + sut_.facts().end_ns / 50);
        return false;
    }));
    ASSERT_TRUE(sut_.shown().place);
    sut_.clock().seek(sut_.clock().now_ns());
    const auto layer = sut_.shown().place->layer;
    sut_.step_layer(layer + 1 < kLayers ? 1 : -1);
    ASSERT_TRUE(settles());
    EXPECT_NE(sut_.shown().place->layer, layer);
}

TEST_F(ReplayOnDesk, ASnapshotOpensAtItsEnd) {
    record();
    sut_.open(snapshot(), Profile{});
    ASSERT_TRUE(comes_true([&] { return sut_.is_open(); })) << all_messages();
    ASSERT_TRUE(settles());
    EXPECT_EQ(sut_.shown().time_ns, sut_.facts().end_ns);
    EXPECT_EQ(sut_.view().status->points_done, std::uint64_t{kLayers} * kPoints);
}

TEST_F(ReplayOnDesk, KeepsWhatIsOpenWhenAnotherFileIsNone) {
    record();
    sut_.open(trace(), Profile{});
    ASSERT_TRUE(comes_true([&] { return sut_.is_open(); }));
    std::ofstream(file("bad.snap")) << "nonsense";
    sut_.open(file("bad.snap"), Profile{});
    ASSERT_TRUE(comes_true([&] { return !sut_.is_opening(); }));
    EXPECT_NE(all_messages().find("bad.snap"), std::string::npos);
    EXPECT_TRUE(sut_.is_open());
    sut_.open(trace(), Profile{});
    sut_.cancel();
    ASSERT_TRUE(comes_true([&] { return !sut_.is_opening(); }));
    EXPECT_TRUE(sut_.is_open());
}

TEST_F(ReplayOnDesk, PlaysToTheEnd) {
    record();
    sut_.open(trace(), Profile{});
    ASSERT_TRUE(comes_true([&] { return sut_.is_open(); }));
    sut_.want_looks(true);
    sut_.clock().set_speed(100.0);
    sut_.clock().play();
    std::int64_t last_ns = 0;
    ASSERT_TRUE(comes_true([&] {
        EXPECT_GE(sut_.shown().time_ns, last_ns);
        last_ns = sut_.shown().time_ns;
        return sut_.shown().time_ns == sut_.facts().end_ns;
    }));
    EXPECT_FALSE(sut_.clock().is_playing());
    EXPECT_FALSE(sut_.history().looks().empty());
}

}  // namespace
}  // namespace psicarve::replay
