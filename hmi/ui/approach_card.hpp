// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include "hmi/program/decoding.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;

namespace psicarve::ui {

class ActionButton;

/// What a run from a line does before that line, to be confirmed. Hidden while none is asked for.
class ApproachCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ApproachCard)
public:
    explicit ApproachCard(WindowContext& context, QWidget* parent = nullptr);

    void refresh();

private:
    void start();
    QString told(const program::Decoded& program) const;

    WindowContext& context_;
    QLabel* title_;
    QLabel* told_;
    ActionButton* confirm_;
};

}  // namespace psicarve::ui
