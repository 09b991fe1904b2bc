// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/contact_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "hmi/model/edge_hash.hpp"

namespace psicarve::tool {
namespace {

// A facet of less area than this share of its longest side squared has no normal that could be believed.
constexpr double kLeastArea = 1e-9;

Point minus(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// One side of a triangle.
struct Side {
    std::uint64_t key;  ///< the same for both directions
    std::uint32_t triangle;
    std::uint8_t corner;  ///< it goes from this one to the next
};

class PartMaker {
public:
    PartMaker(const model::Mesh& mesh, const slice::Placement& placement)
        : triangles_(mesh.triangles),
          facts_(mesh.facts),
          from_(slice::source_coordinate(placement.up)),
          origin_(slice::placed(placement.up, mesh.origin)),
          axis_{placement.axis_x, placement.axis_y, 0.0} {}

    ContactParts make() {
        parts_.facets.reserve(triangles_.size());
        has_area_.assign(triangles_.size(), 0);
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) add_facet(i);
        add_edges();
        return std::move(parts_);
    }

private:
    Point point(std::uint32_t triangle, std::size_t corner) const {
        const auto& vertex = triangles_[triangle].vertices[corner];
        Point result;
        for (std::size_t k = 0; k < 3; ++k) result[k] = origin_[k] - axis_[k] + vertex[from_[k]];
        return result;
    }

    void add_facet(std::uint32_t triangle) {
        Facet facet{{point(triangle, 0), point(triangle, 1), point(triangle, 2)}, {}, 0.0};
        const Point first = minus(facet.corners[1], facet.corners[0]);
        const Point second = minus(facet.corners[2], facet.corners[0]);
        const Point third = minus(facet.corners[2], facet.corners[1]);
        facet.normal = cross(first, second);
        const double length = std::sqrt(dot(facet.normal, facet.normal));
        const double longest2 = std::max({dot(first, first), dot(second, second), dot(third, third)});
        if (!(length > kLeastArea * longest2)) return;
        for (double& value : facet.normal) value /= length;
        facet.distance = dot(facet.normal, facet.corners[0]);
        has_area_[triangle] = 1;
        parts_.facets.push_back(facet);
    }

    void add_edges() {
        std::vector<Side> sides;
        sides.reserve(3 * triangles_.size());
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            std::array<std::uint64_t, 3> hash;
            for (std::size_t k = 0; k < 3; ++k) hash[k] = model::vertex_hash(triangles_[i].vertices[k]);
            for (std::uint8_t k = 0; k < 3; ++k) {
                sides.push_back({model::edge_hash(hash[k], hash[(k + 1U) % 3]), i, k});
            }
        }
        std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
            return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
        });
        for (std::size_t first = 0; first < sides.size();) {
            std::size_t end = first + 1;
            while (end < sides.size() && sides[end].key == sides[first].key) ++end;
            if (end - first == 2 && same_edge(sides[first], sides[first + 1])) {
                if (can_touch(sides[first], sides[first + 1])) add_edge(sides[first]);
            } else {
                for (std::size_t i = first; i < end; ++i) add_edge(sides[i]);
            }
            first = end;
        }
    }

    const std::array<float, 3>& begin_of(const Side& side) const {
        return triangles_[side.triangle].vertices[side.corner];
    }
    const std::array<float, 3>& end_of(const Side& side) const {
        return triangles_[side.triangle].vertices[(side.corner + 1U) % 3];
    }
    bool same_edge(const Side& a, const Side& b) const {
        return begin_of(a) == end_of(b) && end_of(a) == begin_of(b);
    }
    bool can_touch(const Side& a, const Side& b) const {
        if (!facts_.closed || !facts_.same_orientation) return true;
        if (has_area_[a.triangle] == 0 || has_area_[b.triangle] == 0) return true;
        const Point begin = point(a.triangle, a.corner);
        const Point along = minus(point(a.triangle, (a.corner + 1U) % 3), begin);
        const Point inner = minus(point(a.triangle, (a.corner + 2U) % 3), begin);
        const Point other = minus(point(b.triangle, (b.corner + 2U) % 3), begin);
        const double outside = dot(cross(along, inner), other);
        return facts_.signed_volume < 0.0 ? outside > 0.0 : outside < 0.0;
    }
    void add_edge(const Side& side) {
        parts_.edges.push_back(
            {point(side.triangle, side.corner), point(side.triangle, (side.corner + 1U) % 3)});
    }

    const model::TriangleList& triangles_;
    const model::MeshFacts& facts_;
    std::array<std::size_t, 3> from_;
    std::array<double, 3> origin_;
    Point axis_;
    std::vector<std::uint8_t> has_area_;
    ContactParts parts_;
};

}  // namespace

ContactParts contact_parts(const model::Mesh& mesh, const slice::Placement& placement) {
    return PartMaker(mesh, placement).make();
}

}  // namespace psicarve::tool
