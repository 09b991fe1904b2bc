// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>

namespace psicarve::ui {

/// A check box that draws its own tick: a style sheet can only take one from a file.
class TickBox : public QCheckBox {
public:
    using QCheckBox::QCheckBox;

    /// Where the tick stands.
    QRect box() const;

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace psicarve::ui
