// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <memory>

#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QTableView;

namespace psicarve::ui {

/// What a recording tells, entry by entry; the one that happened last is marked, a click goes to another.
class EntriesPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::EntriesPage)
public:
    explicit EntriesPage(WindowContext& context, QWidget* parent = nullptr);
    ~EntriesPage() override;

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    class Model;

    WindowContext& context_;
    std::unique_ptr<Model> model_;
    std::uint64_t shown_edition_ = 0;
    int shown_row_ = -1;
    QTableView* table_;
    QLabel* note_;
};

}  // namespace psicarve::ui
