// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/fitting_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hmi/slice/best_axis.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

/// The largest scale at which all corners, and so the whole model, are within the blank's circle.
double scale_in_blank(const model::Mesh& mesh, const slice::Placement& placement, const BlankProfile& blank) {
    const auto from = slice::source_coordinate(placement.up);
    const double off_x = blank.offset_x_mm;
    const double off_y = blank.offset_z_mm;
    const double power = blank.radius_mm * blank.radius_mm - off_x * off_x - off_y * off_y;
    if (!(power > 0.0)) return 0.0;  // the axis is outside
    double least = std::numeric_limits<double>::infinity();
    for (const model::Triangle& triangle : mesh.triangles) {
        for (const auto& vertex : triangle.vertices) {
            const double x = mesh.origin[from[0]] + double{vertex[from[0]]} - placement.axis_x;
            const double y = mesh.origin[from[1]] + double{vertex[from[1]]} - placement.axis_y;
            const double square = x * x + y * y;
            // |s p - off| = radius, solved for s without a difference of nearly equal numbers.
            const double along = x * off_x + y * off_y;
            const double root = std::sqrt(std::max(0.0, along * along + square * power));
            const double s = along > 0.0 ? (along + root) / square : power / (root - along);
            if (square > 0.0) least = std::min(least, s);
        }
    }
    return least;
}

}  // namespace

double fitting_scale(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                     SliceReport& report) {
    struct Limit {
        double scale;
        std::string name;
    };
    const double base_mm = profile.job.base_height_mm;
    const slice::Up up = plan.placement.up;
    const double height = slice::placed(up, mesh.facts.max)[2] - slice::placed(up, mesh.facts.min)[2];
    const double radius = slice::largest_radius(mesh, plan.placement);
    const double y_mm =
        mm_from_pulses(axis_motion(profile, Axis::y).travel_max_pulses, profile.y.pulses_per_mm);
    // The heads wait outside of the blank, which is as large as the model at least.
    const double clearance_mm = profile.blank.radius_mm > 0.0 ? 0.0 : profile.job.clearance_mm;
    const double cleared_mm = reachable_radius(profile, 1.0) - clearance_mm;
    std::vector<Limit> limits{{(y_mm - base_mm) / height, "axis y's travel"},
                              {cleared_mm / radius, "the heads' travel"}};
    if (profile.blank.height_mm > 0.0)
        limits.push_back({(profile.blank.height_mm - base_mm) / height, "the blank's height"});
    if (profile.blank.radius_mm > 0.0) {
        const bool is_off = profile.blank.reach_mm() > profile.blank.radius_mm;
        limits.push_back(
            {is_off ? scale_in_blank(mesh, plan.placement, profile.blank) : profile.blank.radius_mm / radius,
             is_off ? "the blank where it stands" : "the blank's radius"});
    }
    const Limit& least = *std::min_element(limits.begin(), limits.end(),
                                           [](const Limit& a, const Limit& b) { return a.scale < b.scale; });
    // A margin, so that rounding does not pass the limit.
    const double scale = least.scale * (1.0 - 1e-7);
    report.notes.push_back("fitted: " + decimals(scale * height, 2) + " mm high, up to " +
                           decimals(scale * radius, 2) + " mm from the axis; more does not fit " +
                           least.name);
    return scale;
}

}  // namespace psicarve::cam
