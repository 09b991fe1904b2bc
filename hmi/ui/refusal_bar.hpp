// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;

namespace psicarve::ui {

/// Which file was not opened, why, and what Start carves instead. Above all pages, until the next file is
/// asked for or somebody has read it.
class RefusalBar : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RefusalBar)
public:
    explicit RefusalBar(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    static QString title_of(const session::RefusedFile& refused);
    /// Without the file's name.
    static QString why_of(const session::RefusedFile& refused);

private:
    QString what_stays() const;

    Bench& bench_;
    QLabel* icon_;
    QLabel* title_;
    QLabel* why_;
    QLabel* stays_;
};

}  // namespace psicarve::ui
