// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/engrave_form.hpp"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include <utility>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/tick_box.hpp"

namespace psicarve::ui {
namespace {

constexpr double kLeastGroove_mm = 0.01;
constexpr double kMostGroove_mm = 100.0;
constexpr double kMostEngraved_mm = 1'000.0;
constexpr double kTurn_deg = 360.0;

}  // namespace

EngraveForm::EngraveForm(std::function<void()> changed, QWidget* parent)
    : QWidget(parent), changed_(std::move(changed)) {
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSmallGap);
    engrave_ = tick("engrave", tr("Engrave its lines"),
                    tr("Grooves of the tool's width in a cylinder, instead of an extruded outline"));
    details_ = new QWidget;
    auto* form = new QFormLayout{details_};
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(kSmallGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    depth_ = field("engrave_depth", kLeastGroove_mm, kMostGroove_mm, tr("How deep the grooves are"));
    depth_->setSuffix(" mm");
    start_ = field("engrave_start", 0.0, kTurn_deg, tr("Where the leftmost of the drawing's lines stands"));
    start_->setSuffix(" °");
    diameter_ = field("engrave_diameter", 0.0, kMostEngraved_mm, tr("Diameter of the cylinder, mm"));
    diameter_->setSuffix(" mm");
    diameter_->setSpecialValueText(tr("as the blank"));
    full_turn_ = tick("engrave_full_turn", tr("All round"), tr("Scales the drawing to go all round"));
    widths_ = tick("engrave_widths", tr("Stroke widths"),
                   tr("Grooves are as wide as the strokes of an SVG drawing, at least as the tool"));
    form->addRow(tr("Depth"), depth_);
    form->addRow(tr("Begins at"), start_);
    form->addRow(QStringLiteral("⌀"), diameter_);
    form->addRow(full_turn_);
    form->addRow(widths_);
    column->addWidget(engrave_);
    column->addWidget(details_);
    begin_anew(false);
}

void EngraveForm::tell() const {
    if (is_told_) changed_();
}

QDoubleSpinBox* EngraveForm::field(const char* name, double least, double most, const QString& name_of_it) {
    auto* made = new QDoubleSpinBox;
    ignore_wheel(made);
    made->setObjectName(name);
    made->setRange(least, most);
    made->setKeyboardTracking(false);
    made->setToolTip(name_of_it);
    made->setAccessibleName(name_of_it);
    connect(made, &QDoubleSpinBox::valueChanged, this, [this] { tell(); });
    return made;
}

TickBox* EngraveForm::tick(const char* name, const QString& text, const QString& hint) {
    auto* made = new TickBox{text};
    made->setObjectName(name);
    made->setToolTip(hint);
    made->setFocusPolicy(Qt::TabFocus);
    connect(made, &QCheckBox::toggled, this, [this] {
        show_what_applies();
        tell();
    });
    return made;
}

void EngraveForm::show_what_applies() {
    details_->setVisible(engrave_->isChecked());
}

bool EngraveForm::is_chosen() const {
    return engrave_->isChecked();
}

void EngraveForm::begin_anew(bool is_engraved) {
    const flat::Engraving usual;
    is_told_ = false;
    engrave_->setChecked(is_engraved);
    depth_->setValue(usual.depth_mm);
    start_->setValue(usual.start_deg);
    diameter_->setValue(0.0);
    full_turn_->setChecked(false);
    widths_->setChecked(usual.follows_strokes);
    show_what_applies();
    is_told_ = true;
}

void EngraveForm::fill(flat::FlatOptions& options, const Profile& machine) const {
    if (!is_chosen()) return;
    options.engraving = {depth_->value(), start_->value(), widths_->isChecked(), machine.tool};
    options.is_full_turn = full_turn_->isChecked();
    if (options.is_full_turn) options.scale = 1.0;
    if (diameter_->value() > 0.0) {
        options.diameter_mm = diameter_->value();
    } else if (machine.blank.radius_mm > 0.0) {
        options.diameter_mm = 2.0 * machine.blank.radius_mm;
    }
}

}  // namespace psicarve::ui
