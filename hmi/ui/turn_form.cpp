// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/turn_form.hpp"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <utility>

#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/tick_box.hpp"

namespace psicarve::ui {
namespace {

constexpr double kMostTurn_deg = 360.0;
constexpr double kTurnStep_deg = 90.0;

TickBox* named_tick(const char* name, const QString& text) {
    auto* made = new TickBox{text};
    made->setObjectName(name);
    made->setFocusPolicy(Qt::TabFocus);
    return made;
}

}  // namespace

TurnForm::TurnForm(std::function<void()> turned, std::function<void()> resized, QWidget* parent)
    : QWidget(parent),
      turned_(std::move(turned)),
      resized_(std::move(resized)),
      turn_(named_tick("turn", tr("Turn, mirror"))),
      fit_(named_tick("fit", tr("Largest"))),
      details_(new QWidget),
      mirror_(new ChoiceBox) {
    auto* form = new QFormLayout{details_};
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(kSmallGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    constexpr const char* kNames[] = {"turn_x", "turn_y", "turn_z"};
    constexpr const char* kPrefixes[] = {"X ", "Y ", "Z "};
    const QString names[] = {tr("Turn about X"), tr("then about Y"), tr("then about Z")};
    auto* three = new QHBoxLayout;
    three->setSpacing(kSmallGap);
    mirror_->setObjectName("mirror");
    mirror_->addItems({tr("not"), "X", "Y", "Z"});
    mirror_->setToolTip(tr("The axis of the file that changes its sign, before the model is turned"));
    form->addRow(tr("Mirror along"), mirror_);
    for (std::size_t i = 0; i < angles_.size(); ++i) {
        angles_[i] = new QDoubleSpinBox;
        ignore_wheel(angles_[i]);
        angles_[i]->setObjectName(kNames[i]);
        angles_[i]->setRange(-kMostTurn_deg, kMostTurn_deg);
        angles_[i]->setSingleStep(kTurnStep_deg);
        angles_[i]->setSuffix(" °");
        angles_[i]->setKeyboardTracking(false);
        angles_[i]->setPrefix(kPrefixes[i]);
        angles_[i]->setDecimals(1);
        angles_[i]->setButtonSymbols(QAbstractSpinBox::NoButtons);  // no room for them
        angles_[i]->setAccessibleName(names[i]);
        angles_[i]->setToolTip(names[i] + ", " + tr("counter-clockwise, seen from the axis' positive end"));
        three->addWidget(angles_[i], 1);
        connect(angles_[i], &QDoubleSpinBox::valueChanged, this, [this] {
            if (is_told_) turned_();
        });
    }
    form->addRow(three);
    connect(mirror_, &QComboBox::currentIndexChanged, this, [this] {
        if (is_told_) turned_();
    });
    connect(turn_, &QCheckBox::toggled, this, [this] {
        show_details();
        if (is_told_) turned_();
    });
    connect(fit_, &QCheckBox::toggled, this, [this] {
        if (is_told_) resized_();
    });
    auto* ticks = new QHBoxLayout;
    ticks->setSpacing(kGap);
    ticks->addWidget(turn_);
    ticks->addWidget(fit_);
    ticks->addStretch();
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSmallGap);
    column->addLayout(ticks);
    column->addWidget(details_);
    show_what_applies(flat::ModelKind::mesh, false, false);
}

void TurnForm::begin_anew() {
    is_told_ = false;
    turn_->setChecked(false);
    fit_->setChecked(false);
    mirror_->setCurrentIndex(0);
    for (QDoubleSpinBox* angle : angles_) angle->setValue(0.0);
    is_told_ = true;
}

void TurnForm::show_what_applies(flat::ModelKind kind, bool is_engraved, bool is_table) {
    const QString reason = is_table ? tr("A table's layers and radii are taken as they stand") : QString{};
    lock_with(*turn_, reason, tr("Turns or mirrors the model before it is placed"));
    lock_with(*fit_, reason, tr("As large as the machine's travel and the blank let it be"));
    may_turn_ = !is_engraved;  // grooves are cut where the drawing says
    may_fit_ = may_turn_ && kind != flat::ModelKind::picture;
    turn_->setVisible(may_turn_);
    fit_->setVisible(may_fit_);
    show_details();
}

void TurnForm::show_details() {
    details_->setVisible(may_turn_ && turn_->isChecked());
}

model::MeshTurn TurnForm::turn() const {
    model::MeshTurn turn;
    if (!may_turn_ || !turn_->isChecked()) return turn;
    for (std::size_t i = 0; i < angles_.size(); ++i) turn.rotate_deg[i] = angles_[i]->value();
    if (mirror_->currentIndex() > 0) turn.mirror = static_cast<std::size_t>(mirror_->currentIndex() - 1);
    return turn;
}

bool TurnForm::fits() const {
    return may_fit_ && fit_->isChecked();
}

}  // namespace psicarve::ui
