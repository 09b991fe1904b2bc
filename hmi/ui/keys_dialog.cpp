// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/keys_dialog.hpp"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QStringList>
#include <QVBoxLayout>

#include "hmi/ui/frames.hpp"

namespace psicarve::ui {
namespace {

constexpr QSize kRoomForAll{900, 480};  // px: both columns, in the longest language
constexpr QSize kFrameOfDialog{40, 60};

/// A line is keys, two spaces, and what they do.
QWidget* list_of(const char* name, const QString& lines) {
    auto* whole = new QWidget;
    whole->setObjectName(name);
    auto* grid = new QGridLayout{whole};
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(2 * kGap);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    int row = 0;
    for (const QString& line : lines.split('\n')) {
        const auto gap = line.lastIndexOf(QStringLiteral("  "));
        grid->addWidget(role_label("head", line.left(gap).trimmed()), row, 0);
        grid->addWidget(new QLabel{line.mid(gap + 2)}, row++, 1);
    }
    return whole;
}

/// Where the window has no room for the whole list.
QScrollArea* scrolled_list(QWidget* sheet) {
    auto* area = new QScrollArea;
    area->setObjectName("keys_room");
    area->setWidgetResizable(true);
    area->setWidget(sheet);
    return area;
}

}  // namespace

KeysDialog::KeysDialog(QWidget* parent) : QDialog(parent) {
    setObjectName("keys");
    setWindowTitle(tr("Keys"));
    auto* always = list_of(
        "keys_always",
        tr("F1  emergency stop, everywhere\nShift+Esc  stop, everywhere\nEsc  hold; in a dialog or menu: "
           "close "
           "it\nCtrl+Enter  start\nPause  hold, resume, everywhere\n"
           "Ctrl+Home  home all\nCtrl+0, Ctrl+−, Ctrl++  feed override\nCtrl+O  open\nF5  slice\nF9  arm "
           "keyboard jog\nCtrl+1 … 8  tabs\nCtrl+L  layer number\nF6  next pane\nF10  "
           "menu\nF12  this list"));
    auto* jog = list_of("keys_jog", tr("← →  Ψ\n↑ ↓  Y\nPgUp PgDn  R1 out, in\nCtrl+PgUp PgDn  R2 out, in\n"
                                       "Shift with these  one step"));
    auto* replay = list_of("keys_replay",
                           tr("K  play, pause\nJ, L  slower, faster\nN, Shift+N  next entry, entry before\n"
                              ",  .  one layer\nArrows, PgUp, PgDn, Home, End  on the timeline"));
    auto* left = new QVBoxLayout;
    left->addWidget(always);
    left->addStretch();
    auto* right = new QVBoxLayout;
    right->addWidget(role_label("head", tr("While keys are armed (F9)")));
    right->addWidget(jog);
    right->addSpacing(2 * kGap);
    right->addWidget(role_label("head", tr("While a recording is shown")));
    right->addWidget(replay);
    right->addStretch();
    const QSize room = parent != nullptr ? parent->size() : kRoomForAll;
    const bool has_room = room.width() >= kRoomForAll.width() && room.height() >= kRoomForAll.height();
    auto* sheet = new QWidget;
    auto* both = new QBoxLayout{has_room ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, sheet};
    both->setSpacing(3 * kGap);
    both->addLayout(left);
    both->addLayout(right);
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Ok};
    buttons->button(QDialogButtonBox::Ok)->setObjectName("keys_ok");
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    auto* all = new QVBoxLayout{this};
    all->addWidget(has_room ? sheet : static_cast<QWidget*>(scrolled_list(sheet)));
    all->addWidget(buttons);
    if (!has_room) resize(room - kFrameOfDialog);
}

}  // namespace psicarve::ui
