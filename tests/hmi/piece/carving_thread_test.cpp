// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/carving_thread.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::piece {
namespace {

class CarvingThreads : public ::testing::Test {
protected:
    CarvingThreads() {
        profile_.tool = {ToolShape::ball, 3.0};
        const auto table = cam::built(shapes::cylinder(9.0, 0.0, 8.0, 90), profile_, cam::small(9, 61)).table;
        blob_ = job_blob_from_table(table);
        geometry_ = verify::JobGeometry::make(JobView::check(blob_).value(), profile_).value();
    }
    StockMap blank() const { return blank_of(*geometry_, profile_, 180); }

    /// Each instant an axis steps; now and then the spindle is off.
    template <typename Settle>
    void tell(int instants, const Settle& settle) const {
        std::mt19937_64 random(23);
        verify::Positions at = geometry_->target(0, 0);
        for (int i = 0; i < instants; ++i) {
            const std::size_t axis = i % 3 != 0 ? index_of(Axis::psi) : random() % kAxisCount;
            at[axis] += axis == index_of(Axis::psi) || random() % 2 == 0 ? 1 : -1;
            settle(at, random() % 500 != 0);
        }
    }

    Profile profile_;
    std::vector<std::byte> blob_;
    std::optional<verify::JobGeometry> geometry_;
};

TEST_F(CarvingThreads, LeaveWhatTheCarverLeavesThatIsToldAtOnce) {
    StockMap plain_stock = blank();
    PieceCarver plain(*geometry_, profile_, plain_stock);
    tell(60'000, [&](const auto& at, bool spindle_on) { plain.settle(at, spindle_on); });
    plain.finish();
    StockMap stock = blank();
    PieceCarver carver(*geometry_, profile_, stock);
    CarvingThread sut(carver);
    std::thread teller(
        [&] { tell(60'000, [&](const auto& at, bool spindle_on) { sut.settle(at, spindle_on); }); });
    teller.join();
    sut.finish();
    EXPECT_GT(stock.removed_mm3(), 0.0);
    for (std::size_t row = 0; row < stock.row_count(); ++row) {
        ASSERT_TRUE(std::equal(stock.row(row).begin(), stock.row(row).end(), plain_stock.row(row).begin()))
            << row;
    }
}

TEST_F(CarvingThreads, EndWhereNothingWasTold) {
    StockMap stock = blank();
    PieceCarver carver(*geometry_, profile_, stock);
    CarvingThread sut(carver);
    sut.finish();
    EXPECT_EQ(stock.removed_mm3(), 0.0);
}

TEST_F(CarvingThreads, LeaveOutWhatWaitsWhereNobodyFinishes) {
    StockMap stock = blank();
    PieceCarver carver(*geometry_, profile_, stock);
    CarvingThread sut(carver);
    tell(9000, [&](const auto& at, bool spindle_on) { sut.settle(at, spindle_on); });
    SUCCEED() << "and ends";
}

/// What both heads' tools leave that cut in turn, at each place of psi and Y once.
class TurnByTurn {
public:
    TurnByTurn(const verify::JobGeometry& geometry, const Profile& profile, StockMap& stock)
        : geometry_(geometry), cut_(tool::tool_of(profile.tool, 1.0), stock) {}
    void settle(const verify::Positions& at, bool spindle_on) {
        constexpr std::size_t kPsi = index_of(Axis::psi);
        constexpr std::size_t kY = index_of(Axis::y);
        if (spindle_on && deepest_ && (*deepest_)[kPsi] == at[kPsi] && (*deepest_)[kY] == at[kY]) {
            for (std::size_t h = 0; h < verify::kHeadCount; ++h)
                (*deepest_)[h] = std::min((*deepest_)[h], at[h]);
            return;
        }
        flush();
        if (spindle_on) deepest_ = at;
    }
    void flush() {
        for (std::size_t h = 0; deepest_ && h < verify::kHeadCount; ++h) {
            const verify::HeadGeometry& head = geometry_.head(h);
            cut_.at(static_cast<double>(geometry_.direction(h, (*deepest_)[index_of(Axis::psi)])) *
                        geometry_.rad_per_pulse(),
                    static_cast<double>((*deepest_)[index_of(Axis::y)] + head.height_offset_pulses) /
                        geometry_.y_pulses_per_mm(),
                    std::max(0.0, head.real_mm((*deepest_)[h])));
        }
        deepest_.reset();
    }

private:
    const verify::JobGeometry& geometry_;
    ToolCut cut_;
    std::optional<verify::Positions> deepest_;
};

/// A few places next to each other, at each of which one of the tips or both stand next to the axis.
std::vector<verify::Positions> places_near_the_axis(const verify::Positions& start, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto by_lot = [&random](std::int64_t least, std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(least, most)(random);
    };
    std::vector<verify::Positions> places;
    verify::Positions at = start;
    at[index_of(Axis::psi)] += by_lot(0, 6400);
    for (int i = 0; i < 4; ++i) {
        at[index_of(Axis::psi)] += by_lot(1, 10);
        for (std::size_t h = 0; h < verify::kHeadCount; ++h)
            at[h] = by_lot(0, 2) == 0 ? by_lot(300, 400) : by_lot(0, 120);
        places.push_back(at);
    }
    return places;
}

// Two tools reach the same column at 64 degrees and more from each. Whether the one cuts there, where the
// piece stands about as far out as the tool is wide, hangs on what the other has cut before: the heads stand
// at different heights. More cuts leave no trace of it, so there are many blanks.
TEST_F(CarvingThreads, LeaveWhatTwoHeadsLeaveThatCutInTurn) {
    profile_.core_radius_mm = 0.2;
    profile_.head_r2_height_error_mm = 0.3;
    for (const ToolShape shape : {ToolShape::ball, ToolShape::flat}) {
        for (const double error_deg : {0.0, 2.0, 10.0, 30.0}) {
            profile_.head_r2_angle_error_deg = error_deg;
            profile_.tool = {shape, 2.0};
            const auto table =
                cam::built(shapes::cylinder(0.95, 0.0, 8.0, 90), profile_, cam::small(5, 61)).table;
            blob_ = job_blob_from_table(table);
            geometry_ = verify::JobGeometry::make(JobView::check(blob_).value(), profile_).value();
            std::size_t differing = 0;
            for (std::uint64_t seed = 1; seed <= 200; ++seed) {
                StockMap stock = blank();
                StockMap plain_stock = blank();
                PieceCarver sut(*geometry_, profile_, stock);
                TurnByTurn plain(*geometry_, profile_, plain_stock);
                for (const verify::Positions& at : places_near_the_axis(geometry_->target(2, 0), seed)) {
                    sut.settle(at, true);
                    plain.settle(at, true);
                }
                sut.finish();
                plain.flush();
                EXPECT_GT(stock.removed_mm3(), 0.0);
                for (std::size_t row = 0; row < stock.row_count(); ++row) {
                    for (std::size_t column = 0; column < stock.column_count(); ++column)
                        differing += stock.row(row)[column] != plain_stock.row(row)[column] ? 1 : 0;
                }
            }
            EXPECT_EQ(differing, 0U) << name_of(shape) << ", head 2 off by " << error_deg << " degrees";
        }
    }
}

}  // namespace
}  // namespace psicarve::piece
