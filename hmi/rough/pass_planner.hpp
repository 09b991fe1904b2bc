// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/rough/raiser.hpp"
#include "hmi/rough/rings.hpp"
#include "hmi/rough/rough_stock.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::rough {

struct PassSettings {
    Joining joining = Joining::continuous;
    double allowance_mm = 0.0;
    double stepdown_mm = 1.0;
    double stepover_mm = 0.0;  ///< between two rings at most; 0: every ring
    double feed_mm_s = 20.0;
    double known_blank_mm = 0.0;  ///< no material is further out (known_blank_mm of shared/job/outside.hpp)
};

/// One layer of a roughing pass in the job's form.
struct RoughLayer {
    std::size_t ring = 0;
    std::array<std::vector<std::int32_t>, kHeads> radii;  ///< by head and point, counted
    /// The same with heads raised out of the blank where that is sooner, and by how much [s].
    std::array<std::vector<std::int32_t>, kHeads> raised;
    double saved_s = 0.0;
};

struct RoughPass {
    double depth_mm = 0.0;
    std::vector<RoughLayer> layers;
    std::uint64_t cut_points = 0;  ///< where the tool has material to remove
    std::uint64_t air_points = 0;  ///< where it passes over cleared space
};

/// The greatest ridge that the tool leaves between two cuts this far apart [mm].
double ridge_mm(const ToolProfile& tool, double apart_mm);

/// Plans a pass to a depth in the stock that the passes before have left, and cuts it out of that.
///
///     tip over a cell = max(finished tip + allowance, depth)
///
/// A ring is carved where the tool would cut more than a trifle there; a ring between two that the stepover
/// requires, only where more than the ridge between these and a quarter of the stepdown still stands. Within
/// a ring a head that has nothing to cut passes clear over it, along a hull that never rises or falls
/// steeply, or outside the blank where that is sooner (Raiser).
class PassPlanner {
public:
    PassPlanner(const Rings& rings, RoughStock& stock, const Profile& profile, const PassSettings& settings);

    /// `first_layer`: of the job, with which the pass begins.
    RoughPass plan(double depth_mm, std::size_t first_layer);
    /// One more layer without a cut: as the last of `pass`, or where both heads reach far enough out.
    RoughLayer idle_layer(const RoughPass& pass, std::size_t layer);

private:
    struct Row;
    std::int32_t target(std::size_t h, std::size_t ring, std::size_t cell) const noexcept;
    bool is_in_reach(std::size_t ring, std::size_t layer) const noexcept;
    bool has_work(std::size_t ring, double least_mm, std::size_t every);
    void cut_ring(std::size_t ring);
    std::vector<std::size_t> rings_with_work();
    RoughLayer make_layer(RoughPass& pass, std::size_t ring, std::size_t layer);
    void find_cuts(RoughPass& pass, Row& row);
    void lift_where_clear(Row& row) const;
    void clear_link(Row& row, std::size_t ring_before, std::size_t point) const;
    void clear_end(RoughLayer& before, std::size_t ring, std::size_t layer) const;
    void cut_row(const Row& row);
    TipPlace place_of(const Row& row, std::size_t point) const;

    const Rings& rings_;
    RoughStock& stock_;
    PassSettings settings_;
    Raiser raiser_;
    double blank_mm_;
    double tool_mm_;    ///< its diameter; 0: a point
    double trifle_mm_;  ///< a smaller cut is not worth the way
    std::vector<std::size_t> coarse_;
    double ridge_mm_ = 0.0;
    double depth_mm_ = 0.0;
    std::array<std::int32_t, kHeads> allowance_{};
    std::array<std::int32_t, kHeads> depth_{};
};

}  // namespace psicarve::rough
