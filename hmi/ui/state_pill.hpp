// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QRect>
#include <QWidget>

#include "hmi/ui/icon.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// The machine's state: icon, word and colour, always at the same place and of the same size.
class StatePill : public QWidget {
public:
    explicit StatePill(QWidget* parent = nullptr);

    void show_state(const session::StateText& text, Glyph glyph, const Tokens& tokens);
    /// Less wide, for a small screen.
    void set_room(Room room);
    const QString& word() const noexcept { return word_; }
    /// Though its letters are as small as they may be.
    bool is_cut_off() const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Lines {
        QFont word;
        QFont second;
        QRect upper;
        QRect lower;
    };
    Lines lines() const;
    QFont fitting(const QString& text, int height, bool is_bold) const;
    int text_width() const;

    QString word_;
    QString second_;
    Glyph glyph_ = Glyph::unplugged;
    QColor fill_;
    QColor ink_;
};

}  // namespace psicarve::ui
