// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/cam/number_lines.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The columns of every exported table, and the further ones of a table with passes (report::write_csv).
inline constexpr std::array<std::string_view, 6> kExportNames{
    "layer", "point", "y_pulses", "psi_pulses", "r_left_pulses", "r_right_pulses"};
inline constexpr std::array<std::string_view, 5> kPassNames{"run", "pass", "allowance_mm", "depth_mm",
                                                            "clear_mm"};

/// The joining that a user asks for without knowing whether the table's layers are joined so.
struct WishedJoining {
    std::optional<Joining> asked;  ///< for this table
    Joining usual = Joining::continuous;
};

/// Reads a row for each point, as they were exported; layers may begin at any layer of a longer job. Counts,
/// heights, radii, joining and passes, nothing else. The heights of points identify a spiral, psi the other
/// joinings; where a table of one layer fits several, the usual one decides if it is among them. No length of
/// a pass exceeds `most_pass_mm`, what its heads can clear. Errors: bad_input, with line and column where
/// there is one; bad_usage for a joining that was asked for and is not the table's.
Result<JobTable> exported_table(NumberLines& lines, bool has_passes, const WishedJoining& wished,
                                double most_pass_mm, const std::string& path);

}  // namespace psicarve::cam
