// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/disk_piece_dialog.hpp"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QStringList>
#include <QTimer>

#include <chrono>

#include "hmi/session/saved_piece.hpp"
#include "hmi/ui/anew_dialog.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/window_context.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

struct DiskPieceWords {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::DiskPieceDialog)
};

}  // namespace

bool asked_to_go_on_from_disk(WindowContext& context, std::uint32_t layer, QWidget* window) {
    if (!session::is_from_disk_alone(context.machine.view(), layer)) return true;
    QStringList said;
    for (const session::Phrase& each : session::disk_question(context.machine.view())) said << words(each);
    QMessageBox box{QMessageBox::Question, DiskPieceWords::tr("Go on with an unfinished piece"),
                    said.join(QStringLiteral("\n\n")), QMessageBox::NoButton, window};
    box.setObjectName("disk_question");
    QPushButton* go =
        box.addButton(DiskPieceWords::tr("Continue from layer %1").arg(layer + 1), QMessageBox::AcceptRole);
    go->setObjectName("disk_go");
    QPushButton* forget =
        box.addButton(DiskPieceWords::tr("Forget this piece…"), QMessageBox::DestructiveRole);
    forget->setObjectName("disk_forget");
    QPushButton* none = box.addButton(DiskPieceWords::tr("Cancel"), QMessageBox::RejectRole);
    none->setObjectName("disk_cancel");
    box.setDefaultButton(none);
    const bool goes_on = asked_of_this_piece(context, box, go);
    if (box.clickedButton() == forget) forget_when_asked(context, window);
    return goes_on;
}

void forget_when_asked(WindowContext& context, QWidget* window) {
    const auto asked = session::forgettable_piece(context.machine.view());
    if (!asked) return;
    const QString title = words(asked->title);
    QMessageBox box{
        QMessageBox::Question, DiskPieceWords::tr("Forget this piece"),
        title + QStringLiteral("\n\n") +
            DiskPieceWords::tr("How far the unfinished piece is carved is forgotten for good, and with it "
                               "the core's copy of its job. Nothing moves."),
        QMessageBox::NoButton, window};
    box.setTextFormat(Qt::PlainText);
    box.setObjectName("forget_question");
    QPushButton* go = box.addButton(DiskPieceWords::tr("Forget"), QMessageBox::AcceptRole);
    go->setObjectName("forget_go");
    QPushButton* none = box.addButton(DiskPieceWords::tr("Cancel"), QMessageBox::RejectRole);
    none->setObjectName("forget_cancel");
    box.setDefaultButton(none);
    const auto is_still_it = [&] {
        const auto now = session::forgettable_piece(context.machine.view());
        return now && now->record == asked->record && words(now->title) == title;
    };
    constexpr std::chrono::milliseconds kLookAgain{30};
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &box, [&] {
        if (!is_still_it()) box.reject();
    });
    look.start(kLookAgain);
    run_dialog(box);
    if (box.clickedButton() == go && is_still_it()) context.machine.forget_piece(asked->record);
}

}  // namespace psicarve::ui
