// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/mesh_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace psicarve::session {
namespace {

using Vec = std::array<double, 3>;

constexpr double kMargin = 0.86;  // of the picture is used
constexpr double kAmbient = 0.42;
constexpr double kDiffuse = 0.58;

double dot(const Vec& a, const Vec& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec minus(const Vec& a, const Vec& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Joins the vertices of one grid cell.
class Clusters {
public:
    Clusters(MeshScene& scene, double cell) : scene_(scene), cell_(cell) {}

    std::uint32_t vertex(const Vec& point) {
        std::uint64_t key = 0;
        for (const double coordinate : point) {
            // Within 21 bits: the box is at most `cells` cells long.
            const auto step = static_cast<std::int64_t>(std::floor(coordinate / cell_)) + (1 << 20);
            key = (key << 21U) | static_cast<std::uint64_t>(step & 0x1FFFFF);
        }
        const auto [place, is_new] =
            known_.try_emplace(key, static_cast<std::uint32_t>(scene_.vertices.size()));
        if (is_new) {
            scene_.vertices.push_back(
                {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])});
        }
        return place->second;
    }

private:
    MeshScene& scene_;
    double cell_;
    std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

/// The picture with what stands in front of what.
struct Raster {
    verify::PixelImage image;
    std::vector<float> depth;

    Raster(std::size_t width, std::size_t height)
        : image{width, height, std::vector<std::uint32_t>(width * height, 0)},
          depth(width * height, -std::numeric_limits<float>::max()) {}

    void fill(const Vec& a, const Vec& b, const Vec& c, std::uint32_t argb);
};

void Raster::fill(const Vec& a, const Vec& b, const Vec& c, std::uint32_t argb) {
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area == 0.0) return;
    const auto clip = [](double value, std::size_t most) {
        return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    const std::size_t left = clip(std::floor(std::min({a[0], b[0], c[0]})), image.width);
    const std::size_t right = clip(std::ceil(std::max({a[0], b[0], c[0]})) + 1.0, image.width);
    const std::size_t top = clip(std::floor(std::min({a[1], b[1], c[1]})), image.height);
    const std::size_t bottom = clip(std::ceil(std::max({a[1], b[1], c[1]})) + 1.0, image.height);
    for (std::size_t y = top; y < bottom; ++y) {
        for (std::size_t x = left; x < right; ++x) {
            const double px = static_cast<double>(x) + 0.5;
            const double py = static_cast<double>(y) + 0.5;
            const double wb = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area;
            const double wc = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area;
            if (wb < 0.0 || wc < 0.0 || wb + wc > 1.0) continue;
            const auto z = static_cast<float>(a[2] + wb * (b[2] - a[2]) + wc * (c[2] - a[2]));
            const std::size_t place = y * image.width + x;
            if (z <= depth[place]) continue;
            depth[place] = z;
            image.argb[place] = argb;
        }
    }
}

/// `normal` in the picture's axes, either way round: files do not always say what is outside.
std::uint32_t shaded(std::uint32_t rgb, const Vec& normal) noexcept {
    const double length = std::sqrt(dot(normal, normal));
    if (length == 0.0) return 0xFF000000U | rgb;
    // From the upper left, in front. y points down.
    constexpr Vec kLight{-0.40, -0.56, 0.725};
    const double side = normal[2] < 0.0 ? -1.0 : 1.0;
    const double light = kAmbient + kDiffuse * std::max(0.0, side * dot(normal, kLight) / length);
    std::uint32_t argb = 0xFF000000U;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const double channel = static_cast<double>((rgb >> shift) & 0xFFU) * light;
        argb |= static_cast<std::uint32_t>(std::min(channel, 255.0)) << shift;
    }
    return argb;
}

}  // namespace

MeshScene make_mesh_scene(const model::Mesh& mesh, std::uint32_t cells) {
    MeshScene scene;
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        scene.size[k] = mesh.facts.max[k] - mesh.facts.min[k];
        scene.middle[k] = (mesh.facts.max[k] + mesh.facts.min[k]) / 2.0;
        longest = std::max(longest, scene.size[k]);
    }
    if (longest <= 0.0 || cells == 0) return scene;
    Clusters clusters{scene, longest / cells};
    for (const model::Triangle& triangle : mesh.triangles) {
        std::array<std::uint32_t, 3> facet{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vec point{};
            for (std::size_t k = 0; k < 3; ++k)
                point[k] = triangle.vertices[corner][k] + mesh.origin[k] - scene.middle[k];
            facet[corner] = clusters.vertex(point);
        }
        const bool is_flat = facet[0] == facet[1] || facet[1] == facet[2] || facet[0] == facet[2];
        if (!is_flat) scene.facets.push_back(facet);
    }
    return scene;
}

SceneCamera::SceneCamera(const MeshScene& scene, const SceneView& view, double width_px, double height_px) {
    const double ca = std::cos(view.azimuth_rad);
    const double sa = std::sin(view.azimuth_rad);
    const double ce = std::cos(view.elevation_rad);
    const double se = std::sin(view.elevation_rad);
    right_ = {-sa, ca, 0.0};
    up_ = {-ca * se, -sa * se, ce};
    towards_ = {ca * ce, sa * ce, se};
    const auto size = slice::placed(view.up, scene.size);
    const double across = std::hypot(size[0], size[1]);
    const double high = std::fabs(size[2] * ce) + across * std::fabs(se);
    const double fit = std::min(width_px / std::max(across, 1e-9), height_px / std::max(high, 1e-9));
    scale_ = kMargin * fit * view.zoom;
    x0_ = width_px / 2.0 + view.pan_x * height_px;
    y0_ = height_px / 2.0 + view.pan_y * height_px;
}

std::array<double, 3> SceneCamera::project(const std::array<double, 3>& p) const noexcept {
    return {x0_ + scale_ * dot(p, right_), y0_ - scale_ * dot(p, up_), scale_ * dot(p, towards_)};
}

verify::PixelImage draw_mesh_scene(const MeshScene& scene, const SceneView& view, std::size_t width_px,
                                   std::size_t height_px, std::uint32_t rgb) {
    Raster raster{width_px, height_px};
    const SceneCamera camera{scene, view, static_cast<double>(width_px), static_cast<double>(height_px)};
    std::vector<Vec> points;
    points.reserve(scene.vertices.size());
    for (const auto& vertex : scene.vertices)
        points.push_back(camera.project(slice::placed(view.up, {vertex[0], vertex[1], vertex[2]})));
    const bool has_colours = scene.facet_rgb.size() == scene.facets.size();
    for (std::size_t i = 0; i < scene.facets.size(); ++i) {
        const auto& facet = scene.facets[i];
        const Vec& a = points[facet[0]];
        const Vec& b = points[facet[1]];
        const Vec& c = points[facet[2]];
        raster.fill(a, b, c, shaded(has_colours ? scene.facet_rgb[i] : rgb, cross(minus(b, a), minus(c, a))));
    }
    return std::move(raster.image);
}

}  // namespace psicarve::session
