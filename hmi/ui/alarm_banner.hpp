// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace psicarve::ui {

class ActionButton;

/// What has stopped the machine, or what cannot be stopped from here, where, why, and what to do. Only there
/// while there is something of that kind. In a narrow window its buttons stand below the text, which scrolls
/// where a low one has no room for all of it.
class AlarmBanner : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::AlarmBanner)
public:
    explicit AlarmBanner(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// As high as its text has to be, or less: no layout is to take less from the page than there is.
    bool hasHeightForWidth() const override { return false; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void back_off();
    void make_text();
    void make_keys();
    void arrange(bool is_narrow);
    int keys_height() const;
    int full_height() const;
    int frame_height() const { return height() - contentsRect().height(); }
    void refresh_buttons();
    void refresh_height();

    WindowContext& context_;
    QLabel* icon_;
    QLabel* title_;
    QLabel* detail_;
    QLabel* steps_;
    ActionButton* back_off_;
    ActionButton* reset_;
    QPushButton* acknowledge_;
    QLabel* reason_;
    QScrollArea* room_;            ///< of the text
    QVBoxLayout* text_ = nullptr;  ///< in `room_`
    QBoxLayout* keys_ = nullptr;
    QBoxLayout* parts_ = nullptr;
    bool is_narrow_ = false;
    int full_height_ = 0;
};

}  // namespace psicarve::ui
