// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <functional>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace psicarve::ui {

class RefusalCard;
struct Tokens;

/// How far the open model is on its way to the core, and the buttons that bring it on: Slice, Publish,
/// Cancel, Reload.
class SlicingPanel : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::SlicingPanel)
public:
    struct Acts {
        std::function<void()> slice;
        std::function<void()> reload;
        std::function<void(const session::Remedy&)> remedy;
    };
    SlicingPanel(WindowContext& context, Acts acts, QWidget* parent = nullptr);

    /// `is_stale`: the job was sliced otherwise than the fields say now.
    void refresh(bool is_stale);
    void set_theme(const Tokens& tokens);
    /// What was refused stands above the rest here, until it is put elsewhere.
    RefusalCard& refusal() noexcept { return *refusal_; }
    void take_refusal_back();

private:
    void add_state(QVBoxLayout& column, const std::function<void()>& reload);
    void add_buttons(QVBoxLayout& column, std::function<void()> slice);
    void show_publish_reason();
    void show_refusal();

    WindowContext& context_;
    RefusalCard* refusal_;
    QLabel* state_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    QPushButton* reload_;
    ActionButton* slice_;
    ActionButton* publish_;
    QLabel* publish_reason_;
};

}  // namespace psicarve::ui
