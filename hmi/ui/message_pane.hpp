// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <cstdint>
#include <optional>
#include <string>

#include "hmi/session/message_log.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;

namespace psicarve::ui {

class ActionButton;

/// The selected message in full: when, what, why and all that is to be done; an alarm's second in the flight
/// recorder is a click away, while the machine is at rest. Always there and as high as it was made: nothing
/// comes up below a pointer. What is longer is scrolled.
class MessagePane : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MessagePane)
public:
    explicit MessagePane(WindowContext& context, QWidget* parent = nullptr);

    /// Null: none is selected.
    void show_message(const session::Message* message, const QString& kind);
    void refresh();
    bool is_saving() const noexcept { return is_saving_; }

private:
    void make_parts();
    void show_recorder();
    void open_recorder(const std::string& path, std::uint64_t tick);
    std::optional<session::Phrase> lock() const;

    WindowContext& context_;
    bool is_saving_ = false;
    std::optional<session::AlarmPlace> place_;
    QLabel* note_;  ///< what became of the flight recorder that was asked for
    QLabel* title_;
    QLabel* when_;
    QLabel* cause_;
    QLabel* steps_;
    ActionButton* recorder_;
};

}  // namespace psicarve::ui
