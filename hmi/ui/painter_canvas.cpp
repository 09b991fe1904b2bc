// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>
#include <QPainter>

#include <algorithm>

#include "hmi/ui/space_canvas.hpp"

namespace psicarve::ui {
namespace {

class PainterCanvas : public QWidget, public SpaceCanvas {
public:
    PainterCanvas(const session::SpacePicture& picture, QWidget* parent)
        : QWidget(parent), picture_(picture) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    QWidget& widget() noexcept override { return *this; }
    void set_background(const QColor& colour) override {
        background_ = colour;
        update();
    }
    void picture_changed() override {
        image_ = QImage{};
        update();
    }
    void vertices_changed(const session::MeshScene& /*scene*/,
                          const std::vector<session::VertexRange>& ranges) override {
        if (!ranges.empty()) picture_changed();
    }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override {
        picture_changed();
        QWidget::resizeEvent(event);
    }

private:
    void draw_image();

    const session::SpacePicture& picture_;
    QColor background_;
    QImage image_;  ///< null: to be drawn anew
};

void PainterCanvas::draw_image() {
    const double ratio = devicePixelRatioF();
    const auto drawn =
        session::draw_bodies(picture_, static_cast<std::size_t>(std::max(1.0, width() * ratio)),
                             static_cast<std::size_t>(std::max(1.0, height() * ratio)));
    image_ = QImage{reinterpret_cast<const uchar*>(drawn.argb.data()), static_cast<int>(drawn.width),
                    static_cast<int>(drawn.height), QImage::Format_ARGB32_Premultiplied}
                 .copy();
    image_.setDevicePixelRatio(ratio);
}

void PainterCanvas::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter{this};
    painter.fillRect(rect(), background_);
    if (image_.isNull()) draw_image();
    painter.drawImage(0, 0, image_);
    painter.setRenderHint(QPainter::Antialiasing);
    const session::SceneCamera camera{picture_.size, picture_.view, static_cast<double>(width()),
                                      static_cast<double>(height())};
    for (const session::SceneLine& line : picture_.lines) {
        const auto from = camera.project(line.from);
        const auto to = camera.project(line.to);
        painter.setPen(QColor::fromRgb(line.rgb));
        painter.drawLine(QPointF{from[0], from[1]}, QPointF{to[0], to[1]});
    }
}

}  // namespace

SpaceCanvas* make_painter_canvas(const session::SpacePicture& picture, QWidget* parent) {
    return new PainterCanvas{picture, parent};
}

}  // namespace psicarve::ui
