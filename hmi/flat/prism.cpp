// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/prism.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hmi/flat/ear_clipping.hpp"
#include "hmi/model/indexed_mesh.hpp"
#include "hmi/model/mesh_check.hpp"

namespace psicarve::flat {
namespace {

/// Walls and both ends over one ring: points 2i at the bottom, 2i + 1 at the top.
void add_ring(const std::vector<Point>& ring, double height_mm, model::IndexedMesh& mesh) {
    const std::uint64_t base = mesh.point_count();
    const std::uint64_t n = ring.size();
    for (const Point& p : ring) {
        mesh.add_point({p.x, p.y, 0.0});
        mesh.add_point({p.x, p.y, height_mm});
    }
    for (std::uint64_t i = 0; i < n; ++i) {
        const std::uint64_t next = (i + 1) % n;
        mesh.add_polygon(std::array{base + 2 * i, base + 2 * next, base + 2 * next + 1, base + 2 * i + 1});
    }
    for (const auto& [a, b, c] : triangles_of(ring)) {
        mesh.add_polygon(std::array<std::uint64_t, 3>{base + 2 * a + 1, base + 2 * b + 1, base + 2 * c + 1});
        mesh.add_polygon(std::array<std::uint64_t, 3>{base + 2 * c, base + 2 * b, base + 2 * a});
    }
}

}  // namespace

Result<model::Mesh> prism_of(const Outline& outline, double height_mm, const std::string& format,
                             const std::string& file) {
    model::IndexedMesh mesh;
    for (const auto& ring : outline.outers) add_ring(ring, height_mm, mesh);
    model::Mesh made = mesh.finish(format);
    made.axis_hint = std::array{outline.centroid.x, outline.centroid.y};
    if (auto good = model::judge_mesh(made, file); !good) return good.error();
    made.warnings.insert(made.warnings.begin(), outline.warnings.begin(), outline.warnings.end());
    return made;
}

}  // namespace psicarve::flat
