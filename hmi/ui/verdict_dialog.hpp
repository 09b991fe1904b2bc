// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <memory>

#include "hmi/session/file_saver.hpp"

namespace psicarve::ui {

/// What a trace came to when it was held against its job; the carved piece can be saved as a picture.
class VerdictDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::VerdictDialog)
public:
    VerdictDialog(const std::shared_ptr<const session::Judgement>& judgement, session::FileSaver& files,
                  QWidget* parent = nullptr);
};

}  // namespace psicarve::ui
