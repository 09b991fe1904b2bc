// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::rough {

/// What a user may ask of roughing.
struct RoughingOptions {
    double stepdown_mm = 0.0;  ///< that each pass goes further in
    double allowance_mm = RoughingProfile{}.allowance_mm;
    std::optional<double> stepover_mm;  ///< between layers; default: as the tool allows
};

/// What a profile asks for; nothing: the finishing pass alone. Its stepover is not for a point.
std::optional<RoughingOptions> wanted_roughing(const Profile& profile);

/// Whether these numbers make sense, whatever the model. "roughing: a stepover of ...".
Result<void> check_options(const RoughingOptions& options, const Profile& profile);

/// Between two layers at most, asked for or as the tool allows; 0: every layer.
double used_stepover_mm(const RoughingOptions& options, const ToolProfile& tool);

/// What one pass came to.
struct PassSummary {
    double depth_mm = 0.0;
    std::uint32_t layers = 0;
    std::uint64_t cut_points = 0;
    std::uint64_t air_points = 0;
};
struct RoughingSummary {
    std::vector<PassSummary> passes;
    double stepover_mm = 0.0;  ///< that was used; 0: every layer
};
/// One JSON object.
std::string to_json(const RoughingSummary& summary, const RoughingOptions& options);

/// Puts roughing passes before the layers of a table, which become its finishing pass. `level`: the same
/// layers not rising, where the table is a spiral; else the table itself. A blank that holds nothing to
/// remove: no passes.
Result<RoughingSummary> add_roughing(JobTable& table, const JobTable& level, const Profile& profile,
                                     const RoughingOptions& options);

}  // namespace psicarve::rough
