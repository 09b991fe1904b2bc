// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::piece {

/// A place on one of the model's edges that stands further out than the model around it, compared in the
/// cells of a stock map without features less than five of them wide: cells show little of such an edge, or
/// nothing.
struct Ridge {
    double direction_rad = 0.0;
    double height_mm = 0.0;
    double radius_mm = 0.0;
    double above_mm = 0.0;  ///< height above the model around it
    std::size_t row = 0;    ///< of the map's nearest cell
    std::size_t column = 0;
};

/// The ridges of a model, and how deep a tool has cut them: along the ray through each, and along rays beside
/// it, one pulse of the machine away, since a ray that only grazes a flank shows nothing.
class Ridges {
public:
    /// Before anything is cut. `wanted_mm`: the model's radii in the map's cells; `rows`: those that the job
    /// carves. Edges are sampled once for each cell of their length and at each layer; in a cell the place
    /// that stands out most counts, and of all cells the 2048 that stand out most.
    Ridges(const PlacedModel& model, const tool::Tool& tool, const StockMap& blank,
           std::span<const float> wanted_mm, std::span<const std::size_t> rows,
           const verify::JobGeometry& geometry);

    /// The tool's axis at a direction and height, its tip at a radius.
    void cut(double direction_rad, double height_mm, double tip_mm);

    std::span<const Ridge> all() const noexcept { return ridges_; }
    /// How much of a ridge is missing, the shortest way to what is left of it; 0 where that is less than the
    /// distance of the rays.
    double missing_mm(std::size_t index) const noexcept;
    /// Whether between the layers below and above a height the tool leaves no more than a row of the map,
    /// along the radius. A point leaves all of it.
    bool is_cleared(double height_mm) const;

private:
    // The ridge itself, on both sides of it, above, below.
    static constexpr std::size_t kRays = 5;
    struct Rays {
        double cosine;
        double sine;
        double beside_mm;  ///< from the ridge's ray to the others
        std::array<float, kRays> radius_mm;
    };
    void cut_rays(std::size_t index, double cosine, double sine, double up_mm, double tip_mm);
    void prick(double direction_rad, double height_mm, double tip_mm);
    double entry_mm(double sine, double up_mm, double tip_mm) const noexcept;
    bool is_point() const noexcept { return tool_.shape == tool::Shape::point; }

    tool::Tool tool_;
    double bottom_mm_;
    double row_mm_;
    double rad_per_pulse_;
    double point_reach_mm_;
    std::vector<double> layers_mm_;       ///< heights, rising
    std::vector<Ridge> ridges_;           ///< by row
    std::vector<Rays> rays_;              ///< one a ridge
    std::vector<std::size_t> row_begin_;  ///< of every row of the map, and the end
};

}  // namespace psicarve::piece
