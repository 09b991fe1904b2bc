// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/radius_map.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr double kMostHill = 0.18;  // of the lightness

/// A head's pulses as the real radius of its tip.
struct Head {
    double pulses_per_mm;
    double tip_mm;
    double turned_deg;  ///< its direction, seen from R1's

    double radius_mm(std::int32_t pulses) const noexcept {
        return mm_from_pulses(pulses, pulses_per_mm) + tip_mm;
    }
};

std::array<Head, 2> heads_of(const Profile& profile) {
    constexpr double kOpposite_deg = kDegPerRev / 2.0;
    return {
        Head{profile.r1.pulses_per_mm, profile.r1.tip_mm(), 0.0},
        Head{profile.r2.pulses_per_mm, profile.r2.tip_mm(), kOpposite_deg + profile.head_r2_angle_error_deg}};
}

/// The table's angle within a turn at which a layer begins.
double start_of(const cam::PreparedJob& job, std::uint32_t layer) {
    const std::int64_t per_rev = job.profile.psi.pulses_per_rev;
    return within_turn(deg_from_pulses(job.view.psi_pulses(layer, 0) % per_rev, per_rev));
}

std::vector<RimPoint> half_rim(const cam::PreparedJob& job, std::uint32_t layer,
                               std::span<const std::int32_t> radii, const Head& head) {
    std::vector<RimPoint> rim;
    rim.reserve(radii.size());
    for (std::uint32_t point = 0; point < radii.size(); ++point) {
        const double psi_deg =
            deg_from_pulses(job.view.psi_pulses(layer, point), job.profile.psi.pulses_per_rev);
        rim.push_back({within_turn(psi_deg + head.turned_deg), head.radius_mm(radii[point])});
    }
    return rim;
}

void fill_row(const cam::PreparedJob& job, std::uint32_t layer, std::span<float> row) {
    const auto heads = heads_of(job.profile);
    const std::uint32_t steps = job.view.point_count() - 1;
    const double start_deg = start_of(job, layer);
    constexpr double kHalf_deg = kDegPerRev / 2.0;
    for (std::size_t column = 0; column < row.size(); ++column) {
        const double direction_deg =
            (static_cast<double>(column) + 0.5) * kDegPerRev / static_cast<double>(row.size());
        const double turned_deg = within_turn(direction_deg - start_deg);
        const bool is_r2 = turned_deg >= kHalf_deg;
        const double along = (is_r2 ? turned_deg - kHalf_deg : turned_deg) / kHalf_deg;
        const auto point = static_cast<std::uint32_t>(std::lround(along * steps));
        const auto radii = is_r2 ? job.view.r_right_pulses(layer) : job.view.r_left_pulses(layer);
        row[column] = static_cast<float>(heads[is_r2 ? 1 : 0].radius_mm(radii[std::min(point, steps)]));
    }
}

std::uint32_t scaled(std::uint32_t rgb, double factor) noexcept {
    std::uint32_t result = 0;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const double channel = static_cast<double>((rgb >> shift) & 0xFFU) * factor;
        result |= static_cast<std::uint32_t>(std::clamp(channel, 0.0, 255.0)) << shift;
    }
    return result;
}

}  // namespace

double within_turn(double angle_deg) noexcept {
    const double rest = std::fmod(angle_deg, kDegPerRev);
    return rest < 0.0 ? rest + kDegPerRev : rest;
}

LayerRim layer_rim(const cam::PreparedJob& job, std::uint32_t layer) {
    const auto heads = heads_of(job.profile);
    LayerRim rim;
    rim.r1 = half_rim(job, layer, job.view.r_left_pulses(layer), heads[0]);
    rim.r2 = half_rim(job, layer, job.view.r_right_pulses(layer), heads[1]);
    rim.y_mm = mm_from_pulses(job.view.layer_heights_pulses()[layer], job.profile.y.pulses_per_mm);
    return rim;
}

LayerCurves layer_curves(const cam::PreparedJob& job, std::uint32_t layer) {
    const auto heads = heads_of(job.profile);
    const std::int64_t per_rev = job.profile.psi.pulses_per_rev;
    const std::int64_t first_pulses = job.view.psi_pulses(layer, 0);
    const double start_deg = start_of(job, layer);
    LayerCurves curves;
    for (std::uint32_t point = 0; point < job.view.point_count(); ++point) {
        curves.psi_deg.push_back(start_deg +
                                 deg_from_pulses(job.view.psi_pulses(layer, point) - first_pulses, per_rev));
        curves.r1_mm.push_back(heads[0].radius_mm(job.view.r_left_pulses(layer)[point]));
        curves.r2_mm.push_back(heads[1].radius_mm(job.view.r_right_pulses(layer)[point]));
    }
    return curves;
}

std::vector<HalfSpan> half_spans(const cam::PreparedJob& job, std::uint32_t layer) {
    constexpr double kHalf_deg = kDegPerRev / 2.0;
    const double start_deg = start_of(job, layer);
    const bool is_late = start_deg >= kHalf_deg;  // R1's half goes on beyond direction 0
    const double change_deg = is_late ? start_deg - kHalf_deg : start_deg;
    std::vector<HalfSpan> spans;
    if (change_deg > 0.0) spans.push_back({0.0, change_deg, !is_late});
    spans.push_back({change_deg, change_deg + kHalf_deg, is_late});
    spans.push_back({change_deg + kHalf_deg, kDegPerRev, !is_late});
    return spans;
}

RadiusMap radius_map(const cam::PreparedJob& job, std::size_t most_columns, std::size_t most_rows) {
    RadiusMap map;
    const std::size_t first = job.view.finishing_layer();
    const std::size_t layers = job.view.layer_count() - first;
    map.columns = std::min<std::size_t>(most_columns, 2 * (std::size_t{job.view.point_count()} - 1));
    map.rows = std::min(most_rows, layers);
    map.radius_mm.resize(map.columns * map.rows);
    for (std::size_t row = 0; row < map.rows; ++row) {
        const auto layer = static_cast<std::uint32_t>(first + (2 * row + 1) * layers / (2 * map.rows));
        fill_row(job, layer, std::span{map.radius_mm}.subspan(row * map.columns, map.columns));
    }
    const auto [least, most] = std::minmax_element(map.radius_mm.begin(), map.radius_mm.end());
    map.least_mm = std::floor(*least);
    map.most_mm = std::max<double>(std::ceil(*most), map.least_mm + 1.0);
    return map;
}

double place_in_map(const JobView& job, std::uint32_t layer) {
    const auto finishing = job.layer_heights_pulses().subspan(job.finishing_layer());
    const auto count = static_cast<double>(finishing.size());
    if (layer >= job.finishing_layer()) return (layer - job.finishing_layer() + 0.5) / count;
    const auto above =
        std::lower_bound(finishing.begin(), finishing.end(), job.layer_heights_pulses()[layer]);
    return std::min(static_cast<double>(above - finishing.begin()) + 0.5, count) / count;
}

std::vector<std::uint32_t> radius_picture(const RadiusMap& map, bool with_hills) {
    std::vector<std::uint32_t> picture(map.radius_mm.size());
    const double range_mm = map.most_mm - map.least_mm;
    for (std::size_t row = 0; row < map.rows; ++row) {
        const float* const radii = map.radius_mm.data() + row * map.columns;
        const float* const below = row > 0 ? radii - map.columns : radii;
        for (std::size_t column = 0; column < map.columns; ++column) {
            const double radius_mm = radii[column];
            const double beside_mm = radii[column > 0 ? column - 1 : map.columns - 1];
            const double slope = (radius_mm - beside_mm - (radius_mm - below[column])) * 24.0 / range_mm;
            const double hill = with_hills ? std::clamp(slope, -1.0, 1.0) * kMostHill : 0.0;
            const std::uint32_t rgb = scaled(viridis((radius_mm - map.least_mm) / range_mm), 1.0 + hill);
            picture[(map.rows - 1 - row) * map.columns + column] = 0xFF000000U | rgb;
        }
    }
    return picture;
}

}  // namespace psicarve::session
