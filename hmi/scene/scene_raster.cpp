// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "hmi/scene/scene_camera.hpp"
#include "hmi/scene/space_picture.hpp"

namespace psicarve::session {
namespace {

using Vec = std::array<double, 3>;

Vec cross(const Vec& a, const Vec& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec minus(const Vec& a, const Vec& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The picture with a depth for each pixel.
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
    // Weights of b and c, which grow evenly along a row.
    const double wb_step = (c[1] - a[1]) / area;
    const double wc_step = -(b[1] - a[1]) / area;
    for (std::size_t y = top; y < bottom; ++y) {
        const double px = static_cast<double>(left) + 0.5 - a[0];
        const double py = static_cast<double>(y) + 0.5 - a[1];
        double wb = px * wb_step - py * (c[0] - a[0]) / area;
        double wc = px * wc_step + py * (b[0] - a[0]) / area;
        for (std::size_t x = left; x < right; ++x, wb += wb_step, wc += wc_step) {
            if (wb < 0.0 || wc < 0.0 || wb + wc > 1.0) continue;
            const auto z = static_cast<float>(a[2] + wb * (b[2] - a[2]) + wc * (c[2] - a[2]));
            const std::size_t place = y * image.width + x;
            if (z <= depth[place]) continue;
            depth[place] = z;
            image.argb[place] = argb;
        }
    }
}

/// `normal` in the picture's axes, either way round: files do not always give the outside.
std::uint32_t shaded(std::uint32_t rgb, const Vec& normal) noexcept {
    const double length = std::sqrt(dot(normal, normal));
    if (length == 0.0) return 0xFF000000U | rgb;
    const double side = normal[2] < 0.0 ? -1.0 : 1.0;
    const double light = kAmbient + kDiffuse * std::max(0.0, side * dot(normal, kLight) / length);
    std::uint32_t argb = 0xFF000000U;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const double channel = static_cast<double>((rgb >> shift) & 0xFFU) * light;
        argb |= static_cast<std::uint32_t>(std::min(channel, 255.0)) << shift;
    }
    return argb;
}

const std::vector<Facet>& facets_of(const MeshScene& scene, bool is_coarse) noexcept {
    return is_coarse && !scene.coarse_facets.empty() ? scene.coarse_facets : scene.facets;
}

void draw_body(Raster& raster, const SceneBody& body, const SceneMatrix& matrix, bool is_coarse) {
    const MeshScene& scene = *body.scene;
    std::vector<Vec> points;
    points.reserve(scene.vertices.size());
    for (const auto& vertex : scene.vertices) points.push_back(matrix.project(vertex));
    const bool has_colours = scene.vertex_rgb.size() == scene.vertices.size();
    for (const Facet& facet : facets_of(scene, is_coarse)) {
        const Vec& a = points[facet[0]];
        const Vec& b = points[facet[1]];
        const Vec& c = points[facet[2]];
        const std::uint32_t rgb = has_colours ? scene.vertex_rgb[facet[0]] : body.rgb;
        raster.fill(a, b, c, shaded(rgb, cross(minus(b, a), minus(c, a))));
    }
}

}  // namespace

std::size_t facet_count(const SpacePicture& picture) noexcept {
    std::size_t count = 0;
    for (const SceneBody& body : picture.bodies) {
        if (body.scene) count += facets_of(*body.scene, picture.is_coarse).size();
    }
    return count;
}

bool has_same_view(const SpacePicture& a, const SpacePicture& b) noexcept {
    return a.size == b.size && a.view == b.view;
}

bool has_same_bodies(const SpacePicture& a, const SpacePicture& b) noexcept {
    return has_same_view(a, b) && a.is_coarse == b.is_coarse && a.bodies == b.bodies;
}

verify::PixelImage draw_bodies(const SpacePicture& picture, std::size_t width_px, std::size_t height_px) {
    Raster raster{width_px, height_px};
    const SceneCamera camera{picture.size, picture.view, static_cast<double>(width_px),
                             static_cast<double>(height_px)};
    for (const SceneBody& body : picture.bodies) {
        if (body.scene)
            draw_body(raster, body, scene_matrix(camera, picture.view.up, body.place), picture.is_coarse);
    }
    return std::move(raster.image);
}

}  // namespace psicarve::session
