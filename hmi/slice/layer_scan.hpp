// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/placement.hpp"

namespace psicarve::slice {

/// Totals of one layer. Radii in file units.
struct LayerTotals {
    std::uint32_t open_cells = 0;    ///< directions whose wall count differs in parity from the layer's: a
                                     ///< hole there
    std::uint32_t empty_cells = 0;   ///< directions that meet no wall
    std::uint32_t hidden_walls = 0;  ///< walls behind another in the same direction
    std::uint32_t walls = 0;
    std::uint32_t turned_cells = 0;  ///< directions where outsides and insides do not alternate
    bool has_section = false;        ///< the layer cuts the model at all
    bool contains_axis = false;      ///< the axis is inside the section
    bool is_odd = false;             ///< most directions meet an odd number of walls; for a single solid this
                                     ///< equals contains_axis
    double radius_sum = 0.0;         ///< over all walls
    double outer_sum = 0.0;          ///< over the outermost walls
    double radius_max = 0.0;
};

/// The section of one layer, seen from the axis.
struct LayerSection {
    std::size_t layer = 0;
    std::span<const double> radius;        ///< outermost wall in each direction, file units; 0: none
    std::span<const std::uint32_t> walls;  ///< how many stand in each direction
    const LayerTotals* totals = nullptr;
};

/// A piece of a section's outline, seen from above: from P to Q the solid lies on the left.
struct SectionSegment {
    double px;
    double py;
    double qx;
    double qy;
};

/// Cuts facets of a mesh at a height.
class FacetCutter {
public:
    /// `shift_x`, `shift_y` are taken off the stored coordinates once they are turned upright.
    FacetCutter(Up up, double shift_x, double shift_y) noexcept
        : from_(source_coordinate(up)), shift_x_(shift_x), shift_y_(shift_y) {}

    /// Requires lowest z <= z < highest z (stored coordinates). Edges are cut from their lower vertex, so
    /// that both facets of an edge get the same point, bit for bit.
    SectionSegment cut(const model::Triangle& facet, double z) const noexcept;

    /// A vertex, upright and shifted; z in stored coordinates.
    struct Corner {
        double x;
        double y;
        float z;
    };
    Corner corner(const model::Triangle& facet, std::size_t vertex) const noexcept {
        const auto& v = facet.vertices[vertex];
        return {v[from_[0]] - shift_x_, v[from_[1]] - shift_y_, v[from_[2]]};
    }

private:
    std::array<std::size_t, 3> from_;
    double shift_x_;
    double shift_y_;
};

/// Scan-converts the sections of facets in angle, one layer at a time. Cells hold the outermost radius and
/// how many walls turn their outside to the direction, and how many their inside.
class LayerScan {
public:
    /// `directions` outlives the scan.
    explicit LayerScan(const Directions& directions);

    /// Draws a segment as seen from the axis at (0, 0).
    void add_segment(const SectionSegment& segment) noexcept;
    /// Draws several, kMostAtOnce at most: quicker, since they do not wait for each other.
    void add_segments(std::span<const SectionSegment> segments) noexcept;
    static constexpr std::size_t kMostAtOnce = 64;
    /// Draws a segment in one sorted cell alone.
    void add_segment_in(const SectionSegment& segment, std::uint32_t cell) noexcept;

    /// Whether an odd number of walls stands in a sorted cell so far: its ray has left the solid for good.
    bool is_odd(std::uint32_t cell) const noexcept {
        return ((walls_[cell] ^ walls_[cell] >> 16U) & 1U) != 0;
    }
    /// Ends the layer and clears the cells: its totals and radii are valid until the next segment.
    const LayerTotals& finish() noexcept;
    std::span<const double> radius() const noexcept { return result_; }
    std::span<const std::uint32_t> wall_counts() const noexcept { return result_walls_; }

private:
    struct Wall;
    struct SeenWall;
    struct Ends;
    Ends ends_of(const SectionSegment& segment) const noexcept;
    static bool see(const SectionSegment& segment, const Ends& ends, SeenWall& seen) noexcept;
    void draw(const SeenWall& seen) noexcept;
    void draw(const Wall& wall, std::uint32_t first, std::uint32_t end) noexcept;
    void draw_radial(const Wall& wall, std::uint32_t first, std::uint32_t end) noexcept;

    const Directions& directions_;
    std::vector<double> outer_;
    std::vector<std::uint32_t> walls_;  ///< low half: outsides, high half: insides
    std::vector<double> result_;
    std::vector<std::uint32_t> result_walls_;
    LayerTotals totals_;
    double radius_sum_ = 0.0;
};

}  // namespace psicarve::slice
