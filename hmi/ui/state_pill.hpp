// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "hmi/ui/icon.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// The machine's state: icon, word and colour, always at the same place and of the same size.
class StatePill : public QWidget {
public:
    explicit StatePill(QWidget* parent = nullptr);

    void show_state(const session::StateText& text, Glyph glyph, const Tokens& tokens);
    /// Less wide, for a small screen.
    void set_narrow(bool narrow);
    const QString& word() const noexcept { return word_; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString word_;
    QString second_;
    Glyph glyph_ = Glyph::unplugged;
    QColor fill_;
    QColor ink_;
};

}  // namespace psicarve::ui
