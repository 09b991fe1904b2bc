// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::ui {

class FlowLayout;
class MeshView;

/// Front, Side, Top, Iso, Fit: a row of buttons for a view, with room behind them. The view outlives them.
FlowLayout* view_buttons(MeshView& view);

}  // namespace psicarve::ui
