// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Whether the file is a table of numbers that begins with one of the heads below, or is named .csv and has
/// separators.
bool is_table_file(const std::string& path);

/// Makes a job of a table's heights and radii, unchanged. Knows two heads, separated by commas, semicolons or
/// tabs:
///   y_mm,r_mm or y_pulses,r_pulses: a row a layer: its height, then its radii once round from direction 0,
///     equally far from each other. An odd number is evened.
///   layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses, and of a job with passes
///   run,pass,allowance_mm,depth_mm,clear_mm besides: as `snapshot export --format csv` writes it.
/// A refusal names the line, or the first layer and point that the machine cannot carve.
Result<BuiltJob> job_from_table(const std::string& path, const Profile& profile,
                                std::optional<Joining> joining);

/// The same circle with one more point: a periodic, piecewise straight line through the old ones, sampled
/// anew.
std::vector<double> evened(const std::vector<double>& once_round);

}  // namespace psicarve::cam
