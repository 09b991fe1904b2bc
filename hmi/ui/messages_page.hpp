// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <optional>

#include "hmi/session/background_queue.hpp"
#include "hmi/ui/message_model.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"
#include "shared/base/result.hpp"

class QComboBox;
class QLineEdit;
class QTableView;

namespace psicarve::ui {

class MessagePane;

/// What happened, newest first: since the window was opened, and before that by the journals of the cores.
class MessagesPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MessagesPage)
public:
    explicit MessagesPage(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// It saves nothing.
    bool is_quiet() const;
    /// All messages of this window, as text.
    void save_log(const QString& path);
    /// Profile, log, snapshot and versions, in a new folder below this one.
    void save_bundle(const QString& folder);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* make_sound();
    void choose_log();
    void choose_bundle();
    session::BackgroundQueue::Finish told(const Result<void>& done, const session::Phrase& success);

    void make_head();
    void make_table();
    void filter();
    void choose_again();
    void note_choice();
    void show_chosen();
    void fit_rows();

    WindowContext& context_;
    QComboBox* kinds_;
    QComboBox* spans_;
    QLineEdit* find_;
    MessageModel model_;
    QTableView* table_;
    std::optional<MessageModel::Row> chosen_;  ///< also while the filter hides it
    MessagePane* pane_;
    session::BackgroundQueue queue_;  // last: its tasks use the others
};

}  // namespace psicarve::ui
