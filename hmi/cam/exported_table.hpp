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

/// The columns that every exported table has, and those that one with passes has besides (report::write_csv).
inline constexpr std::array<std::string_view, 6> kExportNames{
    "layer", "point", "y_pulses", "psi_pulses", "r_left_pulses", "r_right_pulses"};
inline constexpr std::array<std::string_view, 5> kPassNames{"run", "pass", "allowance_mm", "depth_mm",
                                                            "clear_mm"};

/// How somebody wants layers joined who cannot know whether the table's are.
struct WishedJoining {
    std::optional<Joining> asked;  ///< for this table
    Joining usual = Joining::continuous;
};

/// Rows of a point, as they were exported; layers may begin at any layer of a longer job. Counts, heights,
/// radii, joining and passes, nothing else. The heights of points tell a spiral, psi the other joinings;
/// where a table of one layer could be of several, the usual one decides if it is among them. No length of a
/// pass is more than `most_pass_mm`: what its heads can clear. Errors: bad_input, with line and column where
/// it is one; bad_usage for a joining that was asked for and is not the table's.
Result<JobTable> exported_table(NumberLines& lines, bool has_passes, const WishedJoining& wished,
                                double most_pass_mm, const std::string& path);

}  // namespace psicarve::cam
