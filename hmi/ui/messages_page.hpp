// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/session/background_queue.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"
#include "shared/base/result.hpp"

class QComboBox;
class QLineEdit;
class QTableWidget;

namespace psicarve::ui {

class MessagePane;

/// What happened since the window was opened, newest first, and the alarms before that.
class MessagesPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MessagesPage)
public:
    explicit MessagesPage(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// All messages of this window, as text.
    void save_log(const QString& path);
    /// Profile, log, snapshot and versions, in a new folder below this one.
    void save_bundle(const QString& folder);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* make_sound();
    void choose_log();
    void choose_bundle();
    session::BackgroundQueue::Finish told(const Result<void>& done, const session::Phrase& success);

    void add(const session::Message& message);
    void filter();
    void show_selected();
    void show_selected_row();
    static QString name_of(const session::Message& message);

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    std::uint64_t shown_count_ = 0;
    QComboBox* kinds_;
    QLineEdit* find_;
    QTableWidget* table_;
    MessagePane* pane_;
    session::BackgroundQueue queue_;  // last: its tasks use the others
};

}  // namespace psicarve::ui
