// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/layer_map.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <array>
#include <cmath>
#include <utility>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/colour_bar.hpp"
#include "hmi/ui/frames.hpp"
#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr std::size_t kMostMapColumns = 720;
constexpr std::size_t kMostMapRows = 600;
constexpr double kFine_ms = 10.0;  // below it two decimals
constexpr double kCoarse_ms = 100.0;
constexpr double kWholePercent = 100.0;
// Beside those of the heads, on both grounds.
constexpr QRgb kPsiColour = 0xFF8E5BB5;
constexpr QRgb kYColour = 0xFF2E9E6B;

/// What the colours tell, in the order of the choice.
enum class MapOf : std::uint8_t { radii, times, bounds };

}  // namespace

LayerMap::LayerMap(WindowContext& context, QWidget* parent)
    : QWidget(parent), context_(context), view_(new UnrolledView), choice_(new ChoiceBox) {
    view_->setObjectName("layer_map");
    choice_->setObjectName("map_of");
    choice_->setFocusPolicy(Qt::TabFocus);
    ignore_wheel(choice_);
    choice_->setAccessibleName(tr("What the map shows"));
    choice_->addItems({tr("radii"), tr("time from point to point"), tr("what bounds the speed")});
    choice_->setItemData(static_cast<int>(MapOf::times),
                         tr("As planned, at 100 % feed: bright where the heads take long"), Qt::ToolTipRole);
    choice_->setItemData(static_cast<int>(MapOf::bounds),
                         tr("The axis that is at its top speed or acceleration, else the feed"),
                         Qt::ToolTipRole);
    connect(choice_, &QComboBox::currentIndexChanged, this, [this] { show_chosen(); });
    auto* head = new QHBoxLayout;
    head->setSpacing(kSmallGap);
    head->addWidget(role_label("head", tr("Unrolled Ψ–Y map:")));
    head->addWidget(choice_);
    head->addStretch();
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kSmallGap);
    all->addLayout(head);
    all->addWidget(view_, 1);
}

void LayerMap::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    view_->set_theme(tokens);
    show_chosen();
}

void LayerMap::take_job(std::shared_ptr<const cam::PreparedJob> job) {
    job_ = std::move(job);
    radii_ = {};
    points_ = nullptr;
    if (!job_) return;
    radii_ = session::radius_map(*job_, kMostMapColumns, kMostMapRows);
    const auto heights = job_->view.layer_heights_pulses().subspan(job_->view.finishing_layer());
    const double per_mm = job_->profile.y.pulses_per_mm;
    view_->set_heights(mm_from_pulses(heights.front(), per_mm), mm_from_pulses(heights.back(), per_mm));
    show_chosen();
}

void LayerMap::refresh() {
    if (choice_->currentIndex() == static_cast<int>(MapOf::radii) || !job_) return;
    if (planned_points() != points_ || (!points_ && view_->key().low != why_unknown())) show_chosen();
}

std::shared_ptr<const PointPlan> LayerMap::planned_points() const {
    const auto planned = context_.estimate.planned(job_);
    return planned ? planned->points : nullptr;
}

void LayerMap::show_chosen() {
    if (!job_ || tokens_ == nullptr) return;
    const auto shown = static_cast<MapOf>(choice_->currentIndex());
    if (shown == MapOf::radii) return show_radii();
    take_points();
    if (!points_) return view_->show_map({}, 0, {why_unknown(), {}, {}});
    if (shown == MapOf::times) return show_times();
    show_bounds();
}

void LayerMap::take_points() {
    auto points = planned_points();
    if (points == points_) return;
    points_ = std::move(points);
    times_ = points_ ? session::time_map(*job_, *points_, kMostMapColumns, kMostMapRows) : session::TimeMap{};
}

QString LayerMap::why_unknown() const {
    if (context_.replay.is_open()) return tr("Not known: the job of a recording is not planned");
    if (context_.estimate.has_failed(job_))
        return tr("Not known: the job could not be planned; page Messages says why");
    return tr("Not known yet: the job is planned while the machine rests");
}

void LayerMap::show_radii() {
    const auto whole_mm = [](double value) {
        return tr("%1 mm").arg(QString::fromStdString(session::number_text(value, 0)));
    };
    view_->show_map(session::radius_picture(radii_, true), radii_.columns,
                    {whole_mm(radii_.least_mm), whole_mm(radii_.most_mm), {}});
}

void LayerMap::show_times() {
    const int decimals = times_.most_ms < kFine_ms ? 2 : times_.most_ms < kCoarse_ms ? 1 : 0;
    const QString most = QString::fromStdString(session::number_text(times_.most_ms, decimals));
    view_->show_map(session::time_picture(times_), times_.columns, {tr("0 ms"), tr("%1 ms").arg(most), {}});
}

/// Named with their share of the whole time; what bounds nothing is left out.
void LayerMap::show_bounds() {
    const std::array<std::uint32_t, kWayBoundCount> colours{
        kBlankColour, tokens_->r1.rgb(), tokens_->r2.rgb(), kPsiColour, kYColour, kDoneColour};
    const std::array<QString, kWayBoundCount> names{tr("other"),          QStringLiteral("R1"),
                                                    QStringLiteral("R2"), QStringLiteral("Ψ"),
                                                    QStringLiteral("Y"),  tr("feed")};
    MapKey key;
    for (std::size_t bound = 0; bound < kWayBoundCount; ++bound) {
        const double percent = kWholePercent * times_.bound_ratio[bound];
        if (percent <= 0.0) continue;
        const QString share = percent < 1.0 ? QStringLiteral("<1") : QString::number(std::lround(percent));
        key.kinds.emplace_back(QColor::fromRgb(colours[bound]),
                               QStringLiteral("%1 %2 %").arg(names[bound], share));
    }
    view_->show_map(session::bound_picture(times_, colours), times_.columns, std::move(key));
}

}  // namespace psicarve::ui
