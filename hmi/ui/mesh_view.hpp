// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/scene/carved_scene.hpp"
#include "hmi/scene/space_picture.hpp"
#include "hmi/ui/space_canvas.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;

namespace psicarve::ui {

/// Something in space: turned with the left button, moved with the right, zoomed with the wheel. Redrawn only
/// when something changed; coarser while it is being turned. A drawing that fails goes on without OpenGL. Its
/// members: what is in space, the canvas and the labels over it.
class MeshView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MeshView)
public:
    enum class Side : std::uint8_t { front, side, top, iso };

    /// A head at its place, with its name.
    struct Head {
        session::SceneBody body;
        QString name;
        QColor colour;
        std::array<double, 3> label_place{};  ///< placed coordinates
        /// Something has happened here; placed coordinates.
        struct Alarm {
            std::array<double, 3> place{};
            double radius = 0.0;
            QString text;  ///< may be empty
        };
        std::optional<Alarm> alarm;
    };
    /// Lengths in the scene's units, places relative to the middle of its box.
    struct Blank {
        std::array<double, 2> axis{};  ///< that the model turns about
        std::array<double, 2> centre{};
        double radius = 0.0;
        double low = 0.0;
        double high = 0.0;
        QString text;
    };

    explicit MeshView(Drawing drawing, QWidget* parent = nullptr);

    Drawing drawing() const noexcept { return drawing_; }
    void set_theme(const Tokens& tokens);
    void show_scene(std::shared_ptr<const session::MeshScene> scene);
    /// The same thing in another state: seen as before.
    void replace_scene(std::shared_ptr<const session::MeshScene> scene);
    /// Of the scene that is shown, these vertices are others now.
    void vertices_changed(const std::vector<session::VertexRange>& ranges);
    void turn_part(double turn_rad);
    void set_heads(std::vector<Head> heads);
    void set_blank(std::optional<Blank> blank);
    /// In the lower left corner; rich text, empty: none.
    void set_legend(const QString& text);
    /// Shown while there is no scene.
    void set_empty_text(const QString& text);
    void set_up(slice::Up up);
    /// The file's axes in the lower right corner.
    void show_file_axes(bool is_shown) noexcept { has_file_axes_ = is_shown; }
    /// Its scenes never change once they are shown: what takes long to draw is drawn by another thread, and
    /// seen with fewer facets until then.
    void set_lasting(bool is_lasting) noexcept { picture_.is_lasting = is_lasting; }
    /// Something goes on changing: speed is worth more than detail.
    void set_moving(bool is_moving);
    void look_from(Side side);
    /// As turned as that, the whole of it.
    void look_as(const session::SceneView& view);
    void fit();
    const session::SpacePicture& picture() const noexcept { return picture_; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void make_canvas();
    void redraw();
    std::array<double, 3> size_to_fit() const;
    void make_lines(const session::SceneCamera& camera);
    void place_labels(const session::SceneCamera& camera);
    void place_head_labels(const session::SceneCamera& camera);
    std::vector<QRect> other_labels() const;
    std::array<session::SceneLine, 3> file_axes(const session::SceneCamera& camera) const;
    void hurry();

    Drawing drawing_;
    const Tokens* tokens_ = nullptr;
    session::SpacePicture picture_;  // the first body is the part, if there is one
    std::shared_ptr<const session::MeshScene> part_;
    double part_turn_rad_ = 0.0;
    std::vector<Head> heads_;
    std::optional<Blank> blank_;
    bool is_moving_ = false;
    bool has_file_axes_ = false;
    SpaceCanvas* canvas_ = nullptr;
    QLabel* empty_;
    QLabel* axis_label_;
    QLabel* blank_label_;
    QLabel* legend_;
    std::array<QLabel*, 3> file_axis_labels_{};
    std::array<QLabel*, 2> head_labels_{};
    std::array<QLabel*, 2> alarm_labels_{};  // of the heads
    QTimer rest_;                            // until the view is drawn finely again
    QPointF grabbed_;
};

}  // namespace psicarve::ui
