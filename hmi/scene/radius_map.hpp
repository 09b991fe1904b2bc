// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/scene/colour_map.hpp"

namespace psicarve::session {

/// An angle as one from 0 to below 360 degrees.
double within_turn(double angle_deg) noexcept;

/// One point of a layer on the workpiece.
struct RimPoint {
    double direction_deg;  ///< of the workpiece, 0 to 360
    double radius_mm;
};
/// The outline that the two heads carve in a layer: R1's half, then R2's, in the order of the points.
struct LayerRim {
    std::vector<RimPoint> r1;
    std::vector<RimPoint> r2;
    double y_mm = 0.0;  ///< at the layer's end
};
/// Requires layer < layer_count.
LayerRim layer_rim(const cam::PreparedJob& job, std::uint32_t layer);

/// A layer point by point: radii over the table's angle, which grows from where the layer begins, within the
/// first turn.
struct LayerCurves {
    std::vector<double> psi_deg;
    std::vector<double> r1_mm;
    std::vector<double> r2_mm;
};
/// Requires layer < layer_count.
LayerCurves layer_curves(const cam::PreparedJob& job, std::uint32_t layer);

/// A range of the workpiece's directions, 0 <= from < to <= 360 degrees, and the head that carves it.
struct HalfSpan {
    double from_deg;
    double to_deg;
    bool is_r2;
};
/// The ranges that each head carves in a layer, from direction 0 on: in a continuous job the heads change
/// sides from layer to layer. Requires layer < layer_count.
std::vector<HalfSpan> half_spans(const cam::PreparedJob& job, std::uint32_t layer);

/// The job's radii unrolled: columns are directions 0 to 360 degrees, rows layers from the lowest up. Coarser
/// than the job where the picture cannot show all.
struct RadiusMap {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<float> radius_mm;  ///< [rows * columns]
    double least_mm = 0.0;         ///< whole mm around all radii
    double most_mm = 0.0;
};
/// Made of the finishing pass.
RadiusMap radius_map(const cam::PreparedJob& job, std::size_t most_columns, std::size_t most_rows);
/// The height in the map of a layer of the job, of any pass: 0 below, 1 above.
double place_in_map(const JobView& job, std::uint32_t layer);

/// The map as a picture, 0xFFRRGGBB, highest layer first. `with_hills`: slopes are lighter and darker.
std::vector<std::uint32_t> radius_picture(const RadiusMap& map, bool with_hills);

}  // namespace psicarve::session
