// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "hmi/ui/icon.hpp"
#include "hmi/ui/tokens.hpp"

class QAbstractButton;
class QLabel;
class QLayout;
class QVBoxLayout;

namespace psicarve::ui {

class TextRoom;

/// A yellow bar above the pages: a sign, what is so, in bold, more about it below, and buttons beside that.
/// Where a low window has no room for all words they are scrolled. Hidden until refresh() of whoever is one
/// shows it.
class NoticeBar : public QFrame {
public:
    void set_theme(const Tokens& tokens);
    virtual void refresh() = 0;

protected:
    /// Its title is NAME_title.
    NoticeBar(const char* name, Glyph glyph, QWidget* parent);

    QLabel& title() noexcept { return *title_; }
    /// One more below those that are there: NAME_PART.
    QLabel* add_text(const char* part);
    void add_button(QAbstractButton* button);
    /// Several in one place; it is this one's now.
    void add_buttons(QLayout* group);
    /// Does nothing when it is so already.
    void set_shown(bool is_shown);
    /// In full, whatever it looks like; without any the label goes.
    void show_text(QLabel& label, const QString& text);

private:
    Glyph glyph_;
    QLabel* icon_;
    QLabel* title_;
    TextRoom* text_;
    QVBoxLayout* buttons_;
};

}  // namespace psicarve::ui
