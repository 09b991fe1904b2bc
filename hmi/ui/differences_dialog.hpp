// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <memory>

#include "hmi/session/snapshot_compare.hpp"

namespace psicarve::ui {

/// What differs between two snapshots or jobs, side by side.
class DifferencesDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::DifferencesDialog)
public:
    explicit DifferencesDialog(const std::shared_ptr<const session::Comparison>& comparison,
                               QWidget* parent = nullptr);
};

}  // namespace psicarve::ui
