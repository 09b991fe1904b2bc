// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <set>
#include <string>

class QAbstractButton;
class QAction;

namespace psicarve::ui::test {

/// What a test presses: hears every button and every entry of a menu as soon as it is there, and every key.
/// One for the program; a test that begins forgets what was before.
class PressLog : public QObject {
public:
    /// The application's; made when it is first asked for.
    static PressLog& instance();

    void forget();
    /// Before a window that was opened since, which keeps some keys to itself.
    void hear_first();
    /// Names of buttons and entries that were pressed, and keys as QKeySequence writes them ("Ctrl+L").
    const std::set<std::string>& pressed() const noexcept { return pressed_; }
    /// Buttons that were shown and are for the table, pressed or not; one without a name as "nameless: its
    /// text".
    const std::set<std::string>& seen() const noexcept { return seen_; }

    /// Its name, or what it says.
    static std::string name_of(const QObject& button, const QString& text);
    /// Not: what only shows a menu, whose entries count; what is in a test's own dialog, called "test_...".
    static bool is_for_table(const QAbstractButton& button);
    /// Made by Qt for a dialog or a field of its own.
    static bool is_of_qt(const QObject& button);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    PressLog();
    void hear_button(QObject& widget);
    void hear_action(QAction& action);

    std::set<std::string> pressed_;
    std::set<std::string> seen_;
};

}  // namespace psicarve::ui::test
