// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/core_share.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/job_plan.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

constexpr double kWorthAWarning = 0.1;

struct FileUnit {
    const char* question;
    double mm;
};
/// The larger first: a core's width in inches is far beyond any travel in metres.
constexpr std::array<FileUnit, 2> kOtherUnits{
    {{"metres (--scale 1000)", 1000.0}, {"inches (--scale 25.4)", 25.4}}};

/// How far in the tips come, and what limits them.
struct LeastRadius {
    double mm = 0.0;
    bool is_travel = false;  ///< the end of a head's travel; else the core radius
};
/// Of the head that stays further out.
LeastRadius least_radius(const Profile& profile) {
    LeastRadius least{profile.core_radius_mm, false};
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const LinearAxisProfile& linear = head == Axis::r1 ? profile.r1 : profile.r2;
        const std::int32_t pulses = least_radius_pulses(profile, head);
        const double mm = mm_from_pulses(pulses, linear.pulses_per_mm) + linear.tip_mm();
        if (pulses > core_radius_pulses(profile, head) && mm > least.mm) least = {mm, true};
    }
    return least;
}

std::string radius_of(const LeastRadius& least) {
    return least.is_travel ? "the radius of " + mm_text(least.mm) + " at which the heads' travel ends"
                           : "the core radius of " + mm_text(least.mm);
}

const char* way_further_in(const LeastRadius& least) {
    return least.is_travel ? "travel_mm that goes further in" : "smaller core_radius_mm";
}

/// The unit, if any, with which the machine could carve the model.
std::optional<FileUnit> probable_unit(const Profile& profile, const JobOptions& options,
                                      double model_radius_mm, const SliceReport& report) {
    if (options.height_mm || options.scale || options.fits || !report.body_json.empty()) return std::nullopt;
    const double top_mm =
        mm_from_pulses(axis_motion(profile, Axis::y).travel_max_pulses, profile.y.pulses_per_mm);
    const auto* const found = std::find_if(kOtherUnits.begin(), kOtherUnits.end(), [&](const FileUnit& unit) {
        return model_radius_mm * unit.mm > least_radius(profile).mm &&
               model_radius_mm * unit.mm <= reachable_radius(profile, 1.0) &&
               profile.job.base_height_mm + report.box_mm[2] * unit.mm <= top_mm;
    });
    if (found == kOtherUnits.end()) return std::nullopt;
    return *found;
}

}  // namespace

std::int32_t least_radius_pulses(const Profile& profile, Axis head) {
    // A tip that stands far out reaches the core radius only where the axis cannot go: it stops at the end of
    // its travel and leaves a little more of the core.
    return static_cast<std::int32_t>(
        std::max(core_radius_pulses(profile, head), axis_motion(profile, head).travel_min_pulses));
}

CoreShare core_share(const Profile& profile, const JobTable& table) {
    const std::size_t first = finishing_layer(table) * table.point_count;
    CoreShare share;
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const auto& radii = head == Axis::r1 ? table.r_left_pulses : table.r_right_pulses;
        const auto begin = radii.begin() + static_cast<std::ptrdiff_t>(first);
        share.points +=
            static_cast<std::uint64_t>(std::count(begin, radii.end(), least_radius_pulses(profile, head)));
        share.all += static_cast<std::uint64_t>(radii.end() - begin);
    }
    return share;
}

void warn_about_core(const Profile& profile, const CoreShare& share, SliceReport& report) {
    const double part =
        share.all > 0 ? static_cast<double>(share.points) / static_cast<double>(share.all) : 0.0;
    if (part <= kWorthAWarning) return;
    const LeastRadius least = least_radius(profile);
    report.warnings.push_back(decimals(part * 100.0, 1) + " % of the points stand at " + radius_of(least) +
                              ": what lies inside it is not carved; a larger model (--scale, --height, a "
                              "picture's --diameter) or a " +
                              way_further_in(least) + " loses less");
}

Error core_alone(const std::string& source_name, const Profile& profile, const JobOptions& options,
                 double model_radius_mm, const SliceReport& report) {
    const auto& box_mm = report.box_mm;
    const LeastRadius least = least_radius(profile);
    const std::string text = source_name + ": lies wholly within " + radius_of(least) +
                             ": nothing but a plain rod would be carved; it is " + decimals(box_mm[0], 2) +
                             " x " + decimals(box_mm[1], 2) + " x " + mm_text(box_mm[2]) + " large: ";
    if (const auto unit = probable_unit(profile, options, model_radius_mm, report))
        return bad_input(text + "are its units " + unit->question + "?");
    return bad_input(text + "make it larger (--scale, --height, a picture's --diameter), or " +
                     (least.is_travel ? "let travel_mm go further in" : "core_radius_mm smaller"));
}

Error core_alone(const std::string& path, const Profile& profile) {
    const LeastRadius least = least_radius(profile);
    return bad_input(path +
                     (least.is_travel ? ": no radius is beyond that of " + mm_text(least.mm) +
                                            " at which the heads' travel ends"
                                      : ": all radii are the core radius of " + mm_text(least.mm)) +
                     ": nothing but a plain rod would be carved; larger radii, or a " +
                     way_further_in(least) + ", carve more");
}

}  // namespace psicarve::cam
