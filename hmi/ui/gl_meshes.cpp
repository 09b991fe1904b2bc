// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_meshes.hpp"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>
#include <array>

namespace psicarve::ui {
namespace {

std::vector<GlVertex> vertices_of(const session::MeshScene& scene, std::uint32_t rgb,
                                  const session::VertexRange& range) {
    const bool has_colours = scene.vertex_rgb.size() == scene.vertices.size();
    std::vector<GlVertex> vertices;
    vertices.reserve(range.count);
    for (std::size_t i = range.first; i < range.first + range.count; ++i) {
        const std::uint32_t paint = has_colours ? scene.vertex_rgb[i] : rgb;
        const auto channel = [paint](unsigned shift) {
            return static_cast<std::uint8_t>(paint >> shift & 0xFFU);
        };
        vertices.push_back({scene.vertices[i], {channel(16), channel(8), channel(0), 255}});
    }
    return vertices;
}

void fill(QOpenGLBuffer& buffer, const void* data, std::size_t bytes) {
    buffer.create();
    buffer.bind();
    buffer.allocate(data, static_cast<int>(bytes));
}

}  // namespace

void GlMeshes::note_change(const session::MeshScene& scene, const std::vector<session::VertexRange>& ranges) {
    const auto found = meshes_.find(&scene);
    if (found == meshes_.end()) return;  // it will be sent as it is then
    auto& changed = found->second.changed;
    changed.insert(changed.end(), ranges.begin(), ranges.end());
}

void GlMeshes::keep_only(const session::SpacePicture& picture) {
    std::erase_if(meshes_, [&picture](const auto& entry) {
        return std::none_of(
            picture.bodies.begin(), picture.bodies.end(),
            [&entry](const session::SceneBody& body) { return body.scene.get() == entry.first; });
    });
}

GlMeshes::Mesh& GlMeshes::sent(const session::SceneBody& body) {
    const auto [place, is_new] = meshes_.try_emplace(body.scene.get());
    Mesh& mesh = place->second;
    const session::MeshScene& scene = *body.scene;
    if (is_new || mesh.rgb != body.rgb) {
        mesh.scene = body.scene;
        mesh.rgb = body.rgb;
        mesh.changed.clear();
        const auto vertices = vertices_of(scene, body.rgb, {0, scene.vertices.size()});
        fill(mesh.vertices, vertices.data(), vertices.size() * sizeof(GlVertex));
        fill(mesh.fine, scene.facets.data(), scene.facets.size() * sizeof(session::Facet));
        fill(mesh.coarse, scene.coarse_facets.data(), scene.coarse_facets.size() * sizeof(session::Facet));
    }
    mesh.vertices.bind();
    for (const session::VertexRange& range : mesh.changed) {
        const auto vertices = vertices_of(scene, body.rgb, range);
        mesh.vertices.write(static_cast<int>(range.first * sizeof(GlVertex)), vertices.data(),
                            static_cast<int>(vertices.size() * sizeof(GlVertex)));
    }
    mesh.changed.clear();
    return mesh;
}

void GlMeshes::draw(GlProgram& program, const session::SceneBody& body, bool is_coarse) {
    if (!body.scene || body.scene->facets.empty()) return;
    auto* const gl = QOpenGLContext::currentContext()->functions();
    Mesh& mesh = sent(body);
    const bool takes_coarse = is_coarse && !body.scene->coarse_facets.empty();
    (takes_coarse ? mesh.coarse : mesh.fine).bind();
    program.take_vertices();
    const auto& facets = takes_coarse ? body.scene->coarse_facets : body.scene->facets;
    gl->glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * facets.size()), GL_UNSIGNED_INT, nullptr);
    (takes_coarse ? mesh.coarse : mesh.fine).release();
    mesh.vertices.release();
}

}  // namespace psicarve::ui
