// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/cli/command_set.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/snapshot_file.hpp"

namespace psicarve::cli {

/// How a model becomes a job. Zero or empty: not given.
struct ModelOptions {
    std::uint32_t layer_count = 0;
    std::uint32_t point_count = 0;
    std::uint32_t thread_count = 0;
    std::string up;
    std::string axis_at;
    std::string joining;
    std::optional<double> height_mm;
    std::optional<double> scale;
};
void add_model_options(Syntax& syntax, ModelOptions& options);

using cam::PreparedJob;

/// Slices a model, or loads a job or snapshot. Errors: the file is wrong, or the machine cannot carve it.
Result<PreparedJob> prepare_job(const std::string& path, const ModelOptions& options,
                                const CommonOptions& common);
/// The job of a snapshot that was loaded.
Result<PreparedJob> job_of_snapshot(Snapshot snapshot, const std::string& path, const CommonOptions& common);

/// --profile, which may be TOML or a job file; without it the built-in one.
Result<Profile> chosen_profile(const CommonOptions& common);

/// An output that cannot be written is better known before the work than after it.
Result<void> check_output_folder(const std::string& path);

}  // namespace psicarve::cli
