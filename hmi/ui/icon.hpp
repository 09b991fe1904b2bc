// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include <cstdint>

#include "hmi/session/display_text.hpp"

class QPainter;

namespace psicarve::ui {

enum class Glyph : std::uint8_t {
    check,
    cross,
    info,
    triangle,
    octagon,
    play,
    pause,
    stop,
    circle_check,
    unplugged,
    menu,
    left,
    right,
    up,
    down,
    turn_left,
    turn_right,
    lock,
    replay,
    to_begin,
    to_end,
    entry_before,
    next_entry,
};

/// Draws the glyph into a square of `side` at the painter's origin.
void draw_glyph(QPainter& painter, Glyph glyph, double side, const QColor& colour);
QPixmap glyph_pixmap(Glyph glyph, int side, const QColor& colour);
/// In one colour, and in another where it is disabled.
QIcon glyph_icon(Glyph glyph, const QColor& colour, const QColor& disabled);
/// The shape that goes with a state, besides its word and colour.
Glyph glyph_of(MachineState state, bool has_core) noexcept;

}  // namespace psicarve::ui
