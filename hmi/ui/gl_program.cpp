// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_program.hpp"

#include <QMatrix4x4>
#include <QVector2D>
#include <QVector3D>

#include "hmi/scene/space_picture.hpp"

namespace psicarve::ui {
namespace {

// Attributes.
constexpr int kPlace = 0;
constexpr int kColour = 1;

// Picture coordinates: x right, y down, z towards the viewer [px].
constexpr const char* kVertexSource = R"(
attribute highp vec3 place;
attribute lowp vec4 colour;
uniform highp mat4 to_picture;
uniform highp vec3 half_size;
varying highp vec3 seen;
varying lowp vec3 paint;
void main() {
    seen = (to_picture * vec4(place, 1.0)).xyz;
    paint = colour.rgb;
    gl_Position = vec4(seen.x / half_size.x - 1.0, 1.0 - seen.y / half_size.y, -seen.z / half_size.z, 1.0);
}
)";

// Each facet is flat: its normal is what two steps on it span. Either side is lit, as files do not always say
// what is outside.
constexpr const char* kFragmentSource = R"(
#ifdef GL_ES
#extension GL_OES_standard_derivatives : enable
#endif
varying highp vec3 seen;
varying lowp vec3 paint;
uniform highp vec3 light;
uniform highp vec2 strength;
void main() {
    highp vec3 normal = cross(dFdx(seen), dFdy(seen));
    highp float size = length(normal);
    if (normal.z < 0.0) normal = -normal;
    highp float lit = size > 0.0 ? max(0.0, dot(normal, light) / size) : 0.0;
    gl_FragColor = vec4(min(paint * (strength.x + strength.y * lit), vec3(1.0)), 1.0);
}
)";

QVector3D vector(const std::array<double, 3>& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

bool GlProgram::make() {
    if (!program_.addShaderFromSourceCode(QOpenGLShader::Vertex, kVertexSource)) return false;
    if (!program_.addShaderFromSourceCode(QOpenGLShader::Fragment, kFragmentSource)) return false;
    program_.bindAttributeLocation("place", kPlace);
    program_.bindAttributeLocation("colour", kColour);
    return program_.link();
}

void GlProgram::begin(double width_px, double height_px, double depth_px) {
    program_.bind();
    program_.setUniformValue("half_size", vector({width_px / 2.0, height_px / 2.0, depth_px}));
    program_.setUniformValue("light", vector(session::kLight));
}

void GlProgram::set_matrix(const session::SceneMatrix& matrix) {
    QMatrix4x4 m;
    for (int axis = 0; axis < 3; ++axis)
        m.setColumn(axis, {vector(matrix.columns[static_cast<std::size_t>(axis)]), 0.0F});
    m.setColumn(3, {vector(matrix.origin), 1.0F});
    program_.setUniformValue("to_picture", m);
}

void GlProgram::take_vertices() {
    program_.enableAttributeArray(kPlace);
    program_.enableAttributeArray(kColour);
    program_.setAttributeBuffer(kPlace, GL_FLOAT, 0, 3, sizeof(GlVertex));
    program_.setAttributeBuffer(kColour, GL_UNSIGNED_BYTE, sizeof(GlVertex::place), 4, sizeof(GlVertex));
}

void GlProgram::set_light(bool is_lit) {
    program_.setUniformValue("strength", is_lit ? QVector2D{static_cast<float>(session::kAmbient),
                                                            static_cast<float>(session::kDiffuse)}
                                                : QVector2D{1.0F, 0.0F});
}

}  // namespace psicarve::ui
