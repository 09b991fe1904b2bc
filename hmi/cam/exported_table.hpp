// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "hmi/cam/number_lines.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"

namespace psicarve::cam {

/// The columns that every exported table has, and those that one with passes has besides (report::write_csv).
inline constexpr std::array<std::string_view, 6> kExportNames{
    "layer", "point", "y_pulses", "psi_pulses", "r_left_pulses", "r_right_pulses"};
inline constexpr std::array<std::string_view, 5> kPassNames{"run", "pass", "allowance_mm", "depth_mm",
                                                            "clear_mm"};

/// Rows of a point, as they were exported; layers may begin at any layer of a longer job. Counts, heights,
/// radii, joining and passes, nothing else. The heights of points tell a spiral, psi the other joinings;
/// where a table of one layer could be of several, `chosen` decides if it is among them.
Result<JobTable> exported_table(NumberLines& lines, bool has_passes, Joining chosen, const std::string& path);

}  // namespace psicarve::cam
