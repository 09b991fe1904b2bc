// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/gcode/arc.hpp"

namespace psicarve::gcode {

/// A line or an arc in the cross-section, by its distance from the axis and its direction from there. Points
/// of it are named by the share of its length, 0 to 1.
class PolarWay {
public:
    static PolarWay line(const PlanePoint& from, const PlanePoint& to) noexcept;
    /// `sweep_rad` > 0: counterclockwise. Where both ends' radii differ it goes evenly from one to the other.
    static PolarWay arc(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre,
                        double sweep_rad) noexcept;

    PlanePoint at(double share) const noexcept;
    double length_mm() const noexcept { return length_mm_; }
    /// How far it is turned about the axis by there, from its begin, with all turns. Requires that no point
    /// lies on the axis.
    double turned_rad(double share) const noexcept;
    /// The share of its point that is nearest to the axis.
    double nearest_share() const noexcept;
    /// No point between both is nearer to the axis.
    double least_radius_mm(double from, double to) const noexcept;
    /// A machine that goes from one point to the other evenly in distance and direction is never further than
    /// this from where it should be at that time. The bound is derived beside the code.
    double deviation_mm(double from, double to) const noexcept;

private:
    PolarWay() = default;
    struct Range {
        double least_mm;
        double most_mm;
    };
    Range range(double from, double to) const noexcept;
    double line_deviation_mm(double from, double to) const noexcept;
    double arc_deviation_mm(double from, double to) const noexcept;
    double radius_mm(double share) const noexcept;
    double angle_rad(double share) const noexcept;
    double direction_rad(double share) const noexcept;

    bool is_arc_ = false;
    PlanePoint from_;
    PlanePoint to_;
    double length_mm_ = 0.0;
    // Of a line: where its perpendicular from the axis meets it, along it from its begin.
    double foot_mm_ = 0.0;
    double distance_mm_ = 0.0;
    // Of an arc.
    PlanePoint centre_;
    double centre_mm_ = 0.0;  ///< from the axis
    double centre_rad_ = 0.0;
    double start_radius_mm_ = 0.0;
    double end_radius_mm_ = 0.0;
    double start_rad_ = 0.0;
    double sweep_rad_ = 0.0;
};

}  // namespace psicarve::gcode
