// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/carving_page.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/session/colour_map.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/radius_map.hpp"
#include "hmi/ui/axis_table.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/view_buttons.hpp"

namespace psicarve::ui {
namespace {

/// Never more often than this, so that the machine's computer has time for the machine.
constexpr qint64 kLeastPause_ms = 66;
constexpr std::uint64_t kCellsPerLook = 100'000;  // some milliseconds
constexpr QRgb kDone = 0xC4CAD0;
constexpr QRgb kBlank = 0x7C8894;
constexpr double kRodLength = 0.35;  // of the blank's diameter
constexpr double kRodRadius = 0.04;

constexpr int kLeastForTable = 400;  // of the page's height
constexpr int kScaleSteps = 11;

/// Coloured squares in a row, as rich text.
template <typename Colour>
QString colour_bar(Colour colour) {
    QString bar;
    for (int step = 0; step < kScaleSteps; ++step) {
        const double ratio = static_cast<double>(step) / (kScaleSteps - 1);
        bar += QStringLiteral("<span style='background:%1'>&nbsp;&nbsp;&nbsp;</span>")
                   .arg(QColor::fromRgb(colour(ratio)).name());
    }
    return bar;
}

session::CarvedScenePlan plan_for(Drawing drawing) {
    return drawing == Drawing::opengl ? session::CarvedScenePlan{480, 400, 2, kDone, kBlank}
                                      : session::CarvedScenePlan{240, 200, 2, kDone, kBlank};
}

bool is_moving(MachineState state) {
    return !is_at_rest(state);
}

}  // namespace

CarvingPage::CarvingPage(Bench& bench, Drawing drawing, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      view_(new MeshView{drawing}),
      axes_(new AxisTable{bench}),
      colourings_(new QButtonGroup{this}),
      done_(role_label("label")),
      point_(role_label("title")) {
    view_->setObjectName("carving_view");
    view_->setAccessibleName(tr("The blank as carved so far"));
    view_->set_empty_text(tr("No job is published."));
    view_->look_from(MeshView::Side::front);
    point_->setObjectName("carving_point");
    auto* foot = new QHBoxLayout;
    foot->addWidget(done_, 1);
    foot->addWidget(point_);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    auto* above = view_buttons(*view_);
    add_colourings(*above);
    all->addLayout(above);
    all->addWidget(view_, 1);
    all->addLayout(foot);
    all->addWidget(axes_);
}

void CarvingPage::add_colourings(QHBoxLayout& row) {
    const QString names[] = {tr("Done"), tr("Radius"), tr("Deviation")};
    const char* const ids[] = {"colour_done", "colour_radius", "colour_deviation"};
    for (int i = 0; i < 3; ++i) {
        auto* button = new QPushButton{names[i]};
        button->setProperty("small", true);
        button->setObjectName(ids[i]);
        button->setCheckable(true);
        button->setChecked(i == 0);
        button->setFocusPolicy(Qt::TabFocus);
        colourings_->addButton(button, i);
        row.addWidget(button);
    }
    connect(colourings_, &QButtonGroup::idClicked, this,
            [this](int id) { colour_by(static_cast<session::Colouring>(id)); });
}

void CarvingPage::colour_by(session::Colouring colouring) {
    colouring_ = colouring;
    scene_.reset();
    drawn_.invalidate();
}

void CarvingPage::resizeEvent(QResizeEvent* event) {
    // Where room is short the piece is worth more than figures.
    axes_->setVisible(event->size().height() >= kLeastForTable);
    QWidget::resizeEvent(event);
}

session::CarvedScenePlan CarvingPage::plan() const {
    session::CarvedScenePlan plan = plan_for(view_->drawing());
    plan.colouring = colouring_;
    plan.least_mm = least_mm_;
    plan.most_mm = most_mm_;
    return plan;
}

void CarvingPage::show_scale() {
    const auto job = bench_.job_at_work();
    if (colouring_ == session::Colouring::done || !job || tokens_ == nullptr) return view_->set_legend({});
    const auto mm = [](double value, int decimals) {
        return QString::fromStdString(session::number_text(value, decimals));
    };
    if (colouring_ == session::Colouring::radius) {
        return view_->set_legend(
            QStringLiteral("%1 %2 %3")
                .arg(mm(least_mm_, 0), colour_bar(session::viridis), tr("%1 mm").arg(mm(most_mm_, 0))));
    }
    const session::CarvedScenePlan now = plan();
    const double reach_mm = now.reach_pulses / axis_motion(job->profile, Axis::r1).pulses_per_unit;
    const auto colour = [&now](double ratio) {
        const bool is_neutral = std::abs(2.0 * ratio - 1.0) * now.reach_pulses <= now.neutral_pulses;
        return is_neutral ? kDone : session::vik(ratio);
    };
    view_->set_legend(tr("too deep %1 material left<br>±%2 mm, ±%3 pulses")
                          .arg(colour_bar(colour), mm(reach_mm, 3), QString::number(now.reach_pulses)));
}

void CarvingPage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    view_->set_theme(tokens);
    axes_->set_theme(tokens);
    drawn_positions_ = {};
}

void CarvingPage::refresh() {
    lane_.deliver();
    keep_record();
    axes_->refresh();
    // A recording's pulses are judged by `psicarve verify`; here it is the piece alone.
    QAbstractButton* const deviation = colourings_->button(static_cast<int>(session::Colouring::deviation));
    deviation->setEnabled(!bench_.replay.is_open());
    deviation->setToolTip(bench_.replay.is_open()
                              ? tr("Deviation: not of a recording; psicarve verify tells it")
                              : tr("Carved against wanted: blue too deep, brown material left"));
    if (bench_.replay.is_open() && colouring_ == session::Colouring::deviation)
        colourings_->button(static_cast<int>(session::Colouring::done))->click();
    if (!isVisible() || tokens_ == nullptr) return;
    draw();
    say();
}

/// A fresh blank. Of a large job it takes longer than a window may stand still, and so does the end of the
/// one before; what is carved meanwhile waits in the core's ring.
void CarvingPage::make_record() {
    std::shared_ptr<const session::CarvingRecord> before{std::move(record_)};
    lane_.drop_waiting();
    lane_.post([this, before = std::move(before), job = job_,
                number = ++record_number_]() mutable -> session::WorkLane::Finish {
        before.reset();
        if (!job) return {};
        auto made = session::CarvingRecord::make(job);
        if (!made) return {};
        auto record = std::make_shared<std::unique_ptr<session::CarvingRecord>>(std::move(*made));
        return [this, number, record] {
            if (number != record_number_) return;
            record_ = std::move(*record);
            scene_.reset();
            rods_ = {};
        };
    });
}

void CarvingPage::keep_record() {
    const auto job = bench_.desk.core_job();
    if (job != job_) {
        job_ = job;
        job_start_tick_ = 0;
        make_record();
    }
    const auto& status = bench_.machine.sight().status;
    if (!job_ || !status) return bench_.machine.skip_increments();
    if (status->job_start_tick != job_start_tick_) {
        if (job_start_tick_ != 0) make_record();
        job_start_tick_ = status->job_start_tick;
    }
    if (!record_) return;
    // What was carved before this start was another piece.
    bench_.machine.read_increments([this](const IncrementEntry& entry) {
        if (entry.tick >= job_start_tick_ && job_start_tick_ != 0) record_->take(entry);
    });
    const bool is_complete = status->points_total > 0 && status->points_done == status->points_total;
    if (status->points_done > 0)
        record_->take_as_planned(is_complete ? status->layer + 1 : status->layer, kCellsPerLook);
}

session::CarvingRecord* CarvingPage::shown_record() const noexcept {
    return bench_.replay.is_open() ? bench_.replay.carving() : record_.get();
}

void CarvingPage::draw() {
    session::CarvingRecord* const record = shown_record();
    // A fresh blank is on its way: what stands there stays until then.
    if (record == nullptr && job_ && !bench_.replay.is_open()) return;
    if (shown_replay_ != bench_.replay.edition() || drawn_record_ != record) scene_.reset();
    shown_replay_ = bench_.replay.edition();
    drawn_record_ = record;
    if (record == nullptr) {
        if (view_->picture().bodies.empty()) return;
        view_->set_heads({});
        return view_->show_scene(nullptr);
    }
    const auto& status = bench_.shown().status;
    verify::Positions positions{};
    if (status)
        std::copy(std::begin(status->position_pulses), std::end(status->position_pulses), positions.begin());
    const bool is_same = scene_ && drawn_edition_ == record->edition() && drawn_positions_ == positions;
    view_->set_moving(bench_.replay.is_open() ? bench_.replay.clock().is_playing()
                                              : is_moving(bench_.machine.sight().state()));
    if (is_same || (drawn_.isValid() && drawn_.elapsed() < kLeastPause_ms)) return;
    drawn_.start();
    drawn_edition_ = record->edition();
    drawn_positions_ = positions;
    if (!scene_ || scene_drawing_ != view_->drawing()) {
        scene_drawing_ = view_->drawing();
        take_range();
        scene_ = std::make_unique<session::CarvedScene>(*record, plan());
        const bool is_recoloured = is_seen_ == record;
        is_seen_ = record;
        if (is_recoloured) view_->replace_scene(scene_->scene());
        if (!is_recoloured) view_->show_scene(scene_->scene());
        show_scale();
    }
    view_->vertices_changed(scene_->update(*record));
    draw_heads(*record);
}

/// Whole mm around the job's radii.
void CarvingPage::take_range() {
    const auto job = bench_.job_at_work();
    if (!job || job == ranged_job_) return;
    constexpr std::size_t kColumns = 360;
    constexpr std::size_t kRows = 240;
    const session::RadiusMap map = session::radius_map(*job, kColumns, kRows);
    ranged_job_ = job;
    least_mm_ = map.least_mm;
    most_mm_ = map.most_mm;
}

void CarvingPage::draw_heads(const session::CarvingRecord& record) {
    const auto pose = record.pose(drawn_positions_);
    const double across_mm = scene_->scene()->size[0];
    const QColor colours[] = {tokens_->r1, tokens_->r2};
    std::vector<MeshView::Head> heads;
    for (std::size_t h = 0; h < verify::kHeadCount; ++h) {
        // Where it stands is known once its axis is homed, and from a recording.
        const auto& sight = bench_.machine.sight();
        const bool is_known = sight.is_homed(verify::kHeads[h]) && sight.is_homed(Axis::y);
        if (!is_known && !bench_.replay.is_open()) continue;
        const auto& at = pose.heads[h];
        if (!rods_[h])
            rods_[h] = std::make_shared<const session::MeshScene>(
                session::head_scene(across_mm * kRodLength, across_mm * kRodRadius));
        const double name_mm = at.radius_mm + across_mm * kRodLength * 0.85;
        heads.push_back(
            {{rods_[h], {{at.radius_mm, 0.0, at.height_mm}, at.direction_rad}, colours[h].rgb() & 0xFFFFFFU},
             h == 0 ? QStringLiteral("R1") : QStringLiteral("R2"),
             colours[h],
             {name_mm * std::cos(at.direction_rad), name_mm * std::sin(at.direction_rad),
              at.height_mm + 2.0 * across_mm * kRodRadius}});
    }
    view_->turn_part(pose.part_turn_rad);
    view_->set_heads(std::move(heads));
}

void CarvingPage::say() {
    const auto& status = bench_.shown().status;
    const session::CarvingRecord* const record = shown_record();
    const auto job = bench_.job_at_work();
    if (bench_.replay.carving_ratio() < 1.0) {
        point_->clear();
        return done_->setText(
            tr("Working the piece out: %1 %").arg(qRound(100.0 * bench_.replay.carving_ratio())));
    }
    if (record == nullptr || !job || !status || status->points_total == 0) {
        done_->clear();
        point_->clear();
        return;
    }
    const std::uint32_t layers = job->view.layer_count();
    const std::uint32_t planned = record->planned_layers();
    const bool is_planned = bench_.replay.is_open() && !bench_.replay.facts().knows_every_pulse;
    done_->setText(is_planned ? tr("Light: carved, as planned. Dark: blank.")
                   : planned == 0
                       ? tr("Light: carved. Dark: blank.")
                       : tr("Light: carved (%1 layers not seen: as planned). Dark: blank.").arg(planned));
    point_->setText(tr("Layer %1 / %2, point %3 / %4")
                        .arg(std::min(status->layer + 1, layers))
                        .arg(layers)
                        .arg(status->point + 1)
                        .arg(job->view.point_count()));
}

}  // namespace psicarve::ui
