// SPDX-License-Identifier: GPL-3.0-or-later
// What a tool that has a size leaves, at any time of a recording.
#include "hmi/replay/tool_timeline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hmi/piece/expected_piece.hpp"
#include "hmi/replay/replay_piece.hpp"
#include "hmi/replay/trace_recording.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

std::vector<float> cells_of(const piece::StockMap& stock) {
    std::vector<float> cells;
    for (std::size_t row = 0; row < stock.row_count(); ++row)
        cells.insert(cells.end(), stock.row(row).begin(), stock.row(row).end());
    return cells;
}

double most_apart(const std::vector<float>& a, const std::vector<float>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, static_cast<double>(std::abs(a.at(i) - b.at(i))));
    return most;
}

class ToolReplay : public test::RecordedRun {
protected:
    static JobPointer job_of(std::uint32_t layers, std::uint32_t points) {
        Profile profile;
        profile.tool = {ToolShape::ball, 3.0};
        auto made = cam::prepare_blob(job_blob_from_table(two_process::lobed_job(layers, points, profile)),
                                      profile, "lobed");
        EXPECT_TRUE(made);
        return std::make_shared<const cam::PreparedJob>(std::move(*made));
    }
    static piece::StockMap expected(const JobPointer& job) {
        const auto geometry = verify::JobGeometry::make(job->view, job->profile).value();
        return piece::expected_piece(geometry, job->profile,
                                     piece::view_blank_of(geometry, job->profile, piece::kViewColumns),
                                     nullptr, {})
            .value();
    }
    /// To and fro, each time against a piece that went straight there.
    static void expect_same_either_way(const std::shared_ptr<const ToolTimeline>& timeline,
                                       std::int64_t end) {
        PieceInTime scrubbed{timeline};
        std::mt19937_64 random{5};
        std::uniform_int_distribution<std::int64_t> any_time{0, end};
        for (int i = 0; i < 25; ++i) {
            const std::int64_t time = i == 10 ? end : any_time(random);
            while (!scrubbed.go(time, 333)) {
            }
            PieceInTime straight{timeline};
            const std::size_t all = timeline->place_count();
            for (std::int64_t part = 1; part < 4; ++part) straight.go(time / 4 * part, all);
            ASSERT_TRUE(straight.go(time, all));
            ASSERT_EQ(cells_of(scrubbed.stock()), cells_of(straight.stock())) << time;
        }
        ASSERT_TRUE(scrubbed.go(-1, 1));
        EXPECT_EQ(cells_of(scrubbed.stock()), cells_of(timeline->blank()));
    }
};

TEST_F(ToolReplay, ThePieceOfATraceIsTheSameForwardsAndBackwards) {
    record();
    const auto recording = open_recording({trace(), {}, Profile{}}, {});
    ASSERT_TRUE(recording);
    const JobPointer job = job_of(kLayers, kPoints);
    const auto timeline = ToolTimeline::of_trace(job, (*recording)->index(), {});
    ASSERT_TRUE(timeline);
    const std::int64_t end_ns = (*recording)->facts().end_ns;
    expect_same_either_way(*timeline, end_ns);
    PieceInTime sut{*timeline};
    ASSERT_TRUE(sut.go(end_ns, (*timeline)->place_count()));
    EXPECT_LT(most_apart(cells_of(sut.stock()), cells_of(expected(job))), 0.15) << "a cell and the path's";
}

TEST_F(ToolReplay, ThePieceOfAJobComesLayerByLayerEitherWay) {
    const JobPointer job = job_of(40, 61);
    const auto timeline = ToolTimeline::of_job(job, {});
    ASSERT_TRUE(timeline);
    expect_same_either_way(*timeline, 41);
    PieceInTime sut{*timeline};
    ASSERT_TRUE(sut.go(20, (*timeline)->place_count()));
    EXPECT_EQ((*timeline)->places_until(0), 0U);
    const double half = sut.stock().removed_mm3();
    EXPECT_GT(half, 0.0);
    ASSERT_TRUE(sut.go(40, (*timeline)->place_count()));
    EXPECT_GT(sut.stock().removed_mm3(), half);
    EXPECT_LT(most_apart(cells_of(sut.stock()), cells_of(expected(job))), 0.05);
}

TEST_F(ToolReplay, OfALongOneHasFewerPlacesAndNearlyTheSamePiece) {
    const JobPointer job = job_of(40, 61);
    const auto timeline = ToolTimeline::of_job(job, {}, 6'000);
    ASSERT_TRUE(timeline);
    EXPECT_LE((*timeline)->place_count(), 6'000U);
    EXPECT_GT((*timeline)->place_count(), 2'000U);
    PieceInTime sut{*timeline};
    ASSERT_TRUE(sut.go(40, (*timeline)->place_count()));
    EXPECT_LT(most_apart(cells_of(sut.stock()), cells_of(expected(job))), 0.2);
}

TEST_F(ToolReplay, CanBeCancelled) {
    const auto cancelled = ToolTimeline::of_job(job_of(40, 61), [](double done) { return done < 0.5; });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
}

TEST_F(ToolReplay, TheNewestWishCounts) {
    const auto timeline = ToolTimeline::of_job(job_of(40, 61), {});
    ASSERT_TRUE(timeline);
    ReplayPiece sut{*timeline};
    for (const std::int64_t time : {40, 3, 17, 0, 25}) sut.want(time);
    ASSERT_TRUE(eventually([&] {
        sut.want(25);
        return sut.shows(25);
    }));
    EXPECT_FALSE(sut.shows(24));
    sut.front().take_changed_rows();
    PieceInTime straight{*timeline};
    straight.go(25, (*timeline)->place_count());
    EXPECT_EQ(cells_of(sut.front().shown()), cells_of(straight.stock()));
}

}  // namespace
}  // namespace psicarve::replay
