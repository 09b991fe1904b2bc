// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace psicarve::ui {

/// One line that shows begin and end of its text where it has no room for all of it, which its tool tip has.
class ElidedLabel : public QLabel {
public:
    using QLabel::QLabel;

    void show_text(const QString& text);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace psicarve::ui
