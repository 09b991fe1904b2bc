// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QPointF>
#include <QWidget>

#include <array>
#include <memory>
#include <vector>

#include "hmi/session/mesh_scene.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// The model in space, drawn without OpenGL: turned with the left button, moved with the right, zoomed with
/// the wheel. Redrawn only when something changed.
class MeshView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MeshView)
public:
    enum class Side : std::uint8_t { front, side, top, iso };

    /// Something at a place in the scene (placed coordinates), with its name.
    struct Mark {
        std::array<double, 3> place;
        QColor colour;
        QString name;
    };

    explicit MeshView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_scene(std::shared_ptr<const session::MeshScene> scene);
    /// The same thing in another state: seen as before.
    void replace_scene(std::shared_ptr<const session::MeshScene> scene);
    void set_marks(std::vector<Mark> marks);
    /// Shown while there is no scene.
    void set_empty_text(const QString& text) { empty_text_ = text; }
    void set_up(slice::Up up);
    /// Where the rotation axis passes, in the turned model's file units.
    void set_axis_at_origin(bool at_origin);
    void look_from(Side side);
    void fit();
    const session::SceneView& view() const noexcept { return view_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void redraw();
    void draw_image(QPainter& painter);
    void draw_axis(QPainter& painter, const session::SceneCamera& camera) const;
    void draw_marks(QPainter& painter, const session::SceneCamera& camera) const;

    const Tokens* tokens_ = nullptr;
    std::shared_ptr<const session::MeshScene> scene_;
    session::SceneView view_;
    std::vector<Mark> marks_;
    QString empty_text_;
    bool axis_at_origin_ = false;
    QImage image_;  ///< null: to be drawn anew
    QPointF grabbed_;
};

}  // namespace psicarve::ui
