// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"

/// Closed test bodies, outsides outside. All coordinates in file units.
namespace psicarve::shapes {

using Point = std::array<double, 3>;

inline std::array<float, 3> to_float(const Point& p) {
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// Collects facets into a mesh as a reader would.
class Builder {
public:
    Builder& facet(const Point& a, const Point& b, const Point& c) {
        facets_.push_back({{to_float(a), to_float(b), to_float(c)}});
        return *this;
    }
    Builder& quad(const Point& a, const Point& b, const Point& c, const Point& d) {
        return facet(a, b, c).facet(a, c, d);
    }
    Builder& add(const model::Mesh& mesh) {
        facets_.insert(facets_.end(), mesh.triangles.begin(), mesh.triangles.end());
        return *this;
    }
    model::Mesh mesh() const {
        model::Mesh out;
        out.format = "test";
        out.source_name = "shape";
        model::MeshCheck check;
        for (const model::Triangle& facet : facets_) check.add_to(out.triangles, facet);
        out.facts = check.facts(out.origin);
        return out;
    }

private:
    std::vector<model::Triangle> facets_;
};

inline model::Mesh box(const Point& low, const Point& high) {
    const auto corner = [&](int x, int y, int z) {
        return Point{x != 0 ? high[0] : low[0], y != 0 ? high[1] : low[1], z != 0 ? high[2] : low[2]};
    };
    Builder b;
    b.quad(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
    b.quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    b.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
    b.quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
    b.quad(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1));
    b.quad(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
    return b.mesh();
}

/// A closed surface over a grid: `at(i, j)` with j going round counter-clockwise and i rising; the two ends
/// are closed by a fan, or with `ring` joined to each other.
inline model::Mesh grid(std::size_t rows, std::size_t columns, bool ring,
                        const std::function<Point(std::size_t, std::size_t)>& at) {
    Builder b;
    const auto wrapped = [&](std::size_t i, std::size_t j) { return at(ring ? i % rows : i, j % columns); };
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            b.quad(wrapped(i, j), wrapped(i, j + 1), wrapped(i + 1, j + 1), wrapped(i + 1, j));
        }
    }
    for (const std::size_t end : {std::size_t{0}, rows}) {
        if (ring) break;
        Point middle{};
        for (std::size_t j = 0; j < columns; ++j) {
            for (std::size_t k = 0; k < 3; ++k) middle[k] += at(end, j)[k] / static_cast<double>(columns);
        }
        for (std::size_t j = 0; j < columns; ++j) {
            if (end == 0) b.facet(middle, wrapped(end, j + 1), wrapped(end, j));
            if (end != 0) b.facet(middle, wrapped(end, j), wrapped(end, j + 1));
        }
    }
    return b.mesh();
}

inline double turn_part(std::size_t j, std::size_t columns) {
    return 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(columns);
}

/// An upright prism: with many columns a cylinder.
inline model::Mesh cylinder(double radius, double bottom, double top, std::size_t columns, double x = 0.0,
                            double y = 0.0) {
    return grid(1, columns, false, [=](std::size_t i, std::size_t j) {
        const double t = turn_part(j, columns);
        return Point{x + radius * std::cos(t), y + radius * std::sin(t), i == 0 ? bottom : top};
    });
}

/// A sphere about (0, 0, radius), its caps cut off very near the poles.
inline model::Mesh sphere(double radius, std::size_t rows, std::size_t columns) {
    return grid(rows, columns, false, [=](std::size_t i, std::size_t j) {
        const double part = (static_cast<double>(i) + 0.01) / (static_cast<double>(rows) + 0.02);
        const double lift = std::numbers::pi * (part - 0.5);
        const double t = turn_part(j, columns);
        return Point{radius * std::cos(lift) * std::cos(t), radius * std::cos(lift) * std::sin(t),
                     radius + radius * std::sin(lift)};
    });
}

/// A ring round the z axis, its lowest point at z = 0.
inline model::Mesh torus(double ring_radius, double tube_radius, std::size_t rows, std::size_t columns) {
    return grid(rows, columns, true, [=](std::size_t i, std::size_t j) {
        const double tube = turn_part(i, rows);
        const double t = turn_part(j, columns);
        const double r = ring_radius + tube_radius * std::cos(tube);
        return Point{r * std::cos(t), r * std::sin(t), tube_radius + tube_radius * std::sin(tube)};
    });
}

/// A spring: a tube wound round the z axis; most sections do not contain the axis, much hides behind itself.
inline model::Mesh spring(double coil_radius, double tube_radius, double turns, double height,
                          std::size_t rows, std::size_t columns) {
    return grid(rows, columns, false, [=](std::size_t i, std::size_t j) {
        const double along = static_cast<double>(i) / static_cast<double>(rows);
        const double t = 2.0 * std::numbers::pi * turns * along;
        const double around = -turn_part(j, columns);
        const double r = coil_radius + tube_radius * std::cos(around);
        return Point{r * std::cos(t), r * std::sin(t), tube_radius * std::sin(around) + along * height};
    });
}

/// An upright body of deep folds that leans, so that its sections wander away from the axis.
inline model::Mesh figurine(double size, std::size_t rows, std::size_t columns) {
    return grid(rows, columns, false, [=](std::size_t i, std::size_t j) {
        const double u = static_cast<double>(i) / static_cast<double>(rows);
        const double t = turn_part(j, columns);
        const double r = 0.2 + 0.07 * std::sin(9.0 * u) + 0.05 * std::sin(5.0 * t + 7.0 * u) +
                         0.02 * std::cos(17.0 * t - 23.0 * u);
        return Point{size * (r * std::cos(t) + 0.3 * u * u), size * (r * std::sin(t) - 0.1 * u), size * u};
    });
}

/// The mesh with every point moved by `move`.
inline model::Mesh moved(const model::Mesh& mesh, const std::function<Point(const Point&)>& move) {
    Builder b;
    for (const model::Triangle& t : mesh.triangles) {
        std::array<Point, 3> p{};
        for (std::size_t v = 0; v < 3; ++v) {
            p[v] = move({t.vertices[v][0], t.vertices[v][1], t.vertices[v][2]});
        }
        b.facet(p[0], p[1], p[2]);
    }
    return b.mesh();
}

/// Three arms of different lengths at different heights: along +x 9 long at the bottom, along +y 6 long in
/// the middle, along -x 4 long at the top. No rotation makes it its own mirror image.
inline model::Mesh letter() {
    return Builder()
        .add(box({-1, -1, 0}, {9, 1, 4}))
        .add(box({-1, -1, 4}, {1, 6, 8}))
        .add(box({-4, -1, 8}, {1, 1, 12}))
        .mesh();
}

}  // namespace psicarve::shapes
