// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "hmi/cam/slice_report.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

struct JobOptions;

/// The least radius in a head's table: the core radius, or the end of its travel further out, counted.
std::int32_t least_radius_pulses(const Profile& profile, Axis head);

/// How many entries of a table's finishing pass have that radius, and how many it has.
struct CoreShare {
    std::uint64_t points = 0;
    std::uint64_t all = 0;

    bool is_all() const noexcept { return all > 0 && points == all; }
};
CoreShare core_share(const Profile& profile, const JobTable& table);

/// Warns of more than a tenth: that part of a small or hollow model, or one beside its axis, is not carved.
void warn_about_core(const Profile& profile, const CoreShare& share, SliceReport& report);

/// The refusal of a model whose every point is at the core radius, with the unit that its file probably has.
/// `model_radius_mm`: from the axis.
Error core_alone(const std::string& source_name, const Profile& profile, const JobOptions& options,
                 double model_radius_mm, const SliceReport& report);
/// The same for a table of radii.
Error core_alone(const std::string& path, const Profile& profile);

}  // namespace psicarve::cam
