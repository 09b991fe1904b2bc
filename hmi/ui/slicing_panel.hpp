// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <functional>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/bench.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace psicarve::ui {

/// How far the open model is on its way to the core, and the buttons that bring it on: Slice, Publish,
/// Cancel, Reload.
class SlicingPanel : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::SlicingPanel)
public:
    struct Acts {
        std::function<void()> slice;
        std::function<void()> reload;
    };
    SlicingPanel(Bench& bench, Acts acts, QWidget* parent = nullptr);

    /// `is_stale`: the job was sliced otherwise than the fields say now.
    void refresh(bool is_stale);

private:
    void add_state(QVBoxLayout& column, const std::function<void()>& reload);
    void add_buttons(QVBoxLayout& column, std::function<void()> slice);
    void show_publish_reason();

    Bench& bench_;
    QLabel* state_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    QPushButton* reload_;
    ActionButton* slice_;
    ActionButton* publish_;
    QLabel* publish_reason_;
};

}  // namespace psicarve::ui
