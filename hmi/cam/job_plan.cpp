// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/job_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cam/fitting_scale.hpp"
#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/slice_report.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/best_axis.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {
namespace {

constexpr std::uint32_t kUsualLayers = 500;
constexpr std::uint32_t kUsualPoints = 500;
// A model smaller than this in every direction [mm] is more likely in inches, or metres, than meant so.
constexpr double kSuspiciouslySmall_mm = 3.0;

struct Box {
    std::array<double, 3> min;
    std::array<double, 3> max;
};

std::string digits(double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

Result<double> scale_of(const JobOptions& options, const Box& box) {
    if (options.diameter_mm && (options.fits || options.height_mm || options.scale))
        return Error{ErrorCode::bad_usage,
                     "--diameter excludes --height, --scale and --fit: all set the size"};
    if (options.fits && (options.height_mm || options.scale))
        return Error{ErrorCode::bad_usage, "--fit excludes --height and --scale: all set the size"};
    if (options.height_mm && options.scale) {
        return Error{ErrorCode::bad_usage, "--height and --scale exclude each other: both set the size"};
    }
    if (options.height_mm) {
        if (!(*options.height_mm > 0.0) || !std::isfinite(*options.height_mm)) {
            return Error{ErrorCode::bad_usage, "--height must be more than 0 mm"};
        }
        return *options.height_mm / (box.max[2] - box.min[2]);
    }
    const double scale = options.scale.value_or(1.0);
    if (!(scale > 0.0) || !std::isfinite(scale)) {
        return Error{ErrorCode::bad_usage, "--scale must be more than 0"};
    }
    return scale;
}

Result<std::uint32_t> points_of(const JobOptions& options, const Profile& profile, SliceReport& report) {
    const std::int64_t most = profile.psi.pulses_per_rev / 2 + 1;  // one for each pulse of half a turn
    if (!options.point_count) {
        if (most < kUsualPoints) {
            report.notes.push_back(std::to_string(most) + " points a layer, not " +
                                   std::to_string(kUsualPoints) +
                                   ": half a turn of axis psi has no more pulses");
        }
        return static_cast<std::uint32_t>(std::min<std::int64_t>(kUsualPoints, most));
    }
    if (*options.point_count < 2) {
        return Error{ErrorCode::bad_usage, "--points must be at least 2"};
    }
    if (*options.point_count > most) {
        return bad_input("more points than pulses: " + std::to_string(*options.point_count) +
                         " points a layer, but half a turn of axis psi has " + std::to_string(most - 1) +
                         " pulses: at most --points " + std::to_string(most));
    }
    return *options.point_count;
}

/// As many layers as it takes for none to be higher than asked.
Result<std::uint32_t> layers_of_height(const JobOptions& options, double height_mm, std::int64_t most,
                                       const std::string& source_name, SliceReport& report) {
    if (options.layer_count)
        return Error{ErrorCode::bad_usage, "--layers and --layer-height exclude each other"};
    constexpr double kRounding = 1e-9;  // ten layers of 0.1 mm are 1 mm
    const double wanted = std::max(1.0, std::ceil(height_mm / *options.layer_height_mm * (1.0 - kRounding)));
    if (wanted > static_cast<double>(most)) {
        return bad_input(source_name + ": layers of " + digits(*options.layer_height_mm) +
                         " mm are thinner than a pulse of axis y: at least --layer-height " +
                         decimals(height_mm / static_cast<double>(most), 4));
    }
    report.notes.push_back(std::to_string(static_cast<std::int64_t>(wanted)) + " layers of " +
                           decimals(height_mm / wanted, 4) + " mm");
    return static_cast<std::uint32_t>(wanted);
}

Result<std::uint32_t> layers_of(const JobOptions& options, const Profile& profile, double height_mm,
                                const std::string& source_name, SliceReport& report) {
    const auto most =
        std::max<std::int64_t>(static_cast<std::int64_t>(height_mm * profile.y.pulses_per_mm), 1);
    if (options.layer_height_mm) return layers_of_height(options, height_mm, most, source_name, report);
    if (!options.layer_count) {
        if (most < kUsualLayers) {
            report.notes.push_back(std::to_string(most) + (most == 1 ? " layer" : " layers") + ", not " +
                                   std::to_string(kUsualLayers) + ": " + source_name + " is only " +
                                   decimals(height_mm, 2) + " mm high, and a layer needs a pulse of axis y");
        }
        return static_cast<std::uint32_t>(std::min<std::int64_t>(most, kUsualLayers));
    }
    if (*options.layer_count < 1) return Error{ErrorCode::bad_usage, "--layers must be at least 1"};
    if (*options.layer_count > most) {
        return bad_input(source_name + ": more layers than pulses: " + std::to_string(*options.layer_count) +
                         " layers, but the model is only " + decimals(height_mm, 2) + " mm, " +
                         std::to_string(most) + " pulses of axis y, high: at most --layers " +
                         std::to_string(most) + ", or make it higher with --height or --scale");
    }
    return *options.layer_count;
}

Result<std::vector<std::int64_t>> height_pulses(const JobPlan& plan, const Profile& profile, const Box& box,
                                                const std::string& source_name) {
    const AxisMotion motion = axis_motion(profile, Axis::y);
    std::vector<std::int64_t> pulses;
    for (const double height : plan.heights) {
        const double y_mm = profile.job.base_height_mm + (height - box.min[2]) * plan.scale;
        const std::int64_t y_pulses = pulses_from_mm(y_mm, profile.y.pulses_per_mm);
        if (y_pulses < motion.travel_min_pulses || y_pulses > motion.travel_max_pulses) {
            // The whole model is a better message than the first layer that does not fit.
            const double top_mm =
                profile.job.base_height_mm + (plan.heights.back() - box.min[2]) * plan.scale;
            return too_large(source_name, "y", y_pulses < motion.travel_min_pulses ? y_mm : top_mm, motion);
        }
        pulses.push_back(y_pulses);
    }
    return pulses;
}

/// The search is the longer part of the work with `--axis-at best`; the slicing's progress follows it.
Result<void> find_best_axis(const model::Mesh& mesh, const Profile& profile, const JobOptions& options,
                            JobPlan& plan, SliceReport& report) {
    const auto found = slice::search_axis(mesh, options.up, {plan.placement.axis_x, plan.placement.axis_y},
                                          reachable_radius(profile, plan.scale), options.search_progress);
    if (!found) return found.error();
    plan.placement.axis_x = found->best[0];
    plan.placement.axis_y = found->best[1];
    report.axis_search = *found;
    return {};
}

Result<void> place_axis(const model::Mesh& mesh, const Profile& profile, const JobOptions& options,
                        const Box& box, JobPlan& plan, SliceReport& report) {
    plan.placement.up = options.up;
    if (options.axis_at == AxisAt::centre || options.axis_at == AxisAt::best) {
        plan.placement.axis_x = box.min[0] + 0.5 * (box.max[0] - box.min[0]);
        plan.placement.axis_y = box.min[1] + 0.5 * (box.max[1] - box.min[1]);
        if (mesh.axis_hint && options.up == slice::Up::z) {
            plan.placement.axis_x = (*mesh.axis_hint)[0];
            plan.placement.axis_y = (*mesh.axis_hint)[1];
        }
    } else if (options.axis_at == AxisAt::point) {
        if (!std::isfinite(options.axis_x) || !std::isfinite(options.axis_y)) {
            return Error{ErrorCode::bad_usage, "--axis-at needs two finite numbers"};
        }
        plan.placement.axis_x = options.axis_x;
        plan.placement.axis_y = options.axis_y;
    }
    constexpr std::array<const char*, 4> kNames{"centre", "origin", "point", "best"};
    report.axis_choice = kNames[static_cast<std::size_t>(options.axis_at)];
    if (options.axis_at == AxisAt::best) {
        if (auto done = find_best_axis(mesh, profile, options, plan, report); !done) return done.error();
    }
    report.axis = {plan.placement.axis_x, plan.placement.axis_y};
    return {};
}

/// Decides the scale; a model to be fitted needs its axis before.
Result<void> settle_size(const model::Mesh& mesh, const Profile& profile, const JobOptions& options,
                         const Box& box, JobPlan& plan, SliceReport& report) {
    const auto scale = scale_of(options, box);
    if (!scale) return scale.error();
    plan.scale = *scale;
    if (!options.fits && !options.diameter_mm) return {};
    // During the search for the axis any radius can be made to fit.
    plan.scale = std::numeric_limits<double>::min();
    if (auto done = place_axis(mesh, profile, options, box, plan, report); !done) return done.error();
    if (options.diameter_mm) {
        plan.scale = *options.diameter_mm / (2.0 * slice::largest_radius(mesh, plan.placement));
        return {};
    }
    plan.scale = fitting_scale(mesh, profile, plan, report);
    if (!(plan.scale > 0.0)) return bad_input(mesh.source_name + ": nothing fits above the base height");
    return {};
}

void warn_about_units(const JobOptions& options, SliceReport& report) {
    if (options.height_mm || options.scale || options.fits || options.diameter_mm) return;
    const double largest = *std::max_element(report.box_mm.begin(), report.box_mm.end());
    if (largest >= kSuspiciouslySmall_mm) return;
    report.warnings.push_back("the model is only " + decimals(report.box_mm[2], 2) +
                              " mm high: are its units inches (--scale 25.4) or metres (--scale 1000)?");
}

/// A file of floats far from its origin holds a staircase.
void warn_about_rounding(const model::Mesh& mesh, const Profile& profile, SliceReport& report) {
    const double step_mm = mesh.facts.coordinate_step * report.scale;
    const double pulse_mm =
        1.0 / std::max({profile.r1.pulses_per_mm, profile.r2.pulses_per_mm, profile.y.pulses_per_mm});
    if (step_mm <= pulse_mm) return;
    report.warnings.push_back(
        "the model stands so far from its file's origin that its coordinates are rounded to " +
        digits(step_mm) + " mm, more than a pulse (" + digits(pulse_mm) +
        " mm): move it to the origin before it is exported");
}

/// Above the blank there is nothing to cut: drops layers that neither tool nor half a layer reaches down
/// from.
Result<void> leave_out_above_blank(const Profile& profile, double lowest, const std::string& source_name,
                                   JobPlan& plan, SliceReport& report) {
    const double top_mm = profile.blank.height_mm;
    if (!(top_mm > 0.0)) return {};
    const double tool_mm = profile.tool.shape == ToolShape::point ? 0.0 : 0.5 * profile.tool.diameter_mm;
    const double layer_mm = report.box_mm[2] / plan.layer_count;
    const double reach_mm =
        std::max(0.5 * layer_mm, tool_mm) + std::max(0.0, -profile.head_r2_height_error_mm);
    constexpr double kRounded_mm = 1e-6;
    const auto above = std::find_if(plan.heights.begin(), plan.heights.end(), [&](double height) {
        const double y_mm = profile.job.base_height_mm + (height - lowest) * plan.scale;
        return y_mm - reach_mm >= top_mm - kRounded_mm;
    });
    if (above == plan.heights.end()) return {};
    if (above == plan.heights.begin()) {
        return bad_input(source_name + ": stands " + decimals(profile.job.base_height_mm, 2) +
                         " mm above the table, and the blank is only " + decimals(top_mm, 2) +
                         " mm high: nothing of it is left to be carved");
    }
    report.layers_above_blank = static_cast<std::uint32_t>(plan.heights.end() - above);
    plan.heights.erase(above, plan.heights.end());
    report.layers = static_cast<std::uint32_t>(plan.heights.size());
    report.warnings.push_back(
        "above the blank's top there is nothing to cut: " + std::to_string(report.layers_above_blank) +
        " of " + std::to_string(plan.layer_count) + " layers are left out");
    return {};
}

}  // namespace

double reachable_radius(const Profile& profile, double scale) {
    double least_mm = std::numeric_limits<double>::max();
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const LinearAxisProfile& linear = head == Axis::r1 ? profile.r1 : profile.r2;
        const std::int64_t most = axis_motion(profile, head).travel_max_pulses;
        least_mm = std::min(least_mm, mm_from_pulses(most, linear.pulses_per_mm) + linear.tip_mm());
    }
    return least_mm / scale;
}

Error too_large(const std::string& source_name, const std::string& axis_name, double wanted_mm,
                const AxisMotion& motion) {
    const auto mm = [&motion](std::int64_t pulses) {
        return decimals(mm_from_pulses(pulses, motion.pulses_per_unit), 2);
    };
    return bad_input(source_name + ": larger than the machine's travel: axis " + axis_name +
                     " would have to go to " + decimals(wanted_mm, 2) + " mm, allowed are " +
                     mm(motion.travel_min_pulses) + " to " + mm(motion.travel_max_pulses) +
                     " mm; --height or --scale make it smaller");
}

Result<JobPlan> plan_job(const model::Mesh& mesh, const Profile& profile, const JobOptions& options,
                         SliceReport& report) {
    const Box box{slice::placed(options.up, mesh.facts.min), slice::placed(options.up, mesh.facts.max)};
    JobPlan plan;
    if (auto done = settle_size(mesh, profile, options, box, plan, report); !done) return done.error();
    for (std::size_t k = 0; k < 3; ++k) report.box_mm[k] = (box.max[k] - box.min[k]) * plan.scale;
    report.format = mesh.format;
    report.triangles = mesh.triangles.size();
    report.scale = plan.scale;
    constexpr std::array<const char*, 3> kUpNames{"x", "y", "z"};
    report.up = kUpNames[static_cast<std::size_t>(options.up)];
    report.body_json = mesh.body_json;
    report.turn = mesh.turn;
    report.warnings = mesh.warnings;
    warn_about_units(options, report);
    warn_about_rounding(mesh, profile, report);

    const double model_height = box.max[2] - box.min[2];
    const auto points = points_of(options, profile, report);
    if (!points) return points.error();
    // Before anything is counted in pulses: a model of kilometres has more than fit an integer.
    const AxisMotion y_motion = axis_motion(profile, Axis::y);
    const double top_mm = profile.job.base_height_mm + report.box_mm[2];
    const double most_mm = mm_from_pulses(y_motion.travel_max_pulses, profile.y.pulses_per_mm);
    if (!(top_mm <= 2.0 * std::max(most_mm, 1.0))) return too_large(mesh.source_name, "y", top_mm, y_motion);
    const auto layers = layers_of(options, profile, report.box_mm[2], mesh.source_name, report);
    if (!layers) return layers.error();
    plan.point_count = report.points = *points;
    plan.layer_count = report.layers = *layers;
    plan.heights = slice::layer_heights(box.min[2], model_height, plan.layer_count);
    if (auto good = leave_out_above_blank(profile, box.min[2], mesh.source_name, plan, report); !good)
        return good.error();
    auto pulses = height_pulses(plan, profile, box, mesh.source_name);
    if (!pulses) return pulses.error();
    plan.height_pulses = std::move(*pulses);
    plan.joining = options.joining.value_or(profile.job.joining);
    if (plan.joining == Joining::spiral && plan.heights.size() > 1) {
        plan.height_pulses.push_back(plan.height_pulses.back());
        ++report.layers;
    }
    if (!options.fits && !options.diameter_mm) {
        if (auto done = place_axis(mesh, profile, options, box, plan, report); !done) return done.error();
    }
    return plan;
}

}  // namespace psicarve::cam
