// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/carving_page.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/view_buttons.hpp"
#include "shared/units.hpp"

namespace psicarve::ui {
namespace {

using session::DeskState;

/// In software: never more often than this, so that the machine's computer has time for the machine.
constexpr qint64 kLeastPause_ms = 100;
constexpr std::size_t kMostRound = 240;
constexpr std::size_t kMostUp = 200;
constexpr QRgb kDone = 0xC4CAD0;
constexpr QRgb kBlank = 0x7C8894;

}  // namespace

CarvingPage::CarvingPage(Bench& bench, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      view_(new MeshView),
      done_(role_label("label")),
      point_(role_label("title")) {
    view_->setAccessibleName(tr("The blank as carved so far"));
    view_->set_empty_text(tr("No job is published."));
    auto* foot = new QHBoxLayout;
    foot->addWidget(done_, 1);
    foot->addWidget(point_);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->addLayout(view_buttons(*view_));
    all->addWidget(view_, 1);
    all->addLayout(foot);
}

void CarvingPage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    view_->set_theme(tokens);
    drawn_edition_ = 0;
}

void CarvingPage::refresh() {
    keep_record();
    if (!isVisible() || tokens_ == nullptr) return;
    draw();
    say();
}

void CarvingPage::keep_record() {
    const bool is_published = bench_.desk.sight().state == DeskState::published;
    const auto job = is_published ? bench_.desk.job() : nullptr;
    if (job != job_) {
        job_ = job;
        record_.reset();
        if (job_) {
            auto made = session::CarvingRecord::make(job_);
            if (made) record_ = std::move(*made);
        }
        job_start_tick_ = 0;
        drawn_edition_ = ~std::uint64_t{0};
    }
    const auto& status = bench_.machine.sight().status;
    if (!record_ || !status) {
        bench_.machine.skip_increments();
        return;
    }
    if (status->job_start_tick != job_start_tick_) {
        if (job_start_tick_ != 0) record_->start_anew();
        job_start_tick_ = status->job_start_tick;
    }
    // What was carved before this start was another piece.
    bench_.machine.read_increments([this](const IncrementEntry& entry) {
        if (entry.tick >= job_start_tick_ && job_start_tick_ != 0) record_->take(entry);
    });
    const bool is_complete = status->points_total > 0 && status->points_done == status->points_total;
    if (status->points_done > 0) record_->take_as_planned(is_complete ? status->layer + 1 : status->layer);
}

void CarvingPage::draw() {
    if (!record_) {
        if (drawn_edition_ != 0) view_->show_scene(nullptr);
        drawn_edition_ = 0;
        return;
    }
    const bool is_same = drawn_edition_ == record_->edition();
    if (is_same || (drawn_.isValid() && drawn_.elapsed() < kLeastPause_ms)) return;
    drawn_.start();
    drawn_edition_ = record_->edition();
    view_->replace_scene(
        std::make_shared<const session::MeshScene>(record_->scene(kMostRound, kMostUp, kDone, kBlank)));
    std::vector<MeshView::Mark> marks;
    const QColor colours[] = {tokens_->r1, tokens_->r2};
    for (std::size_t head = 0; head < 2; ++head) {
        if (const auto tip = record_->tip(head))
            marks.push_back({*tip, colours[head], head == 0 ? "R1" : "R2"});
    }
    view_->set_marks(std::move(marks));
}

void CarvingPage::say() {
    const auto& status = bench_.machine.sight().status;
    if (!record_ || !status || status->points_total == 0) {
        done_->clear();
        point_->clear();
        return;
    }
    const std::uint32_t layers = job_->view.layer_count();
    const std::uint32_t planned = record_->planned_layers();
    done_->setText(planned == 0
                       ? tr("Light: carved. Dark: blank.")
                       : tr("Light: carved (%1 layers not seen: as planned). Dark: blank.").arg(planned));
    point_->setText(tr("Layer %1 / %2, point %3 / %4")
                        .arg(std::min(status->layer + 1, layers))
                        .arg(layers)
                        .arg(status->point + 1)
                        .arg(job_->view.point_count()));
}

}  // namespace psicarve::ui
