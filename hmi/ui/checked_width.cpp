// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/checked_width.hpp"

#include <QFontMetrics>
#include <QPushButton>

namespace psicarve::ui {

void leave_room_for_bold(QPushButton& button) {
    constexpr int kPadding = 22;
    constexpr int kTextPixels = 13;  // of the style sheet
    QFont bold = button.font();
    bold.setPixelSize(kTextPixels);
    bold.setBold(true);
    button.setMinimumWidth(QFontMetrics{bold}.horizontalAdvance(button.text()) + kPadding);
}

}  // namespace psicarve::ui
