// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLBuffer>

#include <memory>
#include <unordered_map>
#include <vector>

#include "hmi/scene/carved_scene.hpp"
#include "hmi/scene/space_picture.hpp"
#include "hmi/ui/gl_program.hpp"

namespace psicarve::ui {

/// Scenes in the memory of the graphics card: each is sent once, later only what has changed. Everything but
/// note_change requires the current context.
class GlMeshes {
public:
    /// To be sent before the scene is drawn again.
    void note_change(const session::MeshScene& scene, const std::vector<session::VertexRange>& ranges);
    /// Forgets those that are not in the picture any more.
    void keep_only(const session::SpacePicture& picture);
    void draw(GlProgram& program, const session::SceneBody& body, bool is_coarse);
    void clear() { meshes_.clear(); }

private:
    struct Mesh {
        std::shared_ptr<const session::MeshScene> scene;  // so that no other gets its address
        std::uint32_t rgb = 0;
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer};
        QOpenGLBuffer fine{QOpenGLBuffer::IndexBuffer};
        QOpenGLBuffer coarse{QOpenGLBuffer::IndexBuffer};
        std::vector<session::VertexRange> changed;
    };
    Mesh& sent(const session::SceneBody& body);

    std::unordered_map<const session::MeshScene*, Mesh> meshes_;
};

}  // namespace psicarve::ui
