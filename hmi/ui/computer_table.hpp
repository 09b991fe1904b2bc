// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTableWidget>

#include <string>
#include <vector>

#include "hmi/session/computer_rows.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// What keeps the tick punctual: a sign, what it is, what was found, what to do.
class ComputerTable : public QTableWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ComputerTable)
public:
    explicit ComputerTable(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_rows(const std::vector<session::ComputerRow>& rows);

private:
    void fill();
    void fit_rows();

    const Tokens* tokens_ = nullptr;
    std::vector<session::ComputerRow> shown_;
};

}  // namespace psicarve::ui
