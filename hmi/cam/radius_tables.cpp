// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/radius_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/slice_report.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/units.hpp"

namespace psicarve::cam {
namespace {

// A radius that no machine's travel allows, still far from the end of int32: refused when travel is checked.
constexpr double kUnreachablePulses = 2.0e9;

}  // namespace

RadiusTables::RadiusTables(const Profile& profile, JobTable& table, double scale)
    : table_(table), head_clearance_mm_(profile.head_clearance_mm) {
    const std::size_t entries = std::size_t{table.layer_count} * table.point_count;
    table.r_left_pulses.resize(entries);
    table.r_right_pulses.resize(entries);
    left_ = make_head(profile, Axis::r1, scale, table.layer_count, table.r_left_pulses);
    right_ = make_head(profile, Axis::r2, scale, table.layer_count, table.r_right_pulses);
}

RadiusTables::Head RadiusTables::make_head(const Profile& profile, Axis axis, double scale,
                                           std::size_t layers, std::vector<std::int32_t>& radii) {
    const LinearAxisProfile& linear = axis == Axis::r1 ? profile.r1 : profile.r2;
    Head head;
    head.name = name_of(axis);
    head.pulses_per_mm = linear.pulses_per_mm;
    head.pulses_per_unit = linear.pulses_per_mm * scale;
    head.core_pulses = static_cast<std::int32_t>(core_radius_pulses(profile, axis));
    head.tip_pulses = static_cast<std::int32_t>(pulses_from_mm(linear.tip_offset_mm, linear.pulses_per_mm));
    head.motion = axis_motion(profile, axis);
    head.radii = &radii;
    head.core_points.resize(layers);
    return head;
}

std::size_t RadiusTables::first_direction(std::size_t layer) const noexcept {
    const bool half_a_turn_on = table_.joining == Joining::continuous && layer % 2 != 0;
    return half_a_turn_on ? table_.point_count - 1 : 0;
}

void RadiusTables::fill_left(std::size_t layer, std::span<const double> once_round) {
    fill(left_, layer, once_round, first_direction(layer));
}

void RadiusTables::fill_right(std::size_t layer, std::span<const double> once_round) {
    const std::size_t opposite = table_.point_count - 1;
    fill(right_, layer, once_round, (first_direction(layer) + opposite) % once_round.size());
}

void RadiusTables::fill(Head& head, std::size_t layer, std::span<const double> once_round,
                        std::size_t first) {
    const std::size_t points = table_.point_count;
    std::int32_t* row = head.radii->data() + layer * points;
    std::uint32_t at_core = 0;
    // From the first direction to the end of the turn, then on from its beginning.
    const std::size_t before_wrap = std::min(points, once_round.size() - first);
    const auto convert = [&head, &at_core](std::span<const double> radii, std::int32_t* out) {
        const double core = static_cast<double>(head.core_pulses);
        for (const double radius : radii) {
            // Never negative: adding a half and cutting off rounds as round_to_pulse does.
            const double pulses = std::min(radius * head.pulses_per_unit + 0.5, kUnreachablePulses);
            at_core += pulses < core || radius == 0.0 ? 1U : 0U;
            *out++ = static_cast<std::int32_t>(std::max(pulses, core)) - head.tip_pulses;
        }
    };
    convert(once_round.subspan(first, before_wrap), row);
    convert(once_round.first(points - before_wrap), row + before_wrap);
    head.core_points[layer] = at_core;
}

Result<void> RadiusTables::check_travel(const std::string& source_name) const {
    for (const Head* head : {&left_, &right_}) {
        const auto [least, most] = std::minmax_element(head->radii->begin(), head->radii->end());
        if (*least >= head->motion.travel_min_pulses && *most <= head->motion.travel_max_pulses) continue;
        const std::int32_t wanted = *most > head->motion.travel_max_pulses ? *most : *least;
        return too_large(source_name, head->name, mm_from_pulses(wanted, head->pulses_per_mm), head->motion);
    }
    return {};
}

void RadiusTables::keep_apart(SliceReport& report) {
    const double least_mm = head_clearance_mm_;
    for (std::size_t i = 0; i < left_.radii->size(); ++i) {
        std::int32_t& l = (*left_.radii)[i];
        std::int32_t& r = (*right_.radii)[i];
        const double l_mm = mm_from_pulses(l + left_.tip_pulses, left_.pulses_per_mm);
        const double r_mm = mm_from_pulses(r + right_.tip_pulses, right_.pulses_per_mm);
        const double missing_mm = least_mm - l_mm - r_mm;
        if (missing_mm <= 0.0) continue;
        // Half of what is missing each; rounding up keeps the sum above the clearance.
        l += static_cast<std::int32_t>(std::ceil(0.5 * missing_mm * left_.pulses_per_mm));
        r += static_cast<std::int32_t>(std::ceil(0.5 * missing_mm * right_.pulses_per_mm));
        ++report.clearance_points;
    }
}

void RadiusTables::report(SliceReport& report) {
    keep_apart(report);
    report.r_min_mm = std::numeric_limits<double>::max();
    for (const Head* head : {&left_, &right_}) {
        report.core_points =
            std::accumulate(head->core_points.begin(), head->core_points.end(), report.core_points);
        const auto [least, most] = std::minmax_element(head->radii->begin(), head->radii->end());
        const std::int64_t tip = head->tip_pulses;
        report.r_min_mm = std::min(report.r_min_mm, mm_from_pulses(*least + tip, head->pulses_per_mm));
        report.r_max_mm = std::max(report.r_max_mm, mm_from_pulses(*most + tip, head->pulses_per_mm));
    }
}

}  // namespace psicarve::cam
