// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <vector>

#include "hmi/session/preflight.hpp"
#include "hmi/ui/tokens.hpp"

class QGridLayout;
class QLabel;

namespace psicarve::ui {

/// The checks that passed with something to be looked at: "Feed override: 80 %, …"; empty: none.
QString to_look_at_in(const std::vector<session::Check>& checks);

/// What must be so before a job starts, line by line, and above it how much of that is so. Of a recording:
/// what is in it.
class PreflightList : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PreflightList)
public:
    explicit PreflightList(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens) { tokens_ = &tokens; }
    /// Where room is short the lines stand close.
    void set_low(bool is_low);
    /// Requires a theme, and no more than kMostChecks.
    void show_checks(const std::vector<session::Check>& checks);
    void show_contents(const std::vector<session::Check>& contents);
    /// to_look_at_in() what is shown.
    const QString& to_look_at() const noexcept { return to_look_at_; }

private:
    struct Row {
        QLabel* icon;
        QLabel* name;
        QLabel* detail;
    };
    void show_rows(const std::vector<session::Check>& checks);
    void show_icon(const Row& row, session::Check::Verdict verdict) const;
    void show_detail(const Row& row, const QString& text) const;
    void show_sum(const std::vector<session::Check>& checks);

    const Tokens* tokens_ = nullptr;
    QLabel* title_;
    QLabel* sum_;
    QGridLayout* grid_;
    std::vector<Row> rows_;
    QString to_look_at_;
};

}  // namespace psicarve::ui
