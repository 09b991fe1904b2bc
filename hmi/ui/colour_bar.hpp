// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

namespace psicarve::ui {

/// Coloured squares in a row, as rich text; `colour` of 0 to 1.
template <typename Colour>
QString colour_bar(Colour colour) {
    constexpr int kSteps = 11;
    QString bar;
    for (int step = 0; step < kSteps; ++step) {
        const double ratio = static_cast<double>(step) / (kSteps - 1);
        bar += QStringLiteral("<span style='background:%1'>&nbsp;&nbsp;&nbsp;</span>")
                   .arg(QColor::fromRgb(colour(ratio)).name());
    }
    return bar;
}

/// One of them before a word.
inline QString colour_square(QRgb colour) {
    return QStringLiteral("<span style='color:%1'>■</span> ").arg(QColor::fromRgb(colour).name());
}

// What has no scale of colours: within a pulse of what is wanted, or done; and what nothing has carved.
inline constexpr QRgb kDoneColour = 0xC4CAD0;
inline constexpr QRgb kBlankColour = 0x7C8894;
// Carved, but perhaps wrong.
inline constexpr QRgb kDoubtColour = 0xD1495B;

}  // namespace psicarve::ui
