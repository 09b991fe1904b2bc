// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/slice_report.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The decisions about a job before the first sample: size, place, layers, points.
struct JobPlan {
    double scale = 1.0;  ///< mm per file unit
    slice::Placement placement;
    Joining joining = Joining::continuous;
    std::uint32_t layer_count = 0;  ///< over the model's height
    std::uint32_t point_count = 0;
    std::vector<double> heights;              ///< in the model, file units, of the layers that are carved
    std::vector<std::int64_t> height_pulses;  ///< Y of the table's rows: a spiral closes with a ring
};

/// Makes the plan and writes it, with its warnings, into the report.
Result<JobPlan> plan_job(const model::Mesh& mesh, const Profile& profile, const JobOptions& options,
                         SliceReport& report);

/// The largest radius both heads can reach, in file units.
double reachable_radius(const Profile& profile, double scale);

/// "FILE: larger than the machine's travel: axis r1 would have to go to 70.00 mm, allowed are 0.00 to 60.00".
Error too_large(const std::string& source_name, const std::string& axis_name, double wanted_mm,
                const AxisMotion& motion);

}  // namespace psicarve::cam
