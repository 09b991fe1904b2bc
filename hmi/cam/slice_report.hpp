// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/best_axis.hpp"

namespace psicarve::cam {

/// The format of a table of radii, which has neither body nor axis.
inline constexpr const char* kTableFormat = "CSV";

/// The slicer's findings and decisions. Goes into the job as JSON; holds no times and no paths, so that the
/// same model and options give the same job to the last byte.
struct SliceReport {
    std::string format;
    std::uint64_t triangles = 0;
    std::array<double, 3> box_mm{};  ///< size of the placed model: along x, y (seen from above), up
    double scale = 1.0;              ///< mm per file unit
    std::string up = "z";            ///< the model's axis that stands upright
    std::string body_json;           ///< as in Mesh; empty: the model is a mesh
    model::MeshTurn turn;
    std::string axis_choice;       ///< "centre", "point", "origin" or "best"
    std::array<double, 2> axis{};  ///< in the turned model, file units
    std::uint32_t layers = 0;
    std::uint32_t points = 0;               ///< per head and layer
    double undercut_share = 0.0;            ///< part of the surface behind another in the same direction
    std::uint64_t open_points = 0;          ///< samples whose wall count shows that the mesh is open there
    std::uint64_t core_points = 0;          ///< table entries at the core radius: no surface, or inside it
    std::uint64_t clearance_points = 0;     ///< points where the clearance kept the heads apart
    std::uint32_t layers_above_blank = 0;   ///< left out, and not counted above: nothing to cut
    std::uint32_t layers_without_axis = 0;  ///< sections that do not contain the axis
    /// Heights above the table between which layers with hidden walls (more than a hundredth of theirs), and
    /// with open samples, lie.
    std::optional<std::array<double, 2>> undercut_mm;
    std::optional<std::array<double, 2>> open_mm;
    std::string tool = "point";               ///< "ball 3.000 mm", "vee 3.000 mm 60 deg"
    std::optional<double> between_points_mm;  ///< for a mesh: see sunk_between_points_mm
    /// Material that a limit below the blank's surface left uncut.
    struct DepthLimit {
        std::uint64_t points = 0;  ///< table entries that were held out
        double share = 0.0;        ///< of all entries
        double most_mm = 0.0;      ///< the greatest distance
    };
    std::optional<DepthLimit> depth_limit;  ///< if the profile has one
    std::string roughing_json;              ///< of the roughing passes; empty: none were asked for
    double r_min_mm = 0.0;                  ///< of the tables, core radius included
    double r_max_mm = 0.0;
    /// The result of the search for a better axis: with axis choice "best", and where the two are compared
    /// and something is lost.
    std::optional<slice::AxisSearch> axis_search;
    std::vector<std::string> warnings;
    std::vector<std::string> notes;  ///< decisions that differ from the default
};

/// One JSON object, keys sorted, no line breaks.
std::string to_json(const SliceReport& report);

}  // namespace psicarve::cam
