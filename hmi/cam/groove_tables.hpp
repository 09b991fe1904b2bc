// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/radius_tables.hpp"
#include "hmi/cam/slice_report.hpp"
#include "hmi/flat/grooves.hpp"
#include "hmi/flat/stroke_index.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Line art keeps its place on the cylinder: refuses options that would turn, move or scale its body, and
/// another tool than that of the grooves.
Result<void> check_groove_options(const model::Mesh& mesh, const Profile& profile, const JobOptions& options);

/// The surface around a point of the table: half a step each way. Where a stroke passes through, the tip goes
/// all the way in, so that each place of a stroke has a point, and its points touch each other.
flat::HalfCell groove_cell(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan);

/// Fills both tables: on the cylinder's surface, and in the grooves as deep as the tool can go.
Result<void> fill_with_grooves(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan,
                               const slice::SliceOptions& options, RadiusTables& tables);

/// Reports how wide grooves may become, and what keeps them from their depth.
void report_grooves(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan,
                    SliceReport& report);

}  // namespace psicarve::cam
