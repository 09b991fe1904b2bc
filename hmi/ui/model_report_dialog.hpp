// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <vector>

#include "hmi/session/mesh_text.hpp"

class QGridLayout;
class QLabel;

namespace psicarve::ui {

/// What a mesh is made of, what is wrong with it and what no tool reaches, as it becomes known. A window of
/// its own that hinders nothing.
class ModelReportDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ModelReportDialog)
public:
    explicit ModelReportDialog(QWidget* parent);

    void show_rows(const QString& title, const std::vector<session::ReportRow>& rows);

private:
    struct Line {
        QLabel* name;
        QLabel* value;
    };
    QLabel* title_;
    QGridLayout* grid_;
    std::vector<Line> lines_;
};

}  // namespace psicarve::ui
