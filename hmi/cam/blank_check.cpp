// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/blank_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "hmi/cam/job_plan.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

/// The places of one head's table.
class HeadTable {
public:
    HeadTable(const Profile& profile, Axis axis)
        : axis_(axis == Axis::r1 ? profile.r1 : profile.r2),
          facing_rad_(axis == Axis::r1 ? 0.0 : kPi + rad_from_deg(profile.head_r2_angle_error_deg)),
          rad_per_pulse_(rad_from_pulses(1, profile.psi.pulses_per_rev)) {}

    const LinearAxisProfile& axis() const noexcept { return axis_; }
    /// `visit(direction of the workpiece [rad], radius [pulses])`, layer by layer from this one on.
    template <typename Radii, typename Visit>
    void visit(const JobTable& table, std::size_t first_layer, Radii& radii, const Visit& visit) const {
        for (std::size_t layer = first_layer; layer < table.layer_count; ++layer) {
            for (std::size_t point = 0; point < table.point_count; ++point) {
                const std::int64_t psi =
                    table_angle_pulses(table.joining, table.psi_sweep_pulses, table.point_count,
                                       static_cast<std::int64_t>(layer), static_cast<std::int64_t>(point));
                visit(facing_rad_ + static_cast<double>(psi) * rad_per_pulse_,
                      radii[layer * table.point_count + point]);
            }
        }
    }

private:
    const LinearAxisProfile& axis_;
    double facing_rad_;
    double rad_per_pulse_;
};

/// Along the axis of rotation.
double half_width_mm(const ToolProfile& tool) {
    return tool.shape == ToolShape::point ? 0.0 : 0.5 * tool.diameter_mm;
}

void hold_head(const BlankProfile& blank, const HeadTable& head, const JobTable& table,
               std::vector<std::int32_t>& radii, SliceReport::DepthLimit& left) {
    const LinearAxisProfile& axis = head.axis();
    head.visit(table, 0, radii, [&](double direction_rad, std::int32_t& radius) {
        const double least_mm = blank.surface_mm(direction_rad) - blank.depth_limit_mm - axis.tip_mm();
        // Up to the next pulse: never deeper.
        constexpr double kExact = 1e-6;
        const double least = std::ceil(least_mm * axis.pulses_per_mm - kExact);
        if (static_cast<double>(radius) >= least) return;
        ++left.points;
        left.most_mm = std::max(left.most_mm, (least - static_cast<double>(radius)) / axis.pulses_per_mm);
        radius = static_cast<std::int32_t>(least);
    });
}

/// How far the model stands out of the blank, and in which direction most.
struct Missing {
    double most_mm = 0.0;
    double direction_rad = 0.0;
    double model_mm = 0.0;  ///< the largest radius of all
};

Missing missing_of(const BlankProfile& blank, std::span<const double> directions_rad,
                   std::span<const double> model_mm) {
    Missing missing;
    for (std::size_t k = 0; k < model_mm.size(); ++k) {
        missing.model_mm = std::max(missing.model_mm, model_mm[k]);
        const double out_mm = model_mm[k] - blank.surface_mm(directions_rad[k]);
        if (out_mm <= missing.most_mm) continue;
        missing.most_mm = out_mm;
        missing.direction_rad = directions_rad[k];
    }
    return missing;
}

void warn_about_radius(const Profile& profile, const Missing& missing, SliceReport& report) {
    const BlankProfile& blank = profile.blank;
    // Less than the heads can place, and the rounding of a model as large as the blank.
    if (missing.most_mm <= 0.5 / profile.r1.pulses_per_mm) return;
    if (blank.reach_mm() == blank.radius_mm) {
        report.warnings.push_back("the blank's radius of " + mm_text(blank.radius_mm) +
                                  " is less than the model's, " + mm_text(missing.model_mm));
        return;
    }
    // Rounded first: a little less than a whole turn is direction 0.
    const double direction_deg = std::round(deg_from_rad(missing.direction_rad));
    const double within_turn_deg = direction_deg - kDegPerRev * std::floor(direction_deg / kDegPerRev);
    report.warnings.push_back("the model stands out of the blank, which is off the table's axis, by up to " +
                              mm_text(missing.most_mm) + " in direction " + decimals(within_turn_deg, 0) +
                              " deg");
}

/// Warns when the heads clear the blank, but not by as much as they should.
void warn_about_room(const Profile& profile, double blank_mm, SliceReport& report) {
    const double room_mm = reachable_radius(profile, 1.0) - blank_mm;
    if (room_mm >= profile.job.clearance_mm - 0.5 / profile.r1.pulses_per_mm) return;
    report.warnings.push_back("the heads can go only " + mm_text(std::max(0.0, room_mm)) +
                              " out of the blank before they begin, not the " +
                              mm_text(profile.job.clearance_mm) + " of job.clearance_mm");
}

}  // namespace

void OutermostRadii::note(std::span<const double> once_round) {
    const std::scoped_lock lock(mutex_);
    most_.resize(once_round.size(), 0.0);
    for (std::size_t k = 0; k < once_round.size(); ++k) most_[k] = std::max(most_[k], once_round[k]);
}

std::size_t finishing_layer(const JobTable& table) noexcept {
    return table.passes.empty() ? 0 : table.passes.back().first_layer;
}

void hold_depth_limit(const Profile& profile, JobTable& table, SliceReport& report) {
    if (!(profile.blank.depth_limit_mm > 0.0)) return;
    SliceReport::DepthLimit left;
    hold_head(profile.blank, HeadTable(profile, Axis::r1), table, table.r_left_pulses, left);
    hold_head(profile.blank, HeadTable(profile, Axis::r2), table, table.r_right_pulses, left);
    left.share = static_cast<double>(left.points) / (2.0 * static_cast<double>(table.r_left_pulses.size()));
    report.depth_limit = left;
    if (left.points == 0) return;
    report.warnings.push_back("the depth limit of " + mm_text(profile.blank.depth_limit_mm) +
                              " below the blank's surface keeps the heads out of " +
                              decimals(100.0 * left.share, 1) + " % of the points, by up to " +
                              mm_text(left.most_mm));
}

void warn_about_blank_size(const Profile& profile, std::span<const double> directions_rad,
                           std::span<const double> model_mm, double top_mm, SliceReport& report) {
    const BlankProfile& blank = profile.blank;
    if (blank.radius_mm > 0.0)
        warn_about_radius(profile, missing_of(blank, directions_rad, model_mm), report);
    constexpr double kRounded_mm = 1e-6;  // of a body as high as the blank
    if (blank.height_mm > 0.0 && blank.height_mm < top_mm - kRounded_mm) {
        report.warnings.push_back("the blank's top stands " + mm_text(blank.height_mm) +
                                  " above the table, the model's " + mm_text(top_mm));
    }
    const double reach_mm = reachable_radius(profile, 1.0);
    if (blank.reach_mm() <= reach_mm) {
        if (blank.radius_mm > 0.0) warn_about_room(profile, blank.reach_mm(), report);
    } else {
        const bool is_off = blank.reach_mm() != blank.radius_mm;
        report.warnings.push_back(
            (is_off ? "the blank reaches out to " : "the blank's radius of ") + mm_text(blank.reach_mm()) +
            (is_off ? ", which is more than the heads can clear, " : " is more than the heads can clear, ") +
            mm_text(reach_mm));
    }
}

void warn_about_blank(const Profile& profile, std::span<const double> directions_rad,
                      std::span<const double> model_mm, double top_mm, SliceReport& report) {
    warn_about_blank_size(profile, directions_rad, model_mm, top_mm, report);
    // An unknown blank is at least as large as the model.
    if (profile.blank.radius_mm == 0.0) warn_about_room(profile, report.r_max_mm, report);
    const BlankProfile& blank = profile.blank;
    const double deep_mm = std::max(blank.reach_mm(), report.r_max_mm) - report.r_min_mm;
    if (profile.tool.shape != ToolShape::point && profile.tool.flute_mm > 0.0 &&
        profile.tool.flute_mm < deep_mm) {
        report.warnings.push_back("the tool cuts " + mm_text(profile.tool.flute_mm) +
                                  " deep, but the job goes " + mm_text(deep_mm) + " into the blank");
    }
}

void warn_about_blank(const Profile& profile, const JobTable& table, SliceReport& report) {
    constexpr std::size_t kDirections = 720;
    std::vector<double> directions_rad;
    for (std::size_t k = 0; k < kDirections; ++k)
        directions_rad.push_back(2.0 * kPi * static_cast<double>(k) / kDirections);
    std::vector<double> most_mm(kDirections, 0.0);
    const auto note = [&](Axis axis, const std::vector<std::int32_t>& radii) {
        const HeadTable head(profile, axis);
        head.visit(table, finishing_layer(table), radii, [&](double direction_rad, std::int32_t radius) {
            const double turns = direction_rad / (2.0 * kPi);
            const auto k = static_cast<std::size_t>(std::lround((turns - std::floor(turns)) * kDirections)) %
                           kDirections;
            const double radius_mm = mm_from_pulses(radius, head.axis().pulses_per_mm) + head.axis().tip_mm();
            most_mm[k] = std::max(most_mm[k], radius_mm);
        });
    };
    note(Axis::r1, table.r_left_pulses);
    note(Axis::r2, table.r_right_pulses);
    const double top_mm = mm_from_pulses(table.layer_height_pulses.back(), profile.y.pulses_per_mm);
    warn_about_blank(profile, directions_rad, most_mm, top_mm, report);
}

double layer_pitch_mm(const Profile& profile, const JobTable& table) {
    std::int64_t most_pulses = 0;
    const auto& heights = table.layer_height_pulses;
    for (std::size_t i = finishing_layer(table) + 1; i < heights.size(); ++i)
        most_pulses = std::max(most_pulses, std::abs(heights[i] - heights[i - 1]));
    return mm_from_pulses(most_pulses, profile.y.pulses_per_mm);
}

double row_gap_mm(const Profile& profile, const JobTable& table) {
    double most_mm = layer_pitch_mm(profile, table);
    const double error_mm = profile.head_r2_height_error_mm;
    if (table.joining == Joining::zigzag || error_mm == 0.0) return most_mm;
    std::vector<double> layers_mm;
    for (const std::int64_t height : std::span(table.layer_height_pulses).subspan(finishing_layer(table)))
        layers_mm.push_back(mm_from_pulses(height, profile.y.pulses_per_mm));
    for (const std::size_t r2 : {std::size_t{0}, std::size_t{1}}) {
        std::vector<double> rows_mm = layers_mm;
        for (std::size_t layer = r2; layer < rows_mm.size(); layer += 2) rows_mm[layer] += error_mm;
        std::sort(rows_mm.begin(), rows_mm.end());
        for (std::size_t i = 1; i < rows_mm.size(); ++i) {
            if (rows_mm[i] <= layers_mm.front() || rows_mm[i - 1] >= layers_mm.back()) continue;
            most_mm = std::max(most_mm, rows_mm[i] - rows_mm[i - 1]);
        }
    }
    return most_mm;
}

void warn_about_layers(const Profile& profile, const JobTable& table, SliceReport& report) {
    // Of the pitch: what a point leaves between rows is not known; a smaller difference needs no warning.
    constexpr double kEvenShare = 1.25;
    const double pitch_mm = layer_pitch_mm(profile, table);
    const double gap_mm = row_gap_mm(profile, table);
    if (profile.tool.shape == ToolShape::point) {
        if (gap_mm <= kEvenShare * pitch_mm) return;
        report.warnings.push_back("R2's height error makes the rows uneven: up to " + mm_text(gap_mm) +
                                  " apart instead of " + mm_text(pitch_mm) + "; zigzag joining avoids it");
        return;
    }
    const double covered_mm = profile.tool.diameter_mm + 1.0 / profile.y.pulses_per_mm;
    if (gap_mm <= covered_mm) return;
    const bool is_by_error = pitch_mm <= covered_mm;
    report.warnings.push_back((is_by_error ? "R2's height error draws the rows up to " + mm_text(gap_mm)
                                           : "the layers lie " + mm_text(pitch_mm)) +
                              " apart, but the tool is only " + mm_text(profile.tool.diameter_mm) +
                              " wide: between them material stays, as high as the blank; " +
                              (is_by_error ? "zigzag joining avoids it" : "more layers leave less"));
}

void note_what_meets_the_table(const Profile& profile, const JobTable& table, SliceReport& report) {
    const std::int64_t lowest_pulses = table.layer_height_pulses[finishing_layer(table)];
    const double lowest_mm = mm_from_pulses(lowest_pulses, profile.y.pulses_per_mm) +
                             std::min(0.0, profile.head_r2_height_error_mm);
    const double below_mm = half_width_mm(profile.tool) - lowest_mm;
    if (below_mm <= 0.0) return;
    report.notes.push_back(
        "in the lowest layer the tool reaches " + mm_text(below_mm) +
        " below the table's top: the table must be narrower than the job, or base_height_mm more");
}

void warn_about_foot(const Profile& profile, const JobTable& table, SliceReport& report) {
    const double lower_mm = -profile.head_r2_height_error_mm;
    if (lower_mm <= 0.0) return;
    const double clear_mm = profile.job.base_height_mm + lower_mm - half_width_mm(profile.tool);
    const auto clear_pulses = pulses_from_mm(clear_mm, profile.y.pulses_per_mm);
    std::size_t layers = 0;
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    while (layers < table.layer_count && table.layer_height_pulses[layers] < clear_pulses) {
        const auto row =
            table.r_right_pulses.begin() + static_cast<std::ptrdiff_t>(layers * table.point_count);
        least = std::min(least, *std::min_element(row, row + table.point_count));
        ++layers;
    }
    if (layers == 0) return;
    const double radius_mm = mm_from_pulses(least, profile.r2.pulses_per_mm) + profile.r2.tip_mm();
    report.warnings.push_back("R2 stands " + mm_text(lower_mm) + " lower than R1 and is under the model in " +
                              std::to_string(layers) +
                              " of its layers: there it cuts what holds the model down to a radius of " +
                              mm_text(radius_mm));
}

}  // namespace psicarve::cam
