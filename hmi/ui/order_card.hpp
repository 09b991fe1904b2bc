// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <cstdint>

#include "hmi/session/refused_order.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QPushButton;

namespace psicarve::ui {

class ActionButton;

/// What one of the buttons beside it asked the core for and did not get, in full, with what would help as a
/// button. Hidden while there is none, or it holds no longer, or once it was read.
class OrderCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::OrderCard)
public:
    enum class Shape : std::uint8_t {
        high,  ///< what helps stands below the text
        wide,  ///< beside it
    };
    /// Its parts are refused_NAME, refused_NAME_why, refused_NAME_remedy and refused_NAME_read.
    OrderCard(WindowContext& context, session::OrderPlace place, const QString& name,
              Shape shape = Shape::high, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// True when it is there.
    bool refresh();
    /// The same, in front of the window's pages, beside the panel and as high as `button`: nothing in the
    /// panel gives way below a hand, and nothing of it is covered. Of a panel that is another tab or in a
    /// frame of its own, half-way down the pages.
    void refresh_beside(const QWidget& panel, const QWidget& button);
    /// The same, at the upper edge of the window's pages, while `user` is to be seen.
    void refresh_above(const QWidget& user);

private:
    void lay_out(Shape shape);
    void help();
    bool is_wanted() const;
    bool comes_before_pages(const QWidget& user);
    void show_at(QPoint at, QSize size);
    void show_refusal(const session::OrderRefusal& refusal);

    WindowContext& context_;
    session::OrderPlace place_;
    QLabel* icon_;
    QLabel* why_;
    ActionButton* remedy_;
    QPushButton* read_;
};

}  // namespace psicarve::ui
