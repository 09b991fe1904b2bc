// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include "hmi/session/display_text.hpp"

namespace psicarve::ui {

enum class Theme : std::uint8_t { light, dark };

/// The colours of a theme. A hue always means something, and the same everywhere: green may move, yellow look
/// at it, red alarm, violet not the real thing, blue and orange the two heads.
struct Tokens {
    QColor win, panel, field, view, raised, sel, line, edge, text, text2, dis;
    QColor run, run_fill, warn, warn_fill, warn_ground, alarm, alarm_fill, alarm_ground;
    QColor sim, sim_fill, r1, r2, idle_fill, on_fill, on_warn;
};
const Tokens& tokens_of(Theme theme);

/// Of scales and legends within pictures.
inline constexpr int kSmallText_px = 11;

/// What a tone paints a filled area with, and what is legible on it.
QColor fill_of(const Tokens& tokens, session::Tone tone);
QColor ink_of(const Tokens& tokens, session::Tone tone);

/// The whole window's style sheet.
/// Of a wide window: larger digits and buttons.
QString style_sheet(const Tokens& tokens, bool is_wide = false);

}  // namespace psicarve::ui
