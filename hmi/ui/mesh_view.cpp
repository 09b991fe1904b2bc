// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/mesh_view.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/units.hpp"

namespace psicarve::ui {
namespace {

constexpr double kIsoAzimuth_rad = -0.6;
constexpr double kIsoElevation_rad = 0.32;
constexpr double kTurn_rad_per_px = 0.01;
constexpr double kWheelZoom = 1.0015;
constexpr double kLeastZoom = 0.2;
constexpr double kMostZoom = 40.0;
constexpr QRgb kModelRgb = 0xC2C8CE;
constexpr double kRodLength = 0.18;  // of the scene
constexpr double kRod_px = 5.0;
constexpr double kAxisOverhang = 0.10;  // of the height

}  // namespace

MeshView::MeshView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(200, 160);
    setAccessibleName(tr("The model in space"));
    look_from(Side::iso);
}

void MeshView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    redraw();
}

void MeshView::show_scene(std::shared_ptr<const session::MeshScene> scene) {
    scene_ = std::move(scene);
    fit();
}

void MeshView::replace_scene(std::shared_ptr<const session::MeshScene> scene) {
    scene_ = std::move(scene);
    redraw();
}

void MeshView::set_marks(std::vector<Mark> marks) {
    marks_ = std::move(marks);
    update();
}

void MeshView::set_up(slice::Up up) {
    if (view_.up == up) return;
    view_.up = up;
    redraw();
}

void MeshView::set_axis_at_origin(bool at_origin) {
    axis_at_origin_ = at_origin;
    update();
}

void MeshView::look_from(Side side) {
    constexpr double kQuarter_rad = kPi / 2.0;
    view_.azimuth_rad = side == Side::front ? -kQuarter_rad : side == Side::iso ? kIsoAzimuth_rad : 0.0;
    if (side == Side::top) view_.azimuth_rad = -kQuarter_rad;
    view_.elevation_rad = side == Side::top ? kQuarter_rad : side == Side::iso ? kIsoElevation_rad : 0.0;
    redraw();
}

void MeshView::fit() {
    view_.zoom = 1.0;
    view_.pan_x = 0.0;
    view_.pan_y = 0.0;
    redraw();
}

void MeshView::redraw() {
    image_ = QImage{};
    update();
}

void MeshView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.fillRect(rect(), tokens_->view);
    painter.setPen(tokens_->text2);
    if (!scene_) {
        painter.drawText(rect(), Qt::AlignCenter, empty_text_);
        return;
    }
    const session::SceneCamera camera{*scene_, view_, static_cast<double>(width()),
                                      static_cast<double>(height())};
    draw_image(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    draw_axis(painter, camera);
    draw_marks(painter, camera);
}

void MeshView::draw_image(QPainter& painter) {
    if (image_.isNull()) {
        const double ratio = devicePixelRatioF();
        const auto width_px = static_cast<std::size_t>(std::max(1.0, width() * ratio));
        const auto height_px = static_cast<std::size_t>(std::max(1.0, height() * ratio));
        const auto drawn = session::draw_mesh_scene(*scene_, view_, width_px, height_px, kModelRgb);
        image_ = QImage{reinterpret_cast<const uchar*>(drawn.argb.data()), static_cast<int>(drawn.width),
                        static_cast<int>(drawn.height), QImage::Format_ARGB32_Premultiplied}
                     .copy();
        image_.setDevicePixelRatio(ratio);
    }
    painter.drawImage(0, 0, image_);
}

void MeshView::draw_axis(QPainter& painter, const session::SceneCamera& camera) const {
    const auto size = slice::placed(view_.up, scene_->size);
    const auto middle = slice::placed(view_.up, scene_->middle);
    const double x = axis_at_origin_ ? -middle[0] : 0.0;
    const double y = axis_at_origin_ ? -middle[1] : 0.0;
    const double reach = size[2] * (0.5 + kAxisOverhang);
    const auto low = camera.project({x, y, -reach});
    const auto high = camera.project({x, y, reach});
    painter.setPen(QPen{tokens_->text2, 1.0, Qt::DashDotLine});
    painter.drawLine(QPointF{low[0], low[1]}, QPointF{high[0], high[1]});
    painter.drawText(QPointF{high[0] + 6.0, high[1] + 10.0}, tr("Ψ axis"));
}

/// A tip: the head's rod, from outside towards the axis.
void MeshView::draw_marks(QPainter& painter, const session::SceneCamera& camera) const {
    for (const Mark& mark : marks_) {
        const double radius = std::max(std::hypot(mark.place[0], mark.place[1]), 1e-9);
        const double longer = 1.0 + std::max(scene_->size[0], scene_->size[2]) * kRodLength / radius;
        const auto tip = camera.project(mark.place);
        const auto end = camera.project({mark.place[0] * longer, mark.place[1] * longer, mark.place[2]});
        painter.setPen(QPen{mark.colour, kRod_px, Qt::SolidLine, Qt::RoundCap});
        painter.drawLine(QPointF{tip[0], tip[1]}, QPointF{end[0], end[1]});
        painter.drawText(QPointF{end[0] - 8.0, end[1] - 10.0}, mark.name);
    }
}

void MeshView::resizeEvent(QResizeEvent* event) {
    redraw();
    QWidget::resizeEvent(event);
}

void MeshView::mousePressEvent(QMouseEvent* event) {
    grabbed_ = event->position();
}

void MeshView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - grabbed_;
    grabbed_ = event->position();
    if ((event->buttons() & Qt::LeftButton) != 0) {
        view_.azimuth_rad -= moved.x() * kTurn_rad_per_px;
        view_.elevation_rad =
            std::clamp(view_.elevation_rad + moved.y() * kTurn_rad_per_px, -kPi / 2.0, kPi / 2.0);
    } else {
        view_.pan_x += moved.x() / height();
        view_.pan_y += moved.y() / height();
    }
    redraw();
}

void MeshView::wheelEvent(QWheelEvent* event) {
    view_.zoom =
        std::clamp(view_.zoom * std::pow(kWheelZoom, event->angleDelta().y()), kLeastZoom, kMostZoom);
    redraw();
    event->accept();
}

}  // namespace psicarve::ui
