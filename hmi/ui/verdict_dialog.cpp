// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/verdict_dialog.hpp"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {

VerdictDialog::VerdictDialog(const std::shared_ptr<const session::Judgement>& judgement,
                             session::FileSaver& files, QWidget* parent)
    : QDialog(parent) {
    constexpr int kMostWidth = 420;
    setObjectName("verdict");
    setWindowTitle(tr("Verification"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* all = new QVBoxLayout{this};
    const QString trace = QFileInfo{QString::fromStdString(judgement->path)}.fileName();
    const QString job = QString::fromStdString(std::string{judgement->job->view.source_name()});
    all->addWidget(role_label("title", tr("%1, held against %2").arg(trace, job)));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * kGap);
    int line = 0;
    for (const session::VerdictRow& row : session::verdict_rows(judgement->report)) {
        grid->addWidget(role_label("label", words(row.name)), line, 0, Qt::AlignTop);
        auto* value = plain_label(words(row.value));
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setWordWrap(true);
        value->setMaximumWidth(kMostWidth);
        value->setMinimumWidth(kMostWidth / 2);
        value->setAlignment(Qt::AlignRight);
        grid->addWidget(value, line++, 1);
    }
    all->addLayout(grid);
    auto* buttons = new QDialogButtonBox;
    QPushButton* picture = buttons->addButton(tr("Save picture…"), QDialogButtonBox::ActionRole);
    picture->setObjectName("save_picture");
    QPushButton* shut = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    shut->setObjectName("verdict_close");
    connect(picture, &QPushButton::clicked, this, [this, judgement, &files] {
        const QString path =
            ask_where_to_save(this, tr("Save the picture"), "carved.png", tr("Pictures (*.png)"));
        if (!path.isEmpty()) files.save_picture(path.toStdString(), judgement);
    });
    connect(shut, &QPushButton::clicked, this, [this] { close(); });
    all->addWidget(buttons);
}

}  // namespace psicarve::ui
