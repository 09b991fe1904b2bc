// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/radius_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "hmi/cam/core_share.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/slice_report.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {
namespace {

// A radius that no machine's travel allows, still far from the end of int32: refused when travel is checked.
constexpr double kUnreachablePulses = 1.0e9;

}  // namespace

RadiusTables::RadiusTables(const Profile& profile, JobTable& table, double scale)
    : table_(table), head_clearance_mm_(profile.head_clearance_mm) {
    const std::size_t entries = std::size_t{table.layer_count} * table.point_count;
    table.r_left_pulses.resize(entries);
    table.r_right_pulses.resize(entries);
    left_ = make_head(profile, Axis::r1, scale, table.r_left_pulses);
    right_ = make_head(profile, Axis::r2, scale, table.r_right_pulses);
}

RadiusTables::Head RadiusTables::make_head(const Profile& profile, Axis axis, double scale,
                                           std::vector<std::int32_t>& radii) {
    const LinearAxisProfile& linear = axis == Axis::r1 ? profile.r1 : profile.r2;
    Head head;
    head.name = name_of(axis);
    head.pulses_per_mm = linear.pulses_per_mm;
    head.pulses_per_unit = linear.pulses_per_mm * scale;
    head.tip_offset_pulses = linear.tip_mm() * linear.pulses_per_mm;
    head.motion = axis_motion(profile, axis);
    head.least_pulses = least_radius_pulses(profile, axis);
    head.radii = &radii;
    return head;
}

std::size_t RadiusTables::first_direction(std::size_t layer) const noexcept {
    const bool half_a_turn_on = table_.joining != Joining::zigzag && layer % 2 != 0;
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
    // A joint is sampled where the row before ends.
    const std::size_t joint = is_joint(layer) ? 1 : 0;
    const std::size_t points = table_.point_count - joint;
    std::int32_t* row = head.radii->data() + layer * table_.point_count + joint;
    first = (first + joint) % once_round.size();
    // From the first direction to the end of the turn, then on from its beginning.
    const std::size_t before_wrap = std::min(points, once_round.size() - first);
    const auto convert = [&head](std::span<const double> radii, std::int32_t* out) {
        const double least = static_cast<double>(head.least_pulses);
        for (const double radius : radii) {
            // Counted from the least radius it is never negative: adding a half and cutting off rounds then.
            const double counted = radius * head.pulses_per_unit - head.tip_offset_pulses;
            const double above = std::min(counted - least + 0.5, kUnreachablePulses);
            *out++ = static_cast<std::int32_t>(std::max(above, 0.0)) + head.least_pulses;
        }
    };
    convert(once_round.subspan(first, before_wrap), row);
    convert(once_round.first(points - before_wrap), row + before_wrap);
}

void RadiusTables::join_rows() {
    for (std::size_t layer = 1; layer < table_.layer_count; ++layer) {
        if (!is_joint(layer)) return;
        const std::size_t begin = layer * table_.point_count;
        for (Head* head : {&left_, &right_}) (*head->radii)[begin] = (*head->radii)[begin - 1];
    }
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

double RadiusTables::real_mm(const Head& head, std::int32_t counted_pulses) noexcept {
    return (static_cast<double>(counted_pulses) + head.tip_offset_pulses) / head.pulses_per_mm;
}

void RadiusTables::keep_apart(SliceReport& report) {
    // Each radius stands at its nearest pulse: half a pulse of each head is no fault.
    const double rounding_mm = 0.5 / left_.pulses_per_mm + 0.5 / right_.pulses_per_mm;
    for (std::size_t i = 0; i < left_.radii->size(); ++i) {
        std::int32_t& l = (*left_.radii)[i];
        std::int32_t& r = (*right_.radii)[i];
        const double missing_mm = head_clearance_mm_ - real_mm(left_, l) - real_mm(right_, r);
        if (missing_mm <= rounding_mm) continue;
        // Half of what is missing each; rounding up keeps the sum above the clearance.
        l += static_cast<std::int32_t>(std::ceil(0.5 * missing_mm * left_.pulses_per_mm));
        r += static_cast<std::int32_t>(std::ceil(0.5 * missing_mm * right_.pulses_per_mm));
        if (i % table_.point_count != 0 || !is_joint(i / table_.point_count)) ++report.clearance_points;
    }
}

void RadiusTables::report(const Profile& profile, SliceReport& report) {
    report.core_points = core_share(profile, table_).points;
    keep_apart(report);
    report.r_min_mm = std::numeric_limits<double>::max();
    for (const Head* head : {&left_, &right_}) {
        const auto [least, most] = std::minmax_element(head->radii->begin(), head->radii->end());
        report.r_min_mm = std::min(report.r_min_mm, real_mm(*head, *least));
        report.r_max_mm = std::max(report.r_max_mm, real_mm(*head, *most));
    }
}

}  // namespace psicarve::cam
