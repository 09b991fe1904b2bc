// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/mesh_scene.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace psicarve::session {
namespace {

/// QPainter's renderer needs 15 ms for these.
constexpr std::size_t kMostFacets = 150'000;
constexpr double kOneLess = 0.9;  // of the cells, at least, from try to try

/// Numbers for the cells of a grid: the first vertex that falls into a cell stands for all.
class Cells {
public:
    explicit Cells(double cell) : cell_(cell) {}

    /// The vertex of this point's cell; `fresh` when the cell had none.
    std::uint32_t vertex(const std::array<double, 3>& point, std::uint32_t fresh) {
        std::uint64_t key = 0;
        for (const double coordinate : point) {
            // Within 21 bits: the box is at most `cells` cells long.
            const auto step = static_cast<std::int64_t>(std::floor(coordinate / cell_)) + (1 << 20);
            key = (key << 21U) | static_cast<std::uint64_t>(step & 0x1FFFFF);
        }
        return known_.try_emplace(key, fresh).first->second;
    }

private:
    double cell_;
    std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

bool is_flat(const Facet& facet) noexcept {
    return facet[0] == facet[1] || facet[1] == facet[2] || facet[0] == facet[2];
}

/// The scene's facets between fewer of its vertices.
std::vector<Facet> coarser_facets(const MeshScene& scene, double cell) {
    Cells cells{cell};
    std::vector<std::uint32_t> stands_for(scene.vertices.size());
    for (std::uint32_t i = 0; i < scene.vertices.size(); ++i) {
        const auto& vertex = scene.vertices[i];
        stands_for[i] = cells.vertex({vertex[0], vertex[1], vertex[2]}, i);
    }
    std::vector<Facet> facets;
    for (const Facet& fine : scene.facets) {
        const Facet facet{stands_for[fine[0]], stands_for[fine[1]], stands_for[fine[2]]};
        if (!is_flat(facet)) facets.push_back(facet);
    }
    return facets;
}

}  // namespace

MeshScene make_mesh_scene(const model::Mesh& mesh, std::uint32_t cells, std::uint32_t coarse_cells) {
    MeshScene scene;
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        scene.size[k] = mesh.facts.max[k] - mesh.facts.min[k];
        scene.middle[k] = (mesh.facts.max[k] + mesh.facts.min[k]) / 2.0;
        longest = std::max(longest, scene.size[k]);
    }
    if (longest <= 0.0 || cells == 0) return scene;
    Cells fine_cells{longest / cells};
    for (const model::Triangle& triangle : mesh.triangles) {
        Facet facet{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::array<double, 3> point{};
            for (std::size_t k = 0; k < 3; ++k)
                point[k] = triangle.vertices[corner][k] + mesh.origin[k] - scene.middle[k];
            const auto fresh = static_cast<std::uint32_t>(scene.vertices.size());
            facet[corner] = fine_cells.vertex(point, fresh);
            if (facet[corner] == fresh)
                scene.vertices.push_back({static_cast<float>(point[0]), static_cast<float>(point[1]),
                                          static_cast<float>(point[2])});
        }
        if (!is_flat(facet)) scene.facets.push_back(facet);
    }
    // Facets grow with the square of the cells, at most.
    for (double fewer = cells; scene.facets.size() > kMostFacets;) {
        fewer *= std::min(
            kOneLess, std::sqrt(static_cast<double>(kMostFacets) / static_cast<double>(scene.facets.size())));
        scene.facets = coarser_facets(scene, longest / fewer);
    }
    if (coarse_cells > 0 && coarse_cells < cells)
        scene.coarse_facets = coarser_facets(scene, longest / coarse_cells);
    return scene;
}

}  // namespace psicarve::session
