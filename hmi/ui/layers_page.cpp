// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/layers_page.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStackedLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/layer_map.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/polar_view.hpp"
#include "hmi/ui/radius_plot.hpp"
#include "hmi/ui/tick_box.hpp"
#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr int kFactsWidth = 224;

QString mm_text(double value) {
    return QString::fromStdString(session::number_text(value, 2));
}

QString clock(double seconds) {
    return QString::fromStdString(session::clock_text(seconds));
}

QVBoxLayout* column(QWidget* head, QWidget* body) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSmallGap);
    layout->addWidget(head);
    layout->addWidget(body, 1);
    return layout;
}

}  // namespace

LayersPage::LayersPage(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      polar_(new PolarView),
      map_(new LayerMap{context}),
      plot_(new RadiusPlot),
      slider_(new QSlider{Qt::Vertical}),
      point_slider_(new QSlider{Qt::Horizontal}),
      number_(new QSpinBox),
      section_(role_label("head")),
      along_(role_label("head")),
      heads_(role_label("label")) {
    setObjectName("layers_page");
    auto* foot = new QHBoxLayout;
    foot->setSpacing(kGap);
    foot->addLayout(make_along(), 1);
    foot->addWidget(make_facts());
    auto* whole = new QWidget;
    auto* all = new QVBoxLayout{whole};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kGap);
    all->addLayout(make_views(), 1);
    all->addLayout(foot);
    auto* nothing = role_label("label", tr("No job: slice a model or open a job"));
    nothing->setObjectName("layers_none");
    nothing->setAlignment(Qt::AlignCenter);
    nothing->setWordWrap(true);
    stack_ = new QStackedLayout{this};
    stack_->addWidget(nothing);
    stack_->addWidget(whole);
    setEnabled(false);
}

QLayout* LayersPage::make_views() {
    slider_->setObjectName("layer_slider");
    slider_->setAccessibleName(tr("Layer"));
    slider_->setRange(1, 1);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        context_.layer_cursor.choose_layer(static_cast<std::uint32_t>(value - 1));
        show_place();
    });
    auto* views = new QHBoxLayout;
    views->setSpacing(kGap);
    views->addLayout(column(section_, polar_), 1);
    views->addWidget(map_, 1);
    views->addWidget(slider_);
    return views;
}

QLayout* LayersPage::make_along() {
    heads_->setTextFormat(Qt::RichText);
    auto* head = new QHBoxLayout;
    along_->setWordWrap(true);
    head->addWidget(along_, 1);
    head->addWidget(heads_);
    point_slider_->setObjectName("point_slider");
    point_slider_->setAccessibleName(tr("Point"));
    point_slider_->setRange(0, 0);
    connect(point_slider_, &QSlider::valueChanged, this, [this](int value) {
        context_.layer_cursor.choose_point(static_cast<std::uint32_t>(value));
        show_place();
    });
    auto* under = new QHBoxLayout;  // the slider's ends below the curves' ends
    under->setContentsMargins(RadiusPlot::kLeftRoom_px - kGap, 0, RadiusPlot::kRightRoom_px - kGap, 0);
    under->addWidget(point_slider_);
    auto* along = new QVBoxLayout;
    along->setSpacing(kSmallGap);
    along->addLayout(head);
    along->addWidget(plot_, 1);
    along->addLayout(under);
    return along;
}

QWidget* LayersPage::make_facts() {
    number_->setRange(1, 1);
    number_->setObjectName("layer_number");
    number_->setAccessibleName(tr("Layer"));
    number_->setKeyboardTracking(false);
    connect(number_, &QSpinBox::valueChanged, slider_, &QSlider::setValue);
    follow_ = new TickBox{tr("Follow the machine")};
    follow_->setObjectName("follow_machine");
    follow_->setChecked(context_.layer_cursor.follows());
    connect(follow_, &QCheckBox::toggled, this,
            [this](bool follows) { context_.layer_cursor.follow(follows); });
    auto* whole = new QWidget;
    whole->setFixedWidth(kFactsWidth);
    auto* grid = new QGridLayout{whole};
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    grid->addWidget(role_label("head", tr("Layer")), 0, 0);
    grid->addWidget(number_, 0, 1);
    point_text_ = add_fact(*grid, tr("Point, Ψ"), "point_text");
    r1_text_ = add_fact(*grid, QStringLiteral("R1"), "point_r1", "r1");
    r2_text_ = add_fact(*grid, QStringLiteral("R2"), "point_r2", "r2");
    range_text_ = add_fact(*grid, tr("Radii"), "layer_radii");
    time_text_ = add_fact(*grid, tr("Layer time"), "layer_time");
    until_text_ = add_fact(*grid, tr("With those before"), "layer_until");
    grid->addWidget(follow_, grid->rowCount(), 0, 1, 2);
    return whole;
}

QLabel* LayersPage::add_fact(QGridLayout& grid, const QString& name, const char* id, const char* role) {
    auto* const value = new QLabel;
    value->setObjectName(id);
    value->setAlignment(Qt::AlignRight);
    const int row = grid.rowCount();
    grid.addWidget(role_label(role, name), row, 0);
    grid.addWidget(value, row, 1);
    return value;
}

void LayersPage::set_theme(const Tokens& tokens) {
    polar_->set_theme(tokens);
    map_->set_theme(tokens);
    plot_->set_theme(tokens);
    heads_->setText(
        QStringLiteral("<span style='color:%1'>━ R1</span>&nbsp; <span style='color:%2'>╍ R2</span>")
            .arg(tokens.r1.name(), tokens.r2.name()));
}

void LayersPage::refresh() {
    // What is not looked at must cost nothing.
    if (!isVisible()) return;
    if (context_.shown_job() != job_) take_job();
    if (!job_) return;
    follow_machine();
    if (const auto planned = planned_seconds()) whole_s_ = planned;
    const bool is_new =
        is_planned_ != context_.estimate.planned(job_).has_value() || shown_whole_s_ != whole_s_;
    if (shown_ && is_new) show_times(shown_->layer);
    map_->refresh();
}

void LayersPage::choose_number() {
    refresh();  // a job that came while another page was shown is not shown here yet
    number_->setFocus(Qt::ShortcutFocusReason);
    number_->selectAll();
}

void LayersPage::take_job() {
    job_ = context_.shown_job();
    whole_s_.reset();
    setEnabled(job_ != nullptr);
    // The job before says nothing of what is open now.
    stack_->setCurrentIndex(job_ ? 1 : 0);
    if (!job_) return;
    map_->take_job(job_);
    const double r1_per_mm = job_->profile.r1.pulses_per_mm;
    most_mm_ = map_->most_mm();
    // Roughing stands further out.
    if (job_->view.finishing_layer() > 0)
        most_mm_ = std::max(most_mm_, mm_from_pulses(job_->view.max_radius_pulses(Axis::r1), r1_per_mm));
    context_.layer_cursor.begin(job_->view.layer_count(), job_->view.point_count());
    const auto layers = static_cast<int>(job_->view.layer_count());
    const QSignalBlocker quiet{number_};
    const QSignalBlocker quiet_slider{slider_};
    const QSignalBlocker quiet_points{point_slider_};
    number_->setMaximum(layers);
    number_->setSuffix(tr(" of %1").arg(layers));
    slider_->setMaximum(layers);
    point_slider_->setMaximum(static_cast<int>(job_->view.point_count()) - 1);
    shown_.reset();
    show_place();
}

/// What the cursor says, as far as it is not shown yet.
void LayersPage::show_place() {
    if (!job_) return;
    const session::TablePlace place = context_.layer_cursor.place();
    const bool is_other_layer = !shown_ || shown_->layer != place.layer;
    if (is_other_layer) show_layer(place.layer);
    if (is_other_layer || shown_->point != place.point) show_point(place.point);
    shown_ = place;
    const QSignalBlocker quiet{follow_};
    follow_->setChecked(context_.layer_cursor.follows());
}

void LayersPage::show_layer(std::uint32_t layer) {
    const QSignalBlocker quiet{number_};
    const QSignalBlocker quiet_slider{slider_};
    const auto number = static_cast<int>(layer) + 1;
    number_->setValue(number);
    slider_->setValue(number);
    rim_ = session::layer_rim(*job_, layer);
    section_->setText(tr("Section at Y %1 mm, radius in mm").arg(mm_text(rim_.y_mm)));
    along_->setText(tr("Radius along layer %1, mm over Ψ").arg(number));
    double least_mm = most_mm_;
    double most_mm = 0.0;
    for (const auto* half : {&rim_.r1, &rim_.r2}) {
        for (const session::RimPoint& point : *half) {
            least_mm = std::min(least_mm, point.radius_mm);
            most_mm = std::max(most_mm, point.radius_mm);
        }
    }
    range_text_->setText(tr("%1 to %2 mm").arg(mm_text(least_mm), mm_text(most_mm)));
    show_times(layer);
    polar_->show_rim(rim_, most_mm_);
    plot_->show_layer(session::layer_curves(*job_, layer));
    map_->view().mark_layer(session::place_in_map(job_->view, layer), session::half_spans(*job_, layer));
}

/// Of the whole job, where it is the core's: it has no layer's.
std::optional<double> LayersPage::planned_seconds() const {
    const bool is_cores =
        !context_.replay.is_open() && context_.open_job.view().state == session::OpenJobState::published;
    return is_cores ? session::planned_seconds(context_.machine.view()) : std::nullopt;
}

/// As planned; until that is known for each layer, the core's whole in the shares of the least times, and
/// else what the speeds allow at least.
void LayersPage::show_times(std::uint32_t layer) {
    const auto planned = context_.estimate.planned(job_);
    is_planned_ = planned.has_value();
    shown_whole_s_ = whole_s_;
    std::vector<double> seconds = planned ? planned->layer_seconds : job_->least.layer_seconds;
    const double least_s = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    const bool is_shared = !planned && whole_s_ && least_s > 0.0;
    if (is_shared)
        for (double& layers : seconds) layers *= *whole_s_ / least_s;
    const QString name = tr("Layer %1").arg(layer + 1);
    if (layer >= seconds.size()) {
        time_text_->clear();
        until_text_->clear();
        return slider_->setToolTip(name);
    }
    const QString one = clock(seconds[layer]);
    const QString until = clock(std::accumulate(seconds.begin(), seconds.begin() + layer + 1, 0.0));
    const auto told = [&](const QString& time) {
        return planned ? time : (is_shared ? tr("about %1") : tr("at least %1")).arg(time);
    };
    const bool is_least = !planned && !is_shared;
    for (QLabel* time : {time_text_, until_text_})
        time->setToolTip(is_least ? tr("By feed and top speeds alone; acceleration takes longer")
                                  : QString{});
    time_text_->setText(told(one));
    until_text_->setText(told(until));
    const QString hint = planned     ? tr("takes %1, with those before %2")
                         : is_shared ? tr("takes about %1, with those before %2")
                                     : tr("takes at least %1, with those before %2");
    slider_->setToolTip(name + ", " + hint.arg(one, until));
}

void LayersPage::show_point(std::uint32_t point) {
    const QSignalBlocker quiet{point_slider_};
    point_slider_->setValue(static_cast<int>(point));
    const session::RimPoint& r1 = rim_.r1[point];
    const session::RimPoint& r2 = rim_.r2[point];
    point_text_->setText(
        tr("%1 of %2, %3°").arg(point + 1).arg(job_->view.point_count()).arg(mm_text(r1.direction_deg)));
    r1_text_->setText(tr("%1 mm").arg(mm_text(r1.radius_mm)));
    r2_text_->setText(tr("%1 mm").arg(mm_text(r2.radius_mm)));
    point_slider_->setToolTip(tr("Point %1").arg(point + 1));
    polar_->mark(point);
    plot_->mark(point);
    map_->view().mark_point(r1.direction_deg, r2.direction_deg);
}

void LayersPage::follow_machine() {
    const session::MachineView& machine_view = context_.shown();
    const bool is_at_job = context_.is_shown_at_job();
    lock_with(*follow_, is_at_job ? QString{} : tr("Follow the machine: it does not carve this job"),
              tr("Layer and point are those of the machine, until others are chosen"));
    std::optional<session::TablePlace> machine;
    if (is_at_job) machine = {machine_view.status->layer, machine_view.status->point};
    context_.layer_cursor.note_machine(machine);
    if (!slider_->isSliderDown() && !point_slider_->isSliderDown()) show_place();
    if (!is_at_job) return polar_->show_heads({});
    const std::int64_t per_rev = job_->profile.psi.pulses_per_rev;
    const std::int64_t psi_pulses = machine_view.status->position_pulses[index_of(Axis::psi)] % per_rev;
    polar_->show_heads(deg_from_pulses(psi_pulses, per_rev));
}

}  // namespace psicarve::ui
