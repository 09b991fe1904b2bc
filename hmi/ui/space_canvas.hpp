// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "hmi/scene/carved_scene.hpp"
#include "hmi/scene/space_picture.hpp"

namespace psicarve::ui {

/// With what the views of the space are drawn.
enum class Drawing : std::uint8_t { painter, opengl };

/// The drawn part of a view: draws a picture that belongs to its owner whenever it is told that something
/// has changed, and only then.
class SpaceCanvas {
public:
    virtual ~SpaceCanvas() = default;
    virtual QWidget& widget() noexcept = 0;
    virtual void set_background(const QColor& colour) = 0;
    virtual void picture_changed() = 0;
    /// Of a scene that is shown, these vertices are others now.
    virtual void vertices_changed(const session::MeshScene& scene,
                                  const std::vector<session::VertexRange>& ranges) = 0;
};

/// Without OpenGL. Both live as long as `parent`; the picture has to live longer.
SpaceCanvas* make_painter_canvas(const session::SpacePicture& picture, QWidget* parent);
/// `fail` is called once, from the event loop, when the drawing has failed: take another canvas then.
SpaceCanvas* make_gl_canvas(const session::SpacePicture& picture, std::function<void()> fail,
                            QWidget* parent);

}  // namespace psicarve::ui
