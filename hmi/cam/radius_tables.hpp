// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hmi/cam/slice_report.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Makes a job's two tables from sampled radii: pulses, never inside the core radius, the heads never closer
/// than their clearance, tip offsets subtracted.
class RadiusTables {
public:
    /// Sizes the tables of `table`, whose counts and joining are set. `scale`: mm per file unit.
    RadiusTables(const Profile& profile, JobTable& table, double scale);

    /// One layer's radii once round from R1's (for the right table: R2's, less half a turn) direction 0, file
    /// units. Different layers may be filled by different threads.
    void fill_left(std::size_t layer, std::span<const double> once_round);
    void fill_right(std::size_t layer, std::span<const double> once_round);

    /// After all layers are filled, before the next two: lets a spiral's rows begin where those before end.
    void join_rows();
    /// After all layers are filled: whether the heads can go where the tables send them.
    Result<void> check_travel(const std::string& source_name) const;
    /// After all layers are filled: counts the points at the core radius, then keeps the heads apart and
    /// counts the points that this has changed.
    void report(const Profile& profile, SliceReport& report);

private:
    struct Head {
        std::string name;
        double pulses_per_unit = 0.0;  ///< of the file
        double pulses_per_mm = 0.0;
        double tip_offset_pulses = 0.0;  ///< the real tip stands this much further out than counted
        std::int32_t least_pulses = 0;   ///< core radius and travel, counted
        AxisMotion motion;
        std::vector<std::int32_t>* radii = nullptr;
    };
    static Head make_head(const Profile& profile, Axis axis, double scale, std::vector<std::int32_t>& radii);
    void fill(Head& head, std::size_t layer, std::span<const double> once_round, std::size_t first);
    std::size_t first_direction(std::size_t layer) const noexcept;
    bool is_joint(std::size_t layer) const noexcept { return table_.joining == Joining::spiral && layer > 0; }
    void keep_apart(SliceReport& report);
    static double real_mm(const Head& head, std::int32_t counted_pulses) noexcept;

    JobTable& table_;
    Head left_;
    Head right_;
    double head_clearance_mm_;
};

}  // namespace psicarve::cam
