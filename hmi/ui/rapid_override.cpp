// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/rapid_override.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include "hmi/replay/replay_session.hpp"
#include "hmi/session/action_lock.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/words.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::ui {
namespace {

constexpr int kSliderWidth_px = 90;

}  // namespace

RapidOverride::RapidOverride(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      slider_(new QSlider{Qt::Horizontal}),
      percent_(role_label("label")) {
    ignore_wheel(slider_);
    slider_->setRange(kLeastOverride_percent, kFullFeed_percent);
    slider_->setPageStep(5);
    slider_->setValue(kFullFeed_percent);
    slider_->setFocusPolicy(Qt::NoFocus);
    ignore_keys(slider_);
    slider_->setFixedWidth(kSliderWidth_px);
    slider_->setObjectName("rapid_override");
    slider_->setAccessibleName(tr("Override of rapids"));
    connect(slider_, &QSlider::valueChanged, this,
            [this](int value) { context_.machine.set_rapid_override(static_cast<std::uint32_t>(value)); });
    percent_->setText(tr("%1 %").arg(kFullFeed_percent));
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(role_label("label", tr("Rapids")));
    row->addWidget(slider_);
    row->addWidget(percent_);
}

void RapidOverride::refresh() {
    const auto lock = context_.replay.is_open()
                          ? replay::lock()
                          : session::lock_of(session::Action::override_feed, context_.machine.view(),
                                             context_.open_job.view());
    lock_with(*slider_, lock ? words(*lock) : QString{}, tr("Of the rapid ways of a program in G-code"));
    const auto& status = context_.shown().status;
    if (!status || status->override_percent == 0) return;
    const int percent = static_cast<int>(rapid_override_percent(*status));
    percent_->setText(tr("%1 %").arg(percent));
    // It follows the machine unless a hand is on it, or its wish is still on the way.
    if (slider_->isSliderDown() || context_.machine.is_override_under_way() || slider_->value() == percent)
        return;
    const QSignalBlocker quiet{slider_};
    slider_->setValue(percent);
}

}  // namespace psicarve::ui
