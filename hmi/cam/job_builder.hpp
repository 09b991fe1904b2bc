// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/cam/slice_report.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Where the rotation axis passes through the model, seen from above.
enum class AxisAt : std::uint8_t {
    centre,  ///< of the bounding box
    origin,  ///< of the file's coordinates
    point,   ///< axis_x, axis_y of the turned model, file units
    best,    ///< where the loss is least, see best_axis.hpp
};

/// A user's options for a job. Defaults as the command line promises.
struct JobOptions {
    /// Default 500, fewer where the model has fewer pulses of height.
    std::optional<std::uint32_t> layer_count;
    std::optional<double> layer_height_mm;  ///< sets the number of layers; not together with layer_count
    /// Per head and layer; default 500, fewer where half a turn has fewer pulses.
    std::optional<std::uint32_t> point_count;
    slice::Up up = slice::Up::z;
    AxisAt axis_at = AxisAt::centre;
    double axis_x = 0.0;
    double axis_y = 0.0;
    std::optional<double> height_mm;    ///< of the whole model; not together with scale
    std::optional<double> scale;        ///< mm per file unit; default 1
    std::optional<double> diameter_mm;  ///< twice its reach from its axis; excludes the two above
    /// Where the axis loses much, searches for the one that loses least and reports its loss: that takes
    /// longer than all the slicing. Else the report names the way to search.
    bool compares_axes = false;
    bool fits = false;  ///< as large as travel and blank allow; not together with height or scale
    std::optional<Joining> joining;   ///< default: the profile's
    unsigned thread_count = 1;        ///< does not change the job
    slice::Progress progress;         ///< of the slicing
    slice::Progress search_progress;  ///< of the search for the best axis
};

struct BuiltJob {
    JobTable table;
    SliceReport report;  ///< also in table.report_json
};

/// Slices the mesh into the tables of a job for this machine, with the roughing that its profile asks for.
/// Refuses what the machine cannot carve; the message names the axis, what is wanted and what is allowed.
Result<BuiltJob> build_job(const model::Mesh& mesh, const Profile& profile, const JobOptions& options);

}  // namespace psicarve::cam
