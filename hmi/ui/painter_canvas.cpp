// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "hmi/session/background_queue.hpp"
#include "hmi/ui/space_canvas.hpp"

namespace psicarve::ui {
namespace {

/// More facets than these are drawn by another thread where that is possible.
constexpr std::size_t kFacetsAtOnce = 30'000;

struct CanvasRoom {
    std::size_t width_px = 1;
    std::size_t height_px = 1;
    double ratio = 1.0;

    bool operator==(const CanvasRoom&) const = default;
};

/// Other colours at most: then the image before does until the new one is there.
bool is_of_the_same_shape(const session::SpacePicture& a, const session::SpacePicture& b) {
    const session::MeshScene& one = *a.bodies.front().scene;
    const session::MeshScene& other = *b.bodies.front().scene;
    return &one == &other ||
           (one.size == other.size && one.facets == other.facets && one.vertices == other.vertices);
}

/// In any thread.
QImage drawn_image(const session::SpacePicture& picture, const CanvasRoom& room) {
    const auto bodies = session::draw_bodies(picture, room.width_px, room.height_px);
    QImage image = QImage{reinterpret_cast<const uchar*>(bodies.argb.data()), static_cast<int>(bodies.width),
                          static_cast<int>(bodies.height), QImage::Format_ARGB32_Premultiplied}
                       .copy();
    image.setDevicePixelRatio(room.ratio);
    return image;
}

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
        is_stale_ = true;
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
    /// What another thread was asked for last, done or not.
    struct Wish {
        session::SpacePicture picture;
        CanvasRoom room;
    };

    void renew_image();
    void wish_for(const CanvasRoom& room);

    const session::SpacePicture& picture_;
    QColor background_;
    QImage image_;
    bool is_stale_ = true;
    std::optional<Wish> wish_;
    std::uint64_t wishes_ = 0;
    session::BackgroundQueue queue_;  // last: its thread uses the others
};

void PainterCanvas::renew_image() {
    is_stale_ = false;
    const double ratio = devicePixelRatioF();
    const CanvasRoom room{static_cast<std::size_t>(std::max(1.0, width() * ratio)),
                          static_cast<std::size_t>(std::max(1.0, height() * ratio)), ratio};
    if (picture_.is_lasting && session::facet_count(picture_) > kFacetsAtOnce) return wish_for(room);
    ++wishes_;  // what is on its way comes too late
    wish_.reset();
    image_ = drawn_image(picture_, room);
}

/// Until it is there its place is held by the image before where that looks alike, else by a coarse one.
void PainterCanvas::wish_for(const CanvasRoom& room) {
    const bool has_room = wish_ && wish_->room == room;
    if (has_room && session::has_same_bodies(wish_->picture, picture_)) return;
    if (!has_room || !session::has_same_view(wish_->picture, picture_) ||
        !is_of_the_same_shape(wish_->picture, picture_)) {
        session::SpacePicture quick = picture_;
        quick.is_coarse = true;
        image_ = drawn_image(quick, room);
    }
    wish_ = Wish{picture_, room};
    queue_.drop_waiting();
    queue_.post([this, wish = *wish_, number = ++wishes_]() -> session::BackgroundQueue::Finish {
        const auto show = [this, number, image = drawn_image(wish.picture, wish.room)] {
            queue_.deliver();
            if (number != wishes_) return;
            image_ = image;
            update();
        };
        QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
        return {};
    });
}

void PainterCanvas::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter{this};
    painter.fillRect(rect(), background_);
    if (is_stale_) renew_image();
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
