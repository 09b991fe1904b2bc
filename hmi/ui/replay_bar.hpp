// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <functional>
#include <vector>

#include "hmi/ui/icon.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace psicarve::ui {

class TimelineView;

/// Plays a recording: only there while one is shown or read. Its members: widgets, and what they show.
class ReplayBar : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ReplayBar)
public:
    /// `choose_job` asks for a trace's job, `verify` holds the trace against it.
    ReplayBar(WindowContext& context, std::function<void()> choose_job, std::function<void()> verify,
              QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();

    // What the keys do, too:
    void play_or_pause();
    void go_to_next_entry();
    void go_to_entry_before();

private:
    QPushButton* add_button(QHBoxLayout& row, const char* name, const QString& hint,
                            std::function<void()> act);
    QWidget* make_controls();
    QWidget* make_opening();
    void use_job();
    void refresh_verify();
    void refresh_words();
    void refresh_warnings();
    QString state_words() const;

    WindowContext& context_;
    std::function<void()> choose_job_;
    std::function<void()> verify_trace_;
    const Tokens* tokens_ = nullptr;
    bool shown_playing_ = false;
    QWidget* opening_;
    QWidget* controls_;
    QProgressBar* progress_ = nullptr;
    QPushButton* begin_ = nullptr;
    QPushButton* before_ = nullptr;
    QPushButton* play_ = nullptr;
    QPushButton* next_ = nullptr;
    QPushButton* end_ = nullptr;
    QPushButton* job_ = nullptr;
    QPushButton* verify_ = nullptr;
    QPushButton* leave_ = nullptr;
    std::vector<QPushButton*> speeds_;
    QLabel* time_ = nullptr;
    QLabel* of_ = nullptr;
    QLabel* moment_ = nullptr;
    QLabel* place_ = nullptr;
    QLabel* warnings_ = nullptr;  ///< about the recording, to be read as long as it is shown
    std::uint64_t shown_edition_ = 0;
    TimelineView* timeline_ = nullptr;
};

}  // namespace psicarve::ui
