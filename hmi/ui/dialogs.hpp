// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QDialog;
class QWidget;

namespace psicarve::ui {

// Dialogs that do not shut out the window behind them: its emergency stop, Hold and Stop work whatever is
// being asked. Qt's own exec() does shut it out. One at a time: a second one only brings the first to the
// front.

/// Runs it to its end and returns its result; QDialog::Rejected when another one is open.
int run_dialog(QDialog& dialog);
/// The one that is open; null: none.
QDialog* open_dialog();

/// The path chosen, or nothing. Qt's own dialogs, as in the desktop's F1 would not reach us.
QString ask_for_file(QWidget* parent, const QString& title, const QString& folder, const QString& filter);
QString ask_where_to_save(QWidget* parent, const QString& title, const QString& path, const QString& filter);
QString ask_for_folder(QWidget* parent, const QString& title, const QString& folder);

}  // namespace psicarve::ui
