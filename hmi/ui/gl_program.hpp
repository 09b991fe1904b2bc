// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLShaderProgram>

#include <array>
#include <cstdint>

#include "hmi/scene/scene_camera.hpp"

namespace psicarve::ui {

struct GlVertex {
    std::array<float, 3> place;
    std::array<std::uint8_t, 4> colour;
};
static_assert(sizeof(GlVertex) == 16);

/// The one shader program of our views: facets lit as draw_bodies lights them, lines as they are. For OpenGL
/// 2.0, OpenGL ES 2 and all that came after. Requires a current context.
class GlProgram {
public:
    /// False when the driver does not take it; log() says why.
    bool make();
    QString log() const { return program_.log(); }

    /// `depth`: no point lies further from the middle, towards the viewer or away [px].
    void begin(double width_px, double height_px, double depth_px);
    void set_matrix(const session::SceneMatrix& matrix);
    void set_light(bool is_lit);
    /// What is drawn next comes from the buffer that is bound: GlVertex after GlVertex.
    void take_vertices();
    void end() { program_.release(); }

private:
    QOpenGLShaderProgram program_;
};

}  // namespace psicarve::ui
