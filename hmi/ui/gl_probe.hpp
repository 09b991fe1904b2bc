// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace psicarve::ui {

/// Whether this screen can show an OpenGL view, tried out with a context and our own shaders. Requires a
/// QApplication. Platforms without a screen are refused untried: a view that is shown there ends the program.
struct GlProbe {
    bool is_usable = false;
    /// The processor does what a graphics card should. Then every change in the window costs several times
    /// what it costs without OpenGL, as all of the window is put together by it.
    bool is_software = false;
    QString reason;    ///< why it is not usable
    QString renderer;  ///< as the driver calls itself
};
GlProbe probe_gl();

}  // namespace psicarve::ui
