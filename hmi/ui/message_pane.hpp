// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <functional>
#include <optional>

#include "hmi/session/message_log.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;

namespace psicarve::ui {

class ActionButton;

/// The selected message in full: when, what, why and all that is to be done; an alarm's second in the flight
/// recorder is a click away.
class MessagePane : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MessagePane)
public:
    explicit MessagePane(Bench& bench, QWidget* parent = nullptr);

    /// Null: none is selected.
    void show_message(const session::Message* message, const QString& kind);
    void refresh();

private:
    void show_recorder();

    Bench& bench_;
    std::optional<session::AlarmPlace> place_;
    QLabel* title_;
    QLabel* when_;
    QLabel* cause_;
    QLabel* steps_;
    ActionButton* recorder_;
};

}  // namespace psicarve::ui
