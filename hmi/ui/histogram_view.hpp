// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "hmi/session/tick_health.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// The lateness of all ticks, a bar for each doubling; bars at which a tick may have been missed are red.
class HistogramView : public QWidget {
public:
    explicit HistogramView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_health(const session::TickHealth& health);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Tokens* tokens_ = nullptr;
    session::TickHealth health_;
};

}  // namespace psicarve::ui
