// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/carving_thread.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "shared/units.hpp"
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

// Psi goes to and fro by large steps with both tips near the axis, where tools reach furthest round.
TEST_F(CarvingThreads, LeaveWhatTwoHeadsLeaveThatCutInTurn) {
    for (const double error_deg : {0.0, 2.0, 10.0}) {
        profile_.head_r2_angle_error_deg = error_deg;
        profile_.tool = {ToolShape::ball, 2.0};
        const auto table = cam::built(shapes::cylinder(3.0, 0.0, 8.0, 90), profile_, cam::small(5, 61)).table;
        blob_ = job_blob_from_table(table);
        geometry_ = verify::JobGeometry::make(JobView::check(blob_).value(), profile_).value();
        StockMap stock = blank();
        StockMap plain_stock = blank();
        PieceCarver sut(*geometry_, profile_, stock);
        TurnByTurn plain(*geometry_, profile_, plain_stock);
        std::mt19937_64 random(7);
        verify::Positions at = geometry_->target(2, 0);
        const verify::Positions start = at;
        for (int i = 0; i < 20'000; ++i) {
            at[index_of(Axis::psi)] += static_cast<std::int64_t>(random() % 61) - 30;
            for (std::size_t h = 0; h < verify::kHeadCount; ++h)
                at[h] = static_cast<std::int64_t>(random() % 1000);
            if (random() % 40 == 0)
                at[index_of(Axis::y)] = start[index_of(Axis::y)] + static_cast<std::int64_t>(random() % 400);
            sut.settle(at, true);
            plain.settle(at, true);
        }
        sut.finish();
        plain.flush();
        EXPECT_GT(stock.removed_mm3(), 0.0);
        for (std::size_t row = 0; row < stock.row_count(); ++row) {
            ASSERT_TRUE(
                std::equal(stock.row(row).begin(), stock.row(row).end(), plain_stock.row(row).begin()))
                << error_deg << ' ' << row;
        }
    }
}

}  // namespace
}  // namespace psicarve::piece
