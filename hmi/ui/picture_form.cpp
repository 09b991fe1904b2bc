// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/picture_form.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include <numbers>
#include <utility>

#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/tick_box.hpp"

namespace psicarve::ui {
namespace {

constexpr double kLeast_mm = 0.1;
constexpr double kPictureFormMost_mm = 1'000.0;
constexpr double kMostDepth_mm = 500.0;
constexpr double kLeastGamma = 0.05;
constexpr double kMostGamma = 20.0;
constexpr double kMostSmooth_mm = 50.0;

}  // namespace

PictureForm::PictureForm(std::function<void()> changed, QWidget* parent)
    : QWidget(parent), changed_(std::move(changed)), form_(new QFormLayout{this}) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setVerticalSpacing(kSmallGap);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    diameter_ = field("relief_diameter", kLeast_mm, kPictureFormMost_mm, tr("Diameter of the cylinder, mm"));
    make_around();
    black_ = field("relief_black", 0.0, kMostDepth_mm, tr("How deep black lies, mm"));
    white_ = field("relief_white", 0.0, kMostDepth_mm, tr("How deep white lies, mm"));
    gamma_ = field("relief_gamma", kLeastGamma, kMostGamma, tr("Brightness to this power"));
    smooth_ = field("relief_smooth", 0.0, kMostSmooth_mm, tr("Smoothed over so far, mm"));
    invert_ = new TickBox{tr("Invert")};
    invert_->setObjectName("relief_invert");
    invert_->setToolTip(tr("Black and white change places"));
    full_turn_ = new TickBox{tr("All round")};
    full_turn_->setObjectName("relief_full_turn");
    full_turn_->setToolTip(
        tr("Even with a height of its own; else the picture keeps its shape and the rest stays white"));
    seam_ = new ChoiceBox;
    seam_->setObjectName("relief_seam");
    seam_->addItem(tr("as it is"), false);
    seam_->addItem(tr("blended"), true);
    seam_->setToolTip(tr("Where the picture's left and right edges meet"));
    form_->addRow(tr("⌀, round"), pair(diameter_, around_));
    form_->addRow(tr("Black, white"), pair(black_, white_));
    form_->addRow(tr("Gamma, smooth"), pair(gamma_, smooth_));
    form_->addRow(tr("Seam"), seam_);
    form_->addRow(pair(invert_, full_turn_));
    const auto tell = [this] {
        if (is_told_) changed_();
    };
    for (TickBox* box : {invert_, full_turn_}) {
        box->setFocusPolicy(Qt::TabFocus);
        connect(box, &QCheckBox::toggled, this, tell);
    }
    connect(seam_, &QComboBox::currentIndexChanged, this, tell);
    begin_anew();
}

QDoubleSpinBox* PictureForm::field(const char* name, double least, double most, const QString& name_of_it) {
    auto* made = new QDoubleSpinBox;
    ignore_wheel(made);
    made->setObjectName(name);
    made->setRange(least, most);
    made->setKeyboardTracking(false);
    made->setToolTip(name_of_it);
    made->setAccessibleName(name_of_it);
    connect(made, &QDoubleSpinBox::valueChanged, this, [this] {
        if (is_told_) changed_();
    });
    return made;
}

/// A cylinder may be measured with a tape as well: each of the two sets the other.
void PictureForm::make_around() {
    around_ = new QDoubleSpinBox;
    ignore_wheel(around_);
    around_->setObjectName("relief_around");
    around_->setRange(kLeast_mm * std::numbers::pi, kPictureFormMost_mm * std::numbers::pi);
    around_->setKeyboardTracking(false);
    around_->setToolTip(tr("Circumference of the cylinder, mm"));
    around_->setAccessibleName(around_->toolTip());
    connect(around_, &QDoubleSpinBox::valueChanged, this,
            [this](double round_mm) { diameter_->setValue(round_mm / std::numbers::pi); });
    connect(diameter_, &QDoubleSpinBox::valueChanged, around_, [this](double diameter_mm) {
        const QSignalBlocker quiet{around_};
        around_->setValue(diameter_mm * std::numbers::pi);
    });
}

QWidget* PictureForm::pair(QWidget* first, QWidget* second) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout{both};
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSmallGap);
    row->addWidget(first, 1);
    row->addWidget(second, 1);
    return both;
}

void PictureForm::begin_anew() {
    const flat::FlatOptions usual;
    is_told_ = false;
    diameter_->setValue(flat::kUsualDiameter_mm);
    black_->setValue(usual.depth_mm);
    white_->setValue(usual.white_depth_mm);
    gamma_->setValue(usual.gamma);
    smooth_->setValue(usual.smooth_mm);
    invert_->setChecked(usual.is_inverted);
    full_turn_->setChecked(usual.is_full_turn);
    seam_->setCurrentIndex(0);
    is_told_ = true;
}

void PictureForm::fill(flat::FlatOptions& options) const {
    options.diameter_mm = diameter_->value();
    options.depth_mm = black_->value();
    options.white_depth_mm = white_->value();
    options.gamma = gamma_->value();
    options.smooth_mm = smooth_->value();
    options.is_inverted = invert_->isChecked();
    options.is_full_turn = full_turn_->isChecked();
    options.blends_seam = seam_->currentData().toBool();
}

}  // namespace psicarve::ui
