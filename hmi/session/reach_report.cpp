// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/reach_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/fitting_scale.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/scene/space_picture.hpp"
#include "hmi/slice/best_axis.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr std::size_t kRound = 360;
constexpr std::size_t kUp = 240;
constexpr double kSlack = 0.01;  // of the largest radius: less deep is not shown as hidden

using Vec = std::array<double, 3>;

/// The axis' place in the turned model, file units.
Result<std::array<double, 2>> axis_place(const model::Mesh& mesh, const Vec& middle, const Profile& profile,
                                         const cam::JobOptions& options, double mm_per_unit) {
    if (options.axis_at == cam::AxisAt::origin) return std::array{0.0, 0.0};
    if (options.axis_at == cam::AxisAt::point) return std::array{options.axis_x, options.axis_y};
    const bool is_hinted = mesh.axis_hint && options.up == slice::Up::z;
    const std::array centre = is_hinted ? *mesh.axis_hint : std::array{middle[0], middle[1]};
    if (options.axis_at == cam::AxisAt::centre) return centre;
    const auto found = slice::search_axis(
        mesh, options.up, centre, cam::reachable_radius(profile, mm_per_unit), options.search_progress);
    if (!found) return found.error();
    return found->best;
}

/// The least of the outermost radii around a place of the map: a wall further in than all of these is hidden.
double least_radius_near(const slice::RadialMap& map, double row, double column) {
    double least = std::numeric_limits<double>::max();
    const auto middle_row = static_cast<std::int64_t>(std::floor(row));
    const auto middle_column = static_cast<std::int64_t>(std::lround(column));
    for (std::int64_t r = middle_row - 1; r <= middle_row + 1; ++r) {
        if (r < 0 || r >= static_cast<std::int64_t>(kUp)) return 0.0;  // a floor or a top is no wall
        for (std::int64_t c = middle_column - 1; c <= middle_column + 1; ++c) {
            const std::size_t wrapped =
                static_cast<std::size_t>(c + static_cast<std::int64_t>(kRound)) % kRound;
            least = std::min(least, map.radius[static_cast<std::size_t>(r) * kRound + wrapped]);
        }
    }
    return least;
}

std::vector<std::uint8_t> hidden_vertices(const MeshScene& scene, slice::Up up, const ReachReport& reach,
                                          const slice::RadialMap& map) {
    const double height = slice::placed(up, scene.size)[2];
    std::vector<std::uint8_t> is_hidden(scene.vertices.size(), 0);
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        const auto& vertex = scene.vertices[i];
        const Vec place = slice::placed(up, {vertex[0], vertex[1], vertex[2]});
        const double x = place[0] - reach.axis[0];
        const double y = place[1] - reach.axis[1];
        const double angle_rad = std::atan2(y, x) + (y < 0.0 ? 2.0 * kPi : 0.0);
        const double row = (place[2] / height + 0.5) * kUp;
        const double column = angle_rad / (2.0 * kPi) * kRound;
        const double outermost = least_radius_near(map, row, column);
        is_hidden[i] = std::hypot(x, y) < outermost - kSlack * reach.blank_radius ? 1 : 0;
    }
    return is_hidden;
}

}  // namespace

Result<ReachReport> look_at_model(const model::Mesh& mesh, const MeshScene& scene, const Profile& profile,
                                  const cam::JobOptions& options) {
    const Vec size = slice::placed(options.up, scene.size);
    const Vec middle = slice::placed(options.up, scene.middle);
    if (!(size[2] > 0.0)) return bad_input(mesh.source_name + ": the model has no height");
    ReachReport reach;
    reach.mm_per_unit = options.height_mm ? *options.height_mm / size[2] : options.scale.value_or(1.0);
    // During the search for the axis any radius can be made to fit.
    if (options.fits) reach.mm_per_unit = std::numeric_limits<double>::min();
    const auto axis = axis_place(mesh, middle, profile, options, reach.mm_per_unit);
    if (!axis) return axis.error();
    if (options.fits) {
        cam::JobPlan plan;
        plan.placement = {options.up, (*axis)[0], (*axis)[1]};
        cam::SliceReport report;
        reach.mm_per_unit = cam::fitting_scale(mesh, profile, plan, report);
    }
    reach.axis = {(*axis)[0] - middle[0], (*axis)[1] - middle[1]};
    std::vector<double> angles_rad;
    for (std::size_t i = 0; i < kRound; ++i)
        angles_rad.push_back(2.0 * kPi * static_cast<double>(i) / static_cast<double>(kRound));
    const auto map = slice::radial_map(mesh, {options.up, (*axis)[0], (*axis)[1]},
                                       slice::layer_heights(middle[2] - size[2] / 2.0, size[2], kUp),
                                       slice::Directions{angles_rad}, {1, options.search_progress});
    if (!map) return map.error();
    reach.blank_radius = *std::max_element(map->radius.begin(), map->radius.end());
    reach.undercut_share = slice::undercut_share(map->layers);
    reach.size = size;
    reach.outermost.assign(kRound, 0.0);
    for (std::size_t i = 0; i < map->radius.size(); ++i)
        reach.outermost[i % kRound] = std::max(reach.outermost[i % kRound], map->radius[i]);
    reach.is_hidden = hidden_vertices(scene, options.up, reach, *map);
    return reach;
}

std::vector<std::string> blank_warnings(const ReachReport& reach, const Profile& profile) {
    cam::SliceReport report;
    std::vector<double> directions_rad;
    std::vector<double> model_mm;
    for (std::size_t i = 0; i < reach.outermost.size(); ++i) {
        directions_rad.push_back(2.0 * kPi * static_cast<double>(i) /
                                 static_cast<double>(reach.outermost.size()));
        model_mm.push_back(reach.outermost[i] * reach.mm_per_unit);
    }
    const double top_mm = profile.job.base_height_mm + reach.size[2] * reach.mm_per_unit;
    cam::warn_about_blank_size(profile, directions_rad, model_mm, top_mm, report);
    return report.warnings;
}

BlankOutline blank_outline(const ReachReport& reach, const Profile& profile) {
    const BlankProfile& blank = profile.blank;
    BlankOutline outline{reach.axis, reach.blank_radius, -reach.size[2] / 2.0, reach.size[2] / 2.0, 0.0,
                         false};
    if (blank.radius_mm > 0.0) {
        outline.is_chosen = true;
        outline.radius = blank.radius_mm / reach.mm_per_unit;
        outline.centre[0] += blank.offset_x_mm / reach.mm_per_unit;
        outline.centre[1] += blank.offset_z_mm / reach.mm_per_unit;
    }
    if (outline.is_chosen && blank.height_mm > 0.0) {
        // It stands on the table, the model above it.
        outline.low -= profile.job.base_height_mm / reach.mm_per_unit;
        outline.high = outline.low + blank.height_mm / reach.mm_per_unit;
    }
    outline.diameter_mm = 2.0 * outline.radius * reach.mm_per_unit;
    return outline;
}

MeshScene painted_scene(const MeshScene& scene, const ReachReport& reach, std::uint32_t rgb,
                        std::uint32_t hidden_rgb) {
    MeshScene painted = scene;
    painted.vertex_rgb.assign(scene.vertices.size(), rgb);
    for (std::size_t i = 0; i < painted.vertex_rgb.size(); ++i) {
        if (reach.is_hidden[i] != 0) painted.vertex_rgb[i] = hidden_rgb;
    }
    return painted;
}

std::optional<SceneView> view_of_hidden(const MeshScene& scene, const ReachReport& reach, slice::Up up) {
    constexpr std::uint32_t kBlack = 0x000000;
    constexpr std::uint32_t kRed = 0xFF0000;  // however dark its shade is
    constexpr int kAzimuths = 16;
    constexpr std::array kElevations_rad{0.0, 0.35, -0.35, 0.9};
    constexpr std::size_t kSide_px = 160;
    if (std::find(reach.is_hidden.begin(), reach.is_hidden.end(), 1) == reach.is_hidden.end())
        return std::nullopt;
    SpacePicture picture;
    picture.size = scene.size;
    picture.view.up = up;
    picture.is_coarse = true;
    picture.bodies.push_back(
        {std::make_shared<const MeshScene>(painted_scene(scene, reach, kBlack, kRed)), {}});
    SceneView best = picture.view;
    std::uint64_t most = 0;
    for (const double elevation_rad : kElevations_rad) {
        for (int i = 0; i < kAzimuths; ++i) {
            picture.view.elevation_rad = elevation_rad;
            picture.view.azimuth_rad = 2.0 * kPi * i / kAzimuths;
            std::uint64_t seen = 0;
            for (const std::uint32_t pixel : draw_bodies(picture, kSide_px, kSide_px).argb)
                seen += (pixel & kRed) != 0 ? 1 : 0;
            if (seen <= most) continue;
            most = seen;
            best = picture.view;
        }
    }
    return best;
}

}  // namespace psicarve::session
