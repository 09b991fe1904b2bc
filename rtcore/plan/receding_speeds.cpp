// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/receding_speeds.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::plan {

void RecedingSpeeds::hold(CurvePart first) {
    held_ = std::move(first);
    end_pulses_ = held_->points.front().pulses;
    for (std::size_t timing = 0; timing < kTimingCount; ++timing)
        begin2_[timing] = std::min(held_->bound2[timing].front(), held_->rest_begin2);
}

void RecedingSpeeds::settle(CurvePart next, std::vector<PathPiece>& pieces) {
    gather(&next);
    solve();
    solve_rest();
    add_pieces(true, pieces);
    for (std::size_t timing = 0; timing < kTimingCount; ++timing)
        begin2_[timing] = speed2_[timing][held_->cells.size()];
    held_ = std::move(next);
}

void RecedingSpeeds::end(std::vector<PathPiece>& pieces) {
    gather(nullptr);
    solve();
    add_pieces(false, pieces);
    held_.reset();
}

void RecedingSpeeds::gather(const CurvePart* behind) {
    const auto append = [](auto& all, const auto& some) { all.insert(all.end(), some.begin(), some.end()); };
    cells_ = held_->cells;
    if (behind != nullptr) append(cells_, behind->cells);
    const double rest2 = behind != nullptr ? behind->rest_end2 : held_->rest_end2;
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        inner2_[timing] = held_->inner2[timing];
        bound2_[timing] = held_->bound2[timing];
        if (behind != nullptr) {
            const double met2 = bound2_[timing].back();
            bound2_[timing].pop_back();
            append(inner2_[timing], behind->inner2[timing]);
            append(bound2_[timing], behind->bound2[timing]);
            double& joint2 = bound2_[timing][held_->cells.size()];
            joint2 = std::min(joint2, met2);
        }
        bound2_[timing].front() = begin2_[timing];
        bound2_[timing].back() = std::min(bound2_[timing].back(), rest2);
    }
}

void RecedingSpeeds::solve() {
    timing_.set_path(cells_);
    const std::array<SpeedLimits, kTimingCount> limits{SpeedLimits{bound2_[0], inner2_[0]},
                                                       SpeedLimits{bound2_[1], inner2_[1]}};
    timing_.solve_both(limits, speed2_);
    for (std::size_t i = 0; i < speed2_[1].size(); ++i)
        speed2_[1][i] = std::max(speed2_[1][i], speed2_[0][i]);
}

// Of the part held alone.
void RecedingSpeeds::solve_rest() {
    std::vector<double> bound2 = held_->bound2[1];
    bound2.back() = std::min(bound2.back(), held_->rest_end2);
    timing_.set_path(held_->cells);
    timing_.solve({bound2, held_->inner2[1]}, rest2_);
}

void RecedingSpeeds::add_pieces(bool is_open, std::vector<PathPiece>& pieces) {
    const CurvePart& part = *held_;
    PieceMaker maker(*limits_, part.points, 0, part.begin_at, pieces);
    maker.begin_at(end_pulses_);
    for (std::size_t j = 0; j < part.cells.size(); ++j) {
        const double length = part.cells[j].length;
        const std::array<double, 2> rest2 =
            is_open ? std::array{rest2_[j], rest2_[j + 1]} : std::array{0.0, 0.0};
        maker.begin_cell(part.cells[j], part.cell_at[j], {speed2_[0][j], speed2_[1][j]},
                         {speed2_[0][j + 1], speed2_[1][j + 1]}, rest2);
        const double along = part.point_at[j] == PathPiece::kNoPoint ? 0.0 : part.point_along[j];
        if (along > 0.0) maker.add(0.0, along, part.point_at[j]);
        if (along < length) maker.add(along, length, PathPiece::kNoPoint);
    }
    end_pulses_ = maker.at_pulses();
}

}  // namespace psicarve::plan
