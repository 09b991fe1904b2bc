// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/dialogs.hpp"

#include <QDialog>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>

namespace psicarve::ui {
namespace {

QPointer<QDialog> the_dialog;

QString chosen(QFileDialog& dialog) {
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    if (run_dialog(dialog) != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    return dialog.selectedFiles().front();
}

}  // namespace

QDialog* open_dialog() {
    return the_dialog;
}

int run_dialog(QDialog& dialog) {
    if (the_dialog != nullptr) {
        the_dialog->raise();
        the_dialog->activateWindow();
        return QDialog::Rejected;
    }
    the_dialog = &dialog;
    QEventLoop loop;
    QObject::connect(&dialog, &QDialog::finished, &loop, [&loop] { loop.quit(); });
    dialog.setModal(false);
    dialog.show();
    loop.exec();
    the_dialog.clear();
    return dialog.result();
}

QString ask_for_file(QWidget* parent, const QString& title, const QString& folder, const QString& filter) {
    QFileDialog dialog{parent, title, folder, filter};
    dialog.setFileMode(QFileDialog::ExistingFile);
    return chosen(dialog);
}

QString ask_where_to_save(QWidget* parent, const QString& title, const QString& path, const QString& filter) {
    const QFileInfo wanted{path};
    QFileDialog dialog{parent, title, path.isEmpty() ? QString{} : wanted.absolutePath(), filter};
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.selectFile(wanted.fileName());
    return chosen(dialog);
}

QString ask_for_folder(QWidget* parent, const QString& title, const QString& folder) {
    QFileDialog dialog{parent, title, folder};
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    return chosen(dialog);
}

}  // namespace psicarve::ui
