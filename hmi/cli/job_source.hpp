// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/cli/command_set.hpp"
#include "hmi/cli/flat_choice.hpp"
#include "hmi/piece/placed_model.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {

/// The options that turn a model into a job. Zero or empty: not given.
struct ModelOptions {
    std::uint32_t layer_count = 0;
    std::optional<double> layer_height_mm;
    std::uint32_t point_count = 0;
    std::uint32_t thread_count = 0;
    std::string up;
    std::string axis_at;
    std::string joining;
    std::string tool;
    std::optional<double> flute_mm;
    std::string blank;
    std::string blank_at;
    std::optional<double> depth_limit_mm;
    std::optional<double> height_mm;
    std::optional<double> scale;
    std::string rotate;
    std::string mirror;
    bool fits = false;
    std::optional<double> stepdown_mm;
    std::optional<double> allowance_mm;
    std::optional<double> stepover_mm;
    bool finish_only = false;
    FlatChoice flat;
    bool compares_axes = false;  ///< set by commands, not by options: cam::JobOptions::compares_axes
    bool keeps_mesh = false;     ///< set by commands, not by options: fills PreparedJob::mesh
};
void add_model_options(Syntax& syntax, ModelOptions& options);

using cam::PreparedJob;

/// Slices a model, or loads a job or snapshot. Errors: the file is wrong, or the machine cannot carve it.
Result<PreparedJob> prepare_job(const std::string& path, const ModelOptions& options,
                                const CommonOptions& common);
/// The same without output: neither warnings nor notes.
Result<PreparedJob> prepare_unsaid(const std::string& path, const ModelOptions& options,
                                   const CommonOptions& common);
/// A model at its place, not sliced, and the machine with the changes that the options make.
struct PlacedBody {
    Profile profile;
    piece::PlacedModel model;
};
Result<PlacedBody> place_body(const std::string& path, const ModelOptions& options,
                              const CommonOptions& common);
/// The job that a trace carries. `remedy`: what to do where it carries none.
Result<Snapshot> load_carried_job(const std::string& path, const std::string& remedy);
/// A job or snapshot file; of a binary trace, the job that it carries.
Result<Snapshot> load_job_file(const std::string& path, const std::string& remedy);
/// What a profile other than the job's own is used for: any machine on which a job's pulses mean the same may
/// judge it by its limits.
enum class ProfileUse : std::uint8_t { carve, judge };
/// The job of a loaded snapshot.
Result<PreparedJob> job_of_snapshot(Snapshot snapshot, const std::string& path, const CommonOptions& common,
                                    ProfileUse use = ProfileUse::carve);

/// The file that --profile names, or the one in a default place (profile_place.hpp); empty: the built-in one.
std::string chosen_profile_path(const CommonOptions& common);
/// That profile, from TOML or a job file; does not look into the job to be carved.
Result<Profile> chosen_profile(const CommonOptions& common);
/// For commands that can do without: warns of a profile in the default place that cannot be read, and returns
/// none. Errors of chosen_profile() where --profile names it.
Result<std::optional<Profile>> readable_profile(const CommonOptions& common);

/// Checks before the work, not after it, whether an output can be written.
Result<void> check_output_folder(const std::string& path);

}  // namespace psicarve::cli
