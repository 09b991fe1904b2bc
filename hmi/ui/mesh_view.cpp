// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/mesh_view.hpp"

#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "hmi/ui/frames.hpp"
#include "shared/base/units.hpp"

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
constexpr double kTriad_px = 26.0;
constexpr double kTriadFromCorner_px = 46.0;

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

bool is_free(const QRect& wanted, const std::vector<QRect>& taken) {
    return std::none_of(taken.begin(), taken.end(),
                        [&](const QRect& other) { return other.intersects(wanted); });
}

/// Up or down, whichever is nearer, until it lies on none of the others; where there is no room it stays.
void keep_apart(QLabel& label, const std::vector<QRect>& taken) {
    const QRect wanted = label.geometry();
    const int room = label.parentWidget()->height();
    for (int away = 0; away < room; ++away) {
        for (const int dy : {-away, away}) {
            const QRect place = wanted.translated(0, dy);
            if (place.top() < 0 || place.bottom() >= room || !is_free(place, taken)) continue;
            return label.move(place.topLeft());
        }
    }
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
    axis_label_->setObjectName("axis_label");
    blank_label_ = floating_label(this);
    blank_label_->setObjectName("blank_label");
    legend_ = floating_label(this);
    legend_->setObjectName("legend");
    legend_->setTextFormat(Qt::RichText);
    for (QLabel*& label : file_axis_labels_) label = floating_label(this);
    for (QLabel*& label : head_labels_) label = floating_label(this);
    for (QLabel*& label : alarm_labels_) label = floating_label(this);
    for (const auto* labels : {&head_labels_, &alarm_labels_}) {
        for (QLabel* label : *labels) label->setTextFormat(Qt::RichText);  // bold, in the head's colour
    }
    alarm_labels_[0]->setObjectName("alarm_at_r1");
    alarm_labels_[1]->setObjectName("alarm_at_r2");
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
    // A body may be as light, or as dark, as the letters before it.
    const QString ground = QStringLiteral("background: %1; padding: 0 2px").arg(tokens.view.name());
    for (QLabel* label : findChildren<QLabel*>(Qt::FindDirectChildrenOnly)) {
        if (label == empty_) continue;  // nothing is behind it
        label->setStyleSheet(ground);
        label->adjustSize();
    }
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

void MeshView::look_as(const session::SceneView& view) {
    picture_.view.azimuth_rad = view.azimuth_rad;
    picture_.view.elevation_rad = view.elevation_rad;
    fit();
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
        picture_.size = size_to_fit();
        picture_.bodies.push_back({part_, {{}, part_turn_rad_}});
        for (const Head& head : heads_) picture_.bodies.push_back(head.body);
    }
    const session::SceneCamera camera{picture_.size, picture_.view, static_cast<double>(width()),
                                      static_cast<double>(height())};
    if (part_ && tokens_ != nullptr) make_lines(camera);
    place_labels(camera);
    canvas_->picture_changed();
}

/// Of the part and of the blank round it, in the file's axes.
std::array<double, 3> MeshView::size_to_fit() const {
    std::array<double, 3> size = part_->size;
    if (!blank_) return size;
    const auto from = slice::source_coordinate(picture_.view.up);
    const double across = std::hypot(size[from[0]], size[from[1]]);
    const double wanted = 2.0 * (std::hypot(blank_->centre[0], blank_->centre[1]) + blank_->radius);
    for (const std::size_t k : {from[0], from[1]}) size[k] *= std::max(1.0, wanted / std::max(across, 1e-9));
    size[from[2]] = std::max({size[from[2]], -2.0 * blank_->low, 2.0 * blank_->high});
    return size;
}

void MeshView::make_lines(const session::SceneCamera& camera) {
    const auto size = slice::placed(picture_.view.up, part_->size);
    const auto axis = blank_ ? blank_->axis : std::array{0.0, 0.0};
    const double reach = size[2] * (0.5 + kAxisOverhang);
    const auto add = [&](double from, double to) {
        picture_.lines.push_back({{axis[0], axis[1], from}, {axis[0], axis[1], to}, rgb_of(tokens_->text2)});
    };
    for (const Head& head : heads_) {
        if (!head.alarm) continue;
        const auto ring =
            session::ring_outline(camera, head.alarm->place, head.alarm->radius, rgb_of(tokens_->alarm));
        picture_.lines.insert(picture_.lines.end(), ring.begin(), ring.end());
    }
    if (has_file_axes_) {
        for (const session::SceneLine& line : file_axes(camera)) picture_.lines.push_back(line);
    }
    if (!blank_) {
        // Inside it hides nothing.
        add(-reach, -size[2] / 2.0);
        return add(size[2] / 2.0, reach);
    }
    add(-reach, reach);
    const auto outline = session::cylinder_outline(blank_->centre, blank_->radius, blank_->low, blank_->high,
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
    place_head_labels(camera);
    for (QLabel* label : file_axis_labels_) label->setVisible(part_ && has_file_axes_);
    if (!part_) return;
    const auto axes = file_axes(camera);
    constexpr const char* kNames[] = {"X", "Y", "Z"};
    for (std::size_t i = 0; i < axes.size(); ++i)
        place(*file_axis_labels_[i], kNames[i], camera.project(axes[i].to), {2, -14});
    const auto size = slice::placed(picture_.view.up, part_->size);
    const auto axis = blank_ ? blank_->axis : std::array{0.0, 0.0};
    const auto top = camera.project({axis[0], axis[1], size[2] * (0.5 + kAxisOverhang)});
    place(*axis_label_, tr("Ψ axis"), top, {6, 0});
    std::vector<QRect> taken = other_labels();
    keep_apart(*axis_label_, taken);
    taken.push_back(axis_label_->geometry());
    if (blank_) {
        const auto& right = camera.right();
        const auto rim = camera.project({blank_->centre[0] + right[0] * blank_->radius,
                                         blank_->centre[1] + right[1] * blank_->radius, blank_->high});
        place(*blank_label_, blank_->text, rim, {6, -18});
        keep_apart(*blank_label_, taken);
    }
}

/// Where those lie that keep their places.
std::vector<QRect> MeshView::other_labels() const {
    std::vector<QRect> taken;
    const auto take = [&](const QLabel* label) {
        if (!label->isHidden()) taken.push_back(label->geometry());
    };
    take(legend_);
    for (const auto* labels : {&head_labels_, &alarm_labels_})
        for (const QLabel* label : *labels) take(label);
    for (const QLabel* label : file_axis_labels_) take(label);
    return taken;
}

std::array<session::SceneLine, 3> MeshView::file_axes(const session::SceneCamera& camera) const {
    return session::axis_triad(camera, picture_.view.up, width() - kTriadFromCorner_px,
                               height() - kTriadFromCorner_px, kTriad_px,
                               tokens_ != nullptr ? rgb_of(tokens_->text2) : 0U);
}

void MeshView::place_head_labels(const session::SceneCamera& camera) {
    const auto bold = [](const QColor& colour, const QString& text) {
        return QStringLiteral("<b style='color:%1'>%2</b>").arg(colour.name(), text);
    };
    for (std::size_t i = 0; i < head_labels_.size(); ++i) {
        const bool is_there = part_ && i < heads_.size();
        const bool has_alarm = is_there && heads_[i].alarm && tokens_ != nullptr;
        head_labels_[i]->setVisible(is_there);
        alarm_labels_[i]->setVisible(has_alarm && !heads_[i].alarm->text.isEmpty());
        if (!is_there) continue;
        place(*head_labels_[i], bold(heads_[i].colour, heads_[i].name), camera.project(heads_[i].label_place),
              {-8, -20});
        if (!has_alarm) continue;
        auto above = camera.project(heads_[i].alarm->place);
        above[1] -= heads_[i].alarm->radius * camera.px_per_unit();
        place(*alarm_labels_[i], bold(tokens_->alarm, heads_[i].alarm->text), above, {-8, -22});
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
