// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <cstdint>

#include "hmi/session/refused_order.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QAbstractButton;
class QLabel;

namespace psicarve::ui {

class ActionButton;

/// What one of the buttons beside it asked the core for and did not get, in full, with what would help as a
/// button. Hidden while there is none, or it holds no longer, or once somebody has read it.
class OrderCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::OrderCard)
public:
    enum class Shape : std::uint8_t {
        high,  ///< what helps stands below the text
        wide,  ///< beside it
    };
    /// Its parts are refused_NAME, refused_NAME_why, refused_NAME_remedy and refused_NAME_read.
    OrderCard(Bench& bench, session::OrderPlace place, const QString& name, Shape shape = Shape::high,
              QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// True when it is there.
    bool refresh();
    /// The same, in front of what stands beside the panel: nothing in that one gives way below a hand. A
    /// panel in a frame of its own has it over its lower end. As high in the window as `button`.
    void refresh_beside(QWidget& panel, const QWidget& button);

private:
    void lay_out(Shape shape);
    void help();
    bool is_wanted() const;
    void show_refusal(const session::OrderRefusal& refusal);

    Bench& bench_;
    session::OrderPlace place_;
    QLabel* icon_;
    QLabel* why_;
    ActionButton* remedy_;
    QAbstractButton* read_;
};

}  // namespace psicarve::ui
