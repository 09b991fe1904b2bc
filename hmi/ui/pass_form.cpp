// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/pass_form.hpp"

#include <QDoubleSpinBox>
#include <QFormLayout>

#include "hmi/session/pass_sketch.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/pass_view.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

enum class PassChoice { as_profile, roughed, finish_only };

constexpr double kMostPass_mm = 1'000.0;
constexpr double kLeastStepdown_mm = 0.01;
constexpr double kFirstStepdown_mm =
    1.0;  // to begin with, where the profile has none; it is there to be read

PassChoice choice_of(const QComboBox& box) {
    return static_cast<PassChoice>(box.currentData().toInt());
}

}  // namespace

PassForm::PassForm(QFormLayout& form, QWidget& parent)
    : form_(form), choice_(new ChoiceBox), picture_(new QWidget{&parent}) {
    choice_->setObjectName("roughing");
    choice_->addItem(tr("as the profile"), static_cast<int>(PassChoice::as_profile));
    choice_->addItem(tr("before finishing"), static_cast<int>(PassChoice::roughed));
    choice_->addItem(tr("finishing only"), static_cast<int>(PassChoice::finish_only));
    form_.addRow(tr("Roughing"), choice_);
    stepdown_ = field("stepdown", tr("Stepdown"), tr("How much further in each roughing pass goes"));
    stepdown_->setMinimum(kLeastStepdown_mm);
    allowance_ = field("allowance", tr("Allowance"), tr("What roughing leaves for the finishing pass"));
    stepover_ = field("stepover", tr("Stepover"),
                      tr("The most between two of roughing's layers; auto: as the tool allows"));
    stepover_->setSpecialValueText(tr("auto"));
    auto* column = new QVBoxLayout{picture_};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSmallGap);
    view_ = new PassView;
    column->addWidget(view_);
    note_ = role_label("label");
    note_->setObjectName("pass_note");
    note_->setWordWrap(true);
    column->addWidget(note_);
    QObject::connect(choice_, &QComboBox::currentIndexChanged, choice_, [this] { note_choice(); });
    for (QDoubleSpinBox* changed : {stepdown_, allowance_, stepover_})
        QObject::connect(changed, &QDoubleSpinBox::valueChanged, changed, [this] { show_for(machine_); });
    show_for({});
}

QDoubleSpinBox* PassForm::field(const char* name, const QString& label, const QString& hint) {
    auto* made = new QDoubleSpinBox;
    ignore_wheel(made);
    made->setObjectName(name);
    made->setRange(0.0, kMostPass_mm);
    made->setSuffix(" mm");
    made->setToolTip(hint);
    form_.addRow(label, made);
    return made;
}

void PassForm::set_theme(const Tokens& tokens) {
    view_->set_theme(tokens);
}

void PassForm::note_choice() {
    if (choice_of(*choice_) == PassChoice::roughed && !is_begun_) {
        is_begun_ = true;
        const RoughingProfile& usual = machine_.roughing;
        stepdown_->setValue(usual.stepdown_mm > 0.0 ? usual.stepdown_mm : kFirstStepdown_mm);
        allowance_->setValue(usual.allowance_mm);
        stepover_->setValue(usual.stepover_mm);
    }
    show_what_applies();
    show_for(machine_);
}

void PassForm::fill(Profile& profile) const {
    if (choice_of(*choice_) == PassChoice::finish_only) profile.roughing.stepdown_mm = 0.0;
    if (choice_of(*choice_) != PassChoice::roughed) return;
    profile.roughing = {stepdown_->value(), allowance_->value(), stepover_->value()};
}

void PassForm::show_what_applies() {
    const bool is_roughed = choice_of(*choice_) == PassChoice::roughed;
    form_.setRowVisible(stepdown_, is_roughed);
    form_.setRowVisible(allowance_, is_roughed);
    form_.setRowVisible(stepover_, is_roughed && machine_.tool.shape != ToolShape::point);
}

void PassForm::show_for(const Profile& profile) {
    machine_ = profile;
    Profile wished = profile;
    fill(wished);
    if (shown_ == wished) return;
    shown_ = wished;
    show_what_applies();
    const session::PassSketch sketch = session::pass_sketch(wished, PassView::kRatio);
    const session::Phrase problem = session::roughing_problem(wished);
    const bool has_picture = sketch.width_mm > 0.0;
    view_->setVisible(has_picture);
    picture_->setVisible(has_picture || !problem.is_empty());
    view_->show_sketch(sketch);
    set_styled(note_, "role", problem.is_empty() ? "label" : "problem");
    note_->setText(words(problem.is_empty() ? session::passes_phrase(sketch) : problem));
}

}  // namespace psicarve::ui
