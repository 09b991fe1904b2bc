// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLVertexArrayObject>
#include <QOpenGLWidget>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "hmi/ui/gl_meshes.hpp"
#include "hmi/ui/gl_program.hpp"
#include "hmi/ui/space_canvas.hpp"

namespace psicarve::ui {
namespace {

/// A frame that takes longer than this is drawn with coarse facets while it has to be quick.
constexpr qint64 kQuick_ns = 20'000'000;

class GlCanvas : public QOpenGLWidget, public SpaceCanvas {
public:
    GlCanvas(const session::SpacePicture& picture, std::function<void()> fail, QWidget* parent)
        : QOpenGLWidget(parent), picture_(picture), fail_(std::move(fail)) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        check_.setSingleShot(true);
        QObject::connect(&check_, &QTimer::timeout, this, [this] { check(); });
    }
    ~GlCanvas() override {
        // The widget below us takes its context down when nothing of us is left to hear of it.
        QObject::disconnect(context_end_);
        makeCurrent();
        forget();
        doneCurrent();
    }
    QWidget& widget() noexcept override { return *this; }
    void set_background(const QColor& colour) override {
        background_ = colour;
        update();
    }
    void picture_changed() override { update(); }
    void vertices_changed(const session::MeshScene& scene,
                          const std::vector<session::VertexRange>& ranges) override {
        meshes_.note_change(scene, ranges);
        if (!ranges.empty()) update();
    }

protected:
    void initializeGL() override;
    void paintGL() override;
    void showEvent(QShowEvent* event) override {
        QOpenGLWidget::showEvent(event);
        check_.start(0);
    }

private:
    void forget();
    void give_up();
    void check();
    void draw_bodies(const session::SceneCamera& camera);
    void draw_lines(const session::SceneCamera& camera);

    const session::SpacePicture& picture_;
    std::function<void()> fail_;
    QColor background_;
    QMetaObject::Connection context_end_;
    std::unique_ptr<GlProgram> program_;
    GlMeshes meshes_;
    QOpenGLVertexArrayObject arrays_;  // a core profile draws nothing without one
    qint64 fine_frame_ns_ = 0;
    bool has_failed_ = false;
    QTimer check_;
};

void GlCanvas::initializeGL() {
    // Again and again when the window goes to another screen or dock.
    context_end_ = QObject::connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        forget();
        doneCurrent();
    });
    program_ = std::make_unique<GlProgram>();
    arrays_.create();
    if (!program_->make()) give_up();
}

void GlCanvas::forget() {
    meshes_.clear();
    program_.reset();
    arrays_.destroy();
}

void GlCanvas::give_up() {
    program_.reset();
    has_failed_ = true;
    check_.start(0);
}

/// Qt says nothing when there is no context after all.
void GlCanvas::check() {
    const bool is_lost = has_failed_ || (isVisible() && !isValid());
    if (is_lost && fail_) std::exchange(fail_, nullptr)();
}

void GlCanvas::paintGL() {
    if (!program_) return;
    QElapsedTimer timer;
    timer.start();
    auto* const gl = context()->functions();
    gl->glClearColor(background_.redF(), background_.greenF(), background_.blueF(), 1.0F);
    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->glEnable(GL_DEPTH_TEST);
    const session::SceneCamera camera{picture_.size, picture_.view, static_cast<double>(width()),
                                      static_cast<double>(height())};
    const double reach = 2.0 * std::hypot(picture_.size[0], picture_.size[1], picture_.size[2]);
    program_->begin(width(), height(), std::max(1.0, reach * camera.px_per_unit()));
    if (arrays_.isCreated()) arrays_.bind();
    meshes_.keep_only(picture_);
    draw_bodies(camera);
    draw_lines(camera);
    if (arrays_.isCreated()) arrays_.release();
    program_->end();
    gl->glDisable(GL_DEPTH_TEST);
    gl->glFinish();
    if (!picture_.is_coarse) fine_frame_ns_ = timer.nsecsElapsed();
    const bool has_lost_it = !isValid() || gl->glGetError() == GL_OUT_OF_MEMORY;
    if (has_lost_it) give_up();
}

void GlCanvas::draw_bodies(const session::SceneCamera& camera) {
    program_->set_light(true);
    const bool is_coarse = picture_.is_coarse && fine_frame_ns_ > kQuick_ns;
    for (const session::SceneBody& body : picture_.bodies) {
        program_->set_matrix(session::scene_matrix(camera, picture_.view.up, body.place));
        meshes_.draw(*program_, body, is_coarse);
    }
}

void GlCanvas::draw_lines(const session::SceneCamera& camera) {
    if (picture_.lines.empty()) return;
    auto* const gl = context()->functions();
    std::vector<GlVertex> vertices;
    for (const session::SceneLine& line : picture_.lines) {
        const auto channel = [&line](unsigned shift) {
            return static_cast<std::uint8_t>(line.rgb >> shift & 0xFFU);
        };
        for (const auto& end : {line.from, line.to}) {
            const auto at = camera.project(end);
            vertices.push_back(
                {{static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])},
                 {channel(16), channel(8), channel(0), 255}});
        }
    }
    program_->set_light(false);
    program_->set_matrix({{}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
    QOpenGLBuffer buffer{QOpenGLBuffer::VertexBuffer};
    buffer.create();
    buffer.bind();
    buffer.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(GlVertex)));
    program_->take_vertices();
    gl->glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(vertices.size()));
    buffer.release();
}

}  // namespace

SpaceCanvas* make_gl_canvas(const session::SpacePicture& picture, std::function<void()> fail,
                            QWidget* parent) {
    return new GlCanvas{picture, std::move(fail), parent};
}

}  // namespace psicarve::ui
