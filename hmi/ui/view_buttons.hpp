// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QHBoxLayout;

namespace psicarve::ui {

class MeshView;

/// Front, Side, Top, Iso, Fit: a row of buttons for a view, with room behind them. The view outlives them.
QHBoxLayout* view_buttons(MeshView& view);

}  // namespace psicarve::ui
