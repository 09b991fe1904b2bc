// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/mesh_view.hpp"

#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "hmi/ui/frames.hpp"
#include "shared/units.hpp"

namespace psicarve::ui {
namespace {

constexpr double kIsoAzimuth_rad = -0.6;
constexpr double kIsoElevation_rad = 0.32;
constexpr double kTurn_rad_per_px = 0.01;
constexpr double kWheelZoom = 1.0015;
constexpr double kLeastZoom = 0.2;
constexpr double kMostZoom = 40.0;
constexpr double kAxisOverhang = 0.05;  // of the height
constexpr std::chrono::milliseconds kRest{250};

QLabel* floating_label(QWidget* parent) {
    QLabel* label = role_label("label");
    label->setParent(parent);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->hide();
    return label;
}

/// Beside a place of the picture, and never cut off by its edge. What stands there already is not painted
/// again.
void place(QLabel& label, const QString& text, const std::array<double, 3>& at, QPoint beside) {
    if (label.text() != text) {
        label.setText(text);
        label.adjustSize();
    }
    const QPoint wanted = QPoint{static_cast<int>(at[0]), static_cast<int>(at[1])} + beside;
    const QSize room = label.parentWidget()->size() - label.size();
    label.move(std::clamp(wanted.x(), 0, std::max(0, room.width())),
               std::clamp(wanted.y(), 0, std::max(0, room.height())));
}

std::uint32_t rgb_of(const QColor& colour) {
    return colour.rgb() & 0xFFFFFFU;
}

}  // namespace

MeshView::MeshView(Drawing drawing, QWidget* parent) : QWidget(parent), drawing_(drawing) {
    setMinimumSize(200, 160);
    setAccessibleName(tr("The model in space"));
    make_canvas();
    empty_ = floating_label(this);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    axis_label_ = floating_label(this);
    blank_label_ = floating_label(this);
    legend_ = floating_label(this);
    legend_->setTextFormat(Qt::RichText);
    for (QLabel*& label : head_labels_) label = floating_label(this);
    rest_.setSingleShot(true);
    connect(&rest_, &QTimer::timeout, this, [this] { redraw(); });
    look_from(Side::iso);
}

void MeshView::make_canvas() {
    const auto fall_back = [this] {
        canvas_->widget().deleteLater();
        drawing_ = Drawing::painter;
        make_canvas();
        redraw();
    };
    canvas_ = drawing_ == Drawing::opengl ? make_gl_canvas(picture_, fall_back, this)
                                          : make_painter_canvas(picture_, this);
    canvas_->widget().lower();
    canvas_->widget().setGeometry(rect());
    canvas_->widget().setVisible(true);
    if (tokens_ != nullptr) canvas_->set_background(tokens_->view);
}

void MeshView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    canvas_->set_background(tokens.view);
    redraw();
}

void MeshView::show_scene(std::shared_ptr<const session::MeshScene> scene) {
    part_ = std::move(scene);
    fit();
}

void MeshView::replace_scene(std::shared_ptr<const session::MeshScene> scene) {
    part_ = std::move(scene);
    redraw();
}

void MeshView::vertices_changed(const std::vector<session::VertexRange>& ranges) {
    if (part_) canvas_->vertices_changed(*part_, ranges);
}

void MeshView::turn_part(double turn_rad) {
    if (turn_rad == part_turn_rad_) return;
    part_turn_rad_ = turn_rad;
    redraw();
}

void MeshView::set_heads(std::vector<Head> heads) {
    if (heads.empty() && heads_.empty()) return;
    heads_ = std::move(heads);
    redraw();
}

void MeshView::set_blank(std::optional<Blank> blank) {
    blank_ = std::move(blank);
    redraw();
}

void MeshView::set_legend(const QString& text) {
    legend_->setText(text);
    redraw();
}

void MeshView::set_empty_text(const QString& text) {
    empty_->setText(text);
    redraw();
}

void MeshView::set_up(slice::Up up) {
    if (picture_.view.up == up) return;
    picture_.view.up = up;
    redraw();
}

void MeshView::set_moving(bool is_moving) {
    if (is_moving_ == is_moving) return;
    is_moving_ = is_moving;
    redraw();
}

void MeshView::look_from(Side side) {
    constexpr double kQuarter_rad = kPi / 2.0;
    session::SceneView& view = picture_.view;
    view.azimuth_rad = side == Side::front ? -kQuarter_rad : side == Side::iso ? kIsoAzimuth_rad : 0.0;
    if (side == Side::top) view.azimuth_rad = -kQuarter_rad;
    view.elevation_rad = side == Side::top ? kQuarter_rad : side == Side::iso ? kIsoElevation_rad : 0.0;
    redraw();
}

void MeshView::fit() {
    picture_.view.zoom = 1.0;
    picture_.view.pan_x = 0.0;
    picture_.view.pan_y = 0.0;
    redraw();
}

void MeshView::redraw() {
    picture_.is_coarse = is_moving_ || rest_.isActive();
    picture_.bodies.clear();
    picture_.lines.clear();
    if (part_) {
        picture_.size = part_->size;
        picture_.bodies.push_back({part_, {{}, part_turn_rad_}});
        for (const Head& head : heads_) picture_.bodies.push_back(head.body);
    }
    const session::SceneCamera camera{picture_.size, picture_.view, static_cast<double>(width()),
                                      static_cast<double>(height())};
    if (part_ && tokens_ != nullptr) make_lines(camera);
    place_labels(camera);
    canvas_->picture_changed();
}

void MeshView::make_lines(const session::SceneCamera& camera) {
    const auto size = slice::placed(picture_.view.up, picture_.size);
    const auto axis = blank_ ? blank_->axis : std::array{0.0, 0.0};
    const double reach = size[2] * (0.5 + kAxisOverhang);
    const auto add = [&](double from, double to) {
        picture_.lines.push_back({{axis[0], axis[1], from}, {axis[0], axis[1], to}, rgb_of(tokens_->text2)});
    };
    if (!blank_) {
        // Inside it stands in nobody's way.
        add(-reach, -size[2] / 2.0);
        return add(size[2] / 2.0, reach);
    }
    add(-reach, reach);
    const auto outline = session::cylinder_outline(axis, blank_->radius, -size[2] / 2.0, size[2] / 2.0,
                                                   camera.right(), rgb_of(tokens_->text2));
    picture_.lines.insert(picture_.lines.end(), outline.begin(), outline.end());
}

void MeshView::place_labels(const session::SceneCamera& camera) {
    empty_->setVisible(!part_ && !empty_->text().isEmpty());
    empty_->setGeometry(rect().adjusted(kGap, kGap, -kGap, -kGap));
    legend_->setVisible(part_ && !legend_->text().isEmpty());
    legend_->adjustSize();
    legend_->move(kGap, height() - legend_->height() - kGap);
    axis_label_->setVisible(part_ != nullptr);
    blank_label_->setVisible(part_ && blank_);
    for (std::size_t i = 0; i < head_labels_.size(); ++i)
        head_labels_[i]->setVisible(part_ && i < heads_.size());
    if (!part_) return;
    const auto size = slice::placed(picture_.view.up, picture_.size);
    const auto axis = blank_ ? blank_->axis : std::array{0.0, 0.0};
    const auto top = camera.project({axis[0], axis[1], size[2] * (0.5 + kAxisOverhang)});
    place(*axis_label_, tr("Ψ axis"), top, {6, 0});
    if (blank_) {
        const auto& right = camera.right();
        const auto rim = camera.project(
            {axis[0] + right[0] * blank_->radius, axis[1] + right[1] * blank_->radius, size[2] / 2.0});
        place(*blank_label_, blank_->text, rim, {6, -18});
    }
    for (std::size_t i = 0; i < std::min(heads_.size(), head_labels_.size()); ++i) {
        const QString text =
            QStringLiteral("<b style='color:%1'>%2</b>").arg(heads_[i].colour.name(), heads_[i].name);
        place(*head_labels_[i], text, camera.project(heads_[i].label_place), {-8, -20});
    }
}

void MeshView::hurry() {
    rest_.start(kRest);
}

void MeshView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    canvas_->widget().setGeometry(rect());
    redraw();
}

void MeshView::mousePressEvent(QMouseEvent* event) {
    grabbed_ = event->position();
}

void MeshView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - grabbed_;
    grabbed_ = event->position();
    session::SceneView& view = picture_.view;
    if ((event->buttons() & Qt::LeftButton) != 0) {
        view.azimuth_rad -= moved.x() * kTurn_rad_per_px;
        view.elevation_rad =
            std::clamp(view.elevation_rad + moved.y() * kTurn_rad_per_px, -kPi / 2.0, kPi / 2.0);
    } else {
        view.pan_x += moved.x() / height();
        view.pan_y += moved.y() / height();
    }
    hurry();
    redraw();
}

void MeshView::mouseReleaseEvent(QMouseEvent* /*event*/) {
    rest_.stop();
    redraw();
}

void MeshView::wheelEvent(QWheelEvent* event) {
    double& zoom = picture_.view.zoom;
    zoom = std::clamp(zoom * std::pow(kWheelZoom, event->angleDelta().y()), kLeastZoom, kMostZoom);
    hurry();
    redraw();
    event->accept();
}

}  // namespace psicarve::ui
