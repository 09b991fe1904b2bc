// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <functional>
#include <vector>

#include "hmi/session/remedy.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;
class QPushButton;

namespace psicarve::ui {

/// What the desk was asked to do and did not: why, in full, and what would help as buttons. Stands where it
/// was asked.
class RefusalCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RefusalCard)
public:
    using Act = std::function<void(const session::Remedy&)>;
    explicit RefusalCard(Act act, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// Null: nothing was refused. `lock`: why no remedy can be taken now; empty: any can.
    void show_refusal(const session::OpenJobRefusal* refusal, const QString& lock);

private:
    struct Offer {
        session::Remedy remedy;
        QPushButton* button;
    };
    void add_button(session::Remedy::Kind kind, const char* name);

    Act act_;
    QLabel* icon_;
    QLabel* title_;
    QLabel* why_;
    QWidget* offered_;
    std::vector<Offer> offers_;
};

}  // namespace psicarve::ui
