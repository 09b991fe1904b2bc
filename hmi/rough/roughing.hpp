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

/// A user's options for roughing.
struct RoughingOptions {
    double stepdown_mm = 0.0;  ///< how much further in each pass goes
    double allowance_mm = RoughingProfile{}.allowance_mm;
    std::optional<double> stepover_mm;  ///< between layers; default: as the tool allows
};

/// The roughing that a profile asks for; nothing: only the finishing pass. A point ignores its stepover.
std::optional<RoughingOptions> wanted_roughing(const Profile& profile);

/// Whether these numbers are valid for any model. "roughing: a stepover of ...".
Result<void> check_options(const RoughingOptions& options, const Profile& profile);

/// The most between two layers, as asked for or as the tool allows; 0: every layer.
double used_stepover_mm(const RoughingOptions& options, const ToolProfile& tool);

/// The result of one pass.
struct PassSummary {
    double depth_mm = 0.0;
    std::uint32_t layers = 0;
    std::uint64_t cut_points = 0;
    std::uint64_t air_points = 0;
};
struct RoughingSummary {
    std::vector<PassSummary> passes;
    double stepover_mm = 0.0;  ///< as used; 0: every layer
};
/// One JSON object.
std::string to_json(const RoughingSummary& summary, const RoughingOptions& options);

/// Puts roughing passes before the layers of a table, which become its finishing pass. `level`: the same
/// layers without rising, where the table is a spiral; else the table itself. Adds no passes when the blank
/// holds nothing to remove.
Result<RoughingSummary> add_roughing(JobTable& table, const JobTable& level, const Profile& profile,
                                     const RoughingOptions& options);

}  // namespace psicarve::rough
