// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::rough {

inline constexpr std::size_t kHeads = 2;

/// A head of the machine, for roughing: a tip's real radius is its counted one plus its offset.
struct RoughHead {
    double pulses_per_mm = 1.0;
    double tip_mm = 0.0;
    double turn_rad = 0.0;    ///< it faces this much further than its cell's direction
    double height_mm = 0.0;   ///< its tip stands this much above Y
    std::int32_t least = 0;   ///< the furthest in that it may go, counted: to the core or its travel's end
    std::int32_t travel = 0;  ///< the furthest out that it may go, counted

    double real_mm(std::int32_t counted) const noexcept {
        return static_cast<double>(counted) / pulses_per_mm + tip_mm;
    }
    /// The least counted radius whose real one is at least this.
    std::int32_t counted_outside(double real_mm) const noexcept;
    /// The same, within the head's travel: a head may not reach what the other one carves.
    std::int32_t standing_outside(double real_mm) const noexcept;
};

/// A table's level layers as full circles: how far in each head's tip may go in each of the 2 * (points - 1)
/// directions ("cells"), as counted. A layer of a table covers only one half for each head; in the other half
/// a head takes the other one's radii, and where that one's errors of angle and height could matter, the
/// outermost radius near the cell.
class Rings {
public:
    /// Requires a table of level layers.
    Rings(const JobTable& table, const Profile& profile);

    std::size_t ring_count() const noexcept { return heights_.size(); }
    std::size_t cell_count() const noexcept { return cells_; }
    std::size_t point_count() const noexcept { return cells_ / 2 + 1; }
    const RoughHead& head(std::size_t h) const noexcept { return heads_[h]; }
    std::int64_t height_pulses(std::size_t ring) const noexcept { return heights_[ring]; }
    double height_mm(std::size_t ring) const noexcept {
        return static_cast<double>(heights_[ring]) / y_pulses_per_mm_;
    }
    /// The least distance between two neighbouring rings; 0 where there is but one.
    double pitch_mm() const noexcept;
    std::int32_t tip(std::size_t h, std::size_t ring, std::size_t cell) const noexcept {
        return tips_[h][ring * cells_ + cell];
    }
    double least_tip_mm() const noexcept;
    /// The outermost real radius of either head at these rings in this direction, within the heads' errors of
    /// height and angle, and one ring and one direction more.
    double most_about_mm(std::size_t low_ring, std::size_t high_ring, std::size_t cell) const noexcept;
    /// Direction of a cell's middle.
    double direction_rad(std::size_t cell) const noexcept;
    /// Whether both heads have no mounting errors: then either can carve the other's half.
    bool heads_agree() const noexcept { return heads_agree_; }

private:
    void take(const JobTable& table, std::size_t h);
    void fill_other_half(const JobTable& table, std::size_t h);

    std::size_t cells_;
    double y_pulses_per_mm_;
    bool heads_agree_;
    std::array<RoughHead, kHeads> heads_;
    std::vector<std::int64_t> heights_;
    std::array<std::vector<std::int32_t>, kHeads> tips_;
};

/// The cell that head R1 faces at the first point of a job's layer.
std::size_t first_cell(Joining joining, std::size_t point_count, std::size_t layer) noexcept;

}  // namespace psicarve::rough
