// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

namespace psicarve::ui {

inline constexpr int kGap = 8;
inline constexpr int kSmallGap = 4;

/// A label that shows its text as it stands: names of files and profiles may look like HTML.
QLabel* plain_label(const QString& text = {});
/// The same, which the style sheet knows by its role.
QLabel* role_label(const char* role, const QString& text = {});
/// A tool tip that shows the text as it stands, too.
QString plain_tip(const QString& text);
void set_plain_tip(QWidget& widget, const QString& text);
/// Sets a property that the style sheet looks at; does nothing when it is set already.
void set_styled(QWidget* widget, const char* property, const QVariant& value);
QFrame* rule();
/// A wheel that passes over it changes nothing: for what a machine follows at once.
void ignore_wheel(QWidget* widget);
/// Nor does a key that happens to come to it; what is behind it gets the key.
void ignore_keys(QWidget* widget);

/// A panel with a head line: its title, and something short at the right.
class Dock : public QFrame {
public:
    explicit Dock(const QString& title, QWidget* parent = nullptr);

    QVBoxLayout& body() noexcept { return *body_; }
    QLabel& title() noexcept { return *title_; }
    QLabel& note() noexcept { return *note_; }

private:
    QVBoxLayout* body_;
    QLabel* title_;
    QLabel* note_;
};

}  // namespace psicarve::ui
