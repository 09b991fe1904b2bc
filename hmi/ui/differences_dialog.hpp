// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <memory>
#include <vector>

#include "hmi/session/snapshot_compare.hpp"

class QVBoxLayout;

namespace psicarve::ui {

/// What differs between two states of something, side by side.
class DifferencesDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::DifferencesDialog)
public:
    /// Of two snapshots or jobs; it goes when it is closed.
    explicit DifferencesDialog(const std::shared_ptr<const session::Comparison>& comparison,
                               QWidget* parent = nullptr);
    /// Asks whether it is to be so: accepted, or rejected, also by Esc.
    struct Question {
        QString title;
        QString text;
        QString before;  ///< head of the column of what was
        QString after;
        QString accept;  ///< on the button
    };
    DifferencesDialog(const Question& question, const std::vector<session::DifferenceRow>& rows,
                      QWidget* parent = nullptr);

private:
    QVBoxLayout& lay_out(const QString& said, const std::vector<session::DifferenceRow>& rows,
                         const QString& a, const QString& b);
};

}  // namespace psicarve::ui
