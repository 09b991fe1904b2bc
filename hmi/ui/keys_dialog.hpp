// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

namespace psicarve::ui {

/// Every key of the window: what works always, and what works while keys jog or a recording is shown.
class KeysDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::KeysDialog)
public:
    explicit KeysDialog(QWidget* parent);
};

}  // namespace psicarve::ui
