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
}

}  // namespace
}  // namespace psicarve::piece
