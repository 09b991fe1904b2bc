// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/machine/planned_time.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// The size of the piece that a job's finishing pass leaves: its tables with the tips at their real places.
struct JobSize {
    double least_radius_mm = 0.0;
    double greatest_radius_mm = 0.0;
    double lowest_mm = 0.0;  ///< of its layers above the table
    double highest_mm = 0.0;
};
JobSize job_size(const JobView& job, const Profile& profile);

/// "radii 1.50 to 6.48 mm, heights 0.32 to 12.49 mm".
std::string size_text(const JobSize& size);
nlohmann::ordered_json size_json(const JobSize& size);

/// --time, which plans the whole job.
void add_time_option(Syntax& syntax, bool& wanted);
/// "50:33, T_ref 50:30".
std::string time_text(const machine::PlannedTime& planned);
/// {"carve_seconds", "reference_seconds"}; null where it was not asked for.
nlohmann::ordered_json time_json(const std::optional<machine::PlannedTime>& planned);

/// The slicer's report of a job, for people: "size       12.7 x ...
/// "; empty without one.
std::string slicer_text(const JobView& job);

}  // namespace psicarve::cli
