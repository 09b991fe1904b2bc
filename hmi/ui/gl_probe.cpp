// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_probe.hpp"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "hmi/ui/gl_program.hpp"

namespace psicarve::ui {
namespace {

GlProbe unusable(const QString& reason) {
    return {false, false, reason, {}};
}

}  // namespace

GlProbe probe_gl() {
    const QString platform = QGuiApplication::platformName();
    if (platform != "xcb" && !platform.startsWith("wayland")) return unusable("platform " + platform);
    QOpenGLContext context;
    if (!context.create()) return unusable("no context");
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) return unusable("no surface");
    GlProbe probe;
    const auto* const name = context.functions()->glGetString(GL_RENDERER);
    if (name != nullptr) probe.renderer = QString::fromLatin1(reinterpret_cast<const char*>(name));
    for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"})
        probe.is_software = probe.is_software || probe.renderer.contains(software, Qt::CaseInsensitive);
    {
        GlProgram program;
        probe.is_usable = context.format().majorVersion() >= 2 && program.make();
        if (!probe.is_usable) probe.reason = "its shaders do not suffice: " + program.log();
    }
    context.doneCurrent();
    return probe;
}

}  // namespace psicarve::ui
