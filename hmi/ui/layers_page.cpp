// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/layers_page.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "hmi/session/display_text.hpp"
#include "hmi/session/radius_map.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/polar_view.hpp"
#include "hmi/ui/unrolled_view.hpp"
#include "shared/units.hpp"

namespace psicarve::ui {
namespace {

constexpr std::size_t kMostColumns = 720;
constexpr std::size_t kMostRows = 600;

QString mm_text(double value) {
    return QString::fromStdString(session::number_text(value, 2));
}

QVBoxLayout* column(QWidget* head, QWidget* body) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSmallGap);
    layout->addWidget(head);
    layout->addWidget(body, 1);
    return layout;
}

}  // namespace

LayersPage::LayersPage(Bench& bench, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      polar_(new PolarView),
      unrolled_(new UnrolledView),
      slider_(new QSlider{Qt::Vertical}),
      number_(new QSpinBox),
      section_(role_label("head")),
      facts_(role_label("label")) {
    slider_->setObjectName("layer_slider");
    slider_->setAccessibleName(tr("Layer"));
    slider_->setRange(1, 1);
    number_->setRange(1, 1);
    number_->setObjectName("layer_number");
    number_->setAccessibleName(tr("Layer"));
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { show_layer(value); });
    connect(number_, &QSpinBox::valueChanged, slider_, &QSlider::setValue);
    auto* views = new QHBoxLayout;
    views->setSpacing(kGap);
    views->addLayout(column(section_, polar_), 1);
    views->addLayout(column(role_label("head", tr("Unrolled Ψ–Y map of radii")), unrolled_), 1);
    views->addWidget(slider_);
    auto* foot = new QHBoxLayout;
    foot->addWidget(role_label("label", tr("Layer")));
    foot->addWidget(number_);
    foot->addWidget(facts_, 1);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->addLayout(views, 1);
    all->addLayout(foot);
    setEnabled(false);
    section_->setText(tr("No job: slice a model or open a job"));
}

void LayersPage::set_theme(const Tokens& tokens) {
    polar_->set_theme(tokens);
    unrolled_->set_theme(tokens);
}

void LayersPage::refresh() {
    // Others pay for what nobody looks at.
    if (!isVisible()) return;
    if (bench_.shown_job() != job_) take_job();
    if (job_) follow_machine();
}

void LayersPage::choose_number() {
    number_->setFocus(Qt::ShortcutFocusReason);
    number_->selectAll();
}

void LayersPage::take_job() {
    job_ = bench_.shown_job();
    setEnabled(job_ != nullptr);
    if (!job_) return;
    const session::RadiusMap map = session::radius_map(*job_, kMostColumns, kMostRows);
    most_mm_ = map.most_mm;
    const auto heights = job_->view.layer_heights_pulses();
    const double per_mm = job_->profile.y.pulses_per_mm;
    unrolled_->show_map(map, mm_from_pulses(heights.front(), per_mm), mm_from_pulses(heights.back(), per_mm));
    const auto layers = static_cast<int>(job_->view.layer_count());
    const QSignalBlocker quiet{number_};
    number_->setMaximum(layers);
    number_->setSuffix(tr(" of %1").arg(layers));
    slider_->setMaximum(layers);
    show_layer(slider_->value());
}

void LayersPage::show_layer(int number) {
    if (!job_) return;
    const QSignalBlocker quiet{number_};
    number_->setValue(number);
    const auto layer = static_cast<std::uint32_t>(number - 1);
    session::LayerRim rim = session::layer_rim(*job_, layer);
    section_->setText(tr("Section at Y %1 mm, radius in mm").arg(mm_text(rim.y_mm)));
    double least_mm = most_mm_;
    double most_mm = 0.0;
    for (const auto* half : {&rim.r1, &rim.r2}) {
        for (const session::RimPoint& point : *half) {
            least_mm = std::min(least_mm, point.radius_mm);
            most_mm = std::max(most_mm, point.radius_mm);
        }
    }
    facts_->setText(tr("radius %1 to %2 mm").arg(mm_text(least_mm), mm_text(most_mm)));
    polar_->show_rim(std::move(rim), most_mm_);
    unrolled_->mark((layer + 0.5) / job_->view.layer_count());
}

void LayersPage::follow_machine() {
    const session::MachineSight& sight = bench_.shown();
    if (!bench_.is_shown_at_job()) return polar_->show_heads({});
    const std::int64_t per_rev = job_->profile.psi.pulses_per_rev;
    const std::int64_t psi_pulses = sight.status->position_pulses[index_of(Axis::psi)] % per_rev;
    polar_->show_heads(deg_from_pulses(psi_pulses, per_rev));
    if (sight.status->layer == followed_layer_ || slider_->isSliderDown()) return;
    followed_layer_ = sight.status->layer;
    slider_->setValue(static_cast<int>(followed_layer_) + 1);
}

}  // namespace psicarve::ui
