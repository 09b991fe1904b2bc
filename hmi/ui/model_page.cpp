// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/model_page.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <thread>
#include <utility>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/view_buttons.hpp"
#include "hmi/ui/warning_list.hpp"

namespace psicarve::ui {
namespace {

using session::Action;
using session::DeskState;

constexpr int kFormWidth = 216;
constexpr int kMostLayers = 100'000;
constexpr int kMostPoints = 100'000;
constexpr int kUsualCount = 500;
constexpr double kMostHeight_mm = 10'000.0;
constexpr int kSteps = 1000;
constexpr QRgb kReachable = 0xC2C8CE;
constexpr QRgb kUndercut = 0xFFC21A;

QString state_words(DeskState state) {
    switch (state) {
        case DeskState::empty:
            return ModelPage::tr("Nothing is open.");
        case DeskState::opening:
            return ModelPage::tr("Reading the file …");
        case DeskState::model:
            return ModelPage::tr("Not sliced yet.");
        case DeskState::slicing:
            return ModelPage::tr("Slicing …");
        case DeskState::job:
            return ModelPage::tr("The job is ready to be published.");
        case DeskState::publishing:
            return ModelPage::tr("Publishing …");
        case DeskState::published:
            return ModelPage::tr("The core has this job.");
    }
    return {};
}

}  // namespace

ModelPage::ModelPage(Bench& bench, Drawing drawing, QWidget* parent)
    : QWidget(parent), bench_(bench), watch_(kReachable, kUndercut), view_(new MeshView{drawing}) {
    auto* all = new QHBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kGap);
    all->addWidget(make_view(), 1);
    all->addWidget(make_form());
}

QWidget* ModelPage::make_view() {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout{whole};
    column->setContentsMargins(0, 0, 0, 0);
    view_->setObjectName("model_view");
    view_->set_empty_text(tr("No model. Open one from the menu, or drop a file here."));
    column->addLayout(view_buttons(*view_));
    column->addWidget(view_, 1);
    warnings_ = new WarningList;
    column->addWidget(warnings_);
    return whole;
}

QWidget* ModelPage::make_form() {
    auto* whole = new QWidget;
    whole->setFixedWidth(kFormWidth);
    auto* column = new QVBoxLayout{whole};
    column->setContentsMargins(0, 0, 0, 0);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    column->addWidget(role_label("head", tr("Placement and slicing")));
    column->addWidget(rule());
    fill_form(*form);
    column->addLayout(form);
    size_ = role_label("label");
    size_->setWordWrap(true);  // beside the view's buttons it would be wider than a small screen
    column->addWidget(size_);
    column->addStretch();
    state_ = new QLabel;
    state_->setWordWrap(true);
    progress_ = new QProgressBar;
    progress_->setRange(0, kSteps);
    progress_->setTextVisible(false);
    cancel_ = new QPushButton{tr("Cancel")};
    cancel_->setObjectName("cancel");
    cancel_->setFocusPolicy(Qt::TabFocus);
    connect(cancel_, &QPushButton::clicked, this, [this] { bench_.desk.cancel(); });
    slice_ = new ActionButton{Action::slice, tr("Slice"), [this] { slice(); }};
    slice_->setObjectName("slice");
    slice_->set_hint(tr("Makes the job's tables (F5)"));
    slice_->setShortcut(Qt::Key_F5);
    publish_ = new ActionButton{Action::publish, tr("Publish"), [this] { bench_.desk.publish(); }};
    publish_->setObjectName("publish");
    publish_->set_hint(tr("Gives the job to the core, which checks it"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kGap);
    buttons->addWidget(slice_, 1);
    buttons->addWidget(publish_, 1);
    column->addWidget(state_);
    column->addWidget(progress_);
    column->addWidget(cancel_);
    column->addLayout(buttons);
    return whole;
}

void ModelPage::fill_form(QFormLayout& form) {
    up_ = new ChoiceBox;
    up_->addItems({"Z", "Y", "X"});
    axis_ = new ChoiceBox;
    axis_->addItems({tr("box centre"), tr("file's origin"), tr("least lost")});
    height_ = new QDoubleSpinBox;
    height_->setRange(0.0, kMostHeight_mm);
    height_->setSpecialValueText(tr("as in the file"));
    height_->setSuffix(" mm");
    layers_ = new QSpinBox;
    layers_->setRange(1, kMostLayers);
    layers_->setValue(kUsualCount);
    layers_->setObjectName("layers");
    points_ = new QSpinBox;
    points_->setRange(2, kMostPoints);
    points_->setValue(kUsualCount);
    points_->setObjectName("points");
    joining_ = new ChoiceBox;
    joining_->addItems({"continuous", "zigzag", "spiral"});
    form.addRow(tr("Up axis"), up_);
    form.addRow(tr("Axis at"), axis_);
    form.addRow(tr("Height"), height_);
    form.addRow(tr("Layers"), layers_);
    form.addRow(tr("Points / head"), points_);
    form.addRow(tr("Joining"), joining_);
    for (QComboBox* box : {up_, axis_})
        connect(box, &QComboBox::currentIndexChanged, this, [this] { look(); });
    height_->setKeyboardTracking(false);
    connect(height_, &QDoubleSpinBox::valueChanged, this, [this] { look(); });
}

cam::JobOptions ModelPage::job_options() const {
    constexpr slice::Up kUps[] = {slice::Up::z, slice::Up::y, slice::Up::x};
    constexpr cam::AxisAt kAxes[] = {cam::AxisAt::centre, cam::AxisAt::origin, cam::AxisAt::best};
    cam::JobOptions options;
    options.up = kUps[up_->currentIndex()];
    options.axis_at = kAxes[axis_->currentIndex()];
    if (height_->value() > 0.0) options.height_mm = height_->value();
    // The usual numbers give way to a model with fewer pulses of height.
    if (layers_->value() != kUsualCount) options.layer_count = static_cast<std::uint32_t>(layers_->value());
    if (points_->value() != kUsualCount) options.point_count = static_cast<std::uint32_t>(points_->value());
    options.joining = joining_from_name(joining_->currentText().toStdString());
    // One is left for the window, and for a core on the same computer.
    options.thread_count = std::max(1U, std::thread::hardware_concurrency() / 2);
    return options;
}

Profile ModelPage::profile() const {
    const auto& of_core = bench_.machine.sight().profile;
    return of_core ? *of_core : bench_.machine.options().profile.value_or(Profile{});
}

void ModelPage::slice() {
    bench_.desk.slice(job_options(), profile());
}

/// What the form says about the placement is seen at once; what cannot be reached, when it is found out.
void ModelPage::look() {
    const auto scene = bench_.desk.scene();
    view_->set_up(job_options().up);
    view_->set_blank({});
    view_->set_legend({});
    view_->replace_scene(scene);
    shown_sight_.reset();
    if (scene)
        watch_.look(bench_.desk.mesh(), scene, profile(), job_options());
    else
        watch_.forget();
}

void ModelPage::set_theme(const Tokens& tokens) {
    view_->set_theme(tokens);
    warnings_->set_theme(tokens);
    refresh();
}

void ModelPage::refresh() {
    slice_->refresh(bench_);
    publish_->refresh(bench_);
    refresh_state();
    watch_.poll();
    show_sight();
    if (shown_edition_ == bench_.desk.edition()) return;
    shown_edition_ = bench_.desk.edition();
    show_opened();
    show_warnings();
}

void ModelPage::show_opened() {
    const auto scene = bench_.desk.scene();
    if (scene == opened_) return;
    opened_ = scene;
    view_->fit();
    look();
    if (!scene) return size_->clear();
    const auto number = [](double value) { return QString::fromStdString(session::number_text(value, 1)); };
    const auto size = slice::placed(job_options().up, scene->size);
    size_->setText(tr("%1 × %2 × %3, %4 facets")
                       .arg(number(size[0]), number(size[1]), number(size[2]),
                            QString::fromStdString(session::count_text(
                                static_cast<std::int64_t>(bench_.desk.mesh()->triangles.size())))));
}

void ModelPage::show_sight() {
    const auto seen = watch_.seen();
    if (!seen || seen == shown_sight_) return;
    shown_sight_ = seen;
    const session::ModelSight& sight = seen->sight;
    view_->replace_scene(seen->painted);
    const double across_mm = 2.0 * sight.blank_radius * sight.mm_per_unit;
    view_->set_blank(
        MeshView::Blank{sight.axis, sight.blank_radius,
                        tr("blank ⌀ %1").arg(QString::fromStdString(session::number_text(across_mm, 1)))});
    const auto entry = [](QRgb rgb, const QString& text) {
        return QStringLiteral("<span style='color:%1'>■</span> %2").arg(QColor::fromRgb(rgb).name(), text);
    };
    constexpr double kPercent = 100.0;
    view_->set_legend(entry(kReachable, tr("reachable")) + "<br>" +
                      entry(kUndercut, tr("undercut %1 %")
                                           .arg(QString::fromStdString(
                                               session::number_text(kPercent * sight.undercut_share, 1)))));
}

void ModelPage::show_warnings() {
    std::vector<std::string> all;
    if (bench_.desk.mesh()) all = bench_.desk.mesh()->warnings;
    if (bench_.desk.job()) {
        const auto& more = bench_.desk.job()->warnings;
        all.insert(all.end(), more.begin(), more.end());
    }
    warnings_->show_warnings(std::move(all));
}

void ModelPage::refresh_state() {
    const session::JobSight& sight = bench_.desk.sight();
    state_->setText(state_words(sight.state));
    progress_->setVisible(sight.state == DeskState::slicing);
    progress_->setValue(static_cast<int>(kSteps * bench_.desk.progress_ratio()));
    cancel_->setVisible(sight.is_busy());
}

}  // namespace psicarve::ui
