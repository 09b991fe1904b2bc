// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <memory>

#include "hmi/scene/radius_map.hpp"
#include "hmi/scene/time_map.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/unrolled_view.hpp"
#include "hmi/ui/window_context.hpp"

class QComboBox;

namespace psicarve::ui {

/// A job unrolled, and the choice of what its colours tell: radii, how long the heads take from point to
/// point, or what bounds their speed. The last two are known once a core has planned the job.
class LayerMap : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::LayerMap)
public:
    explicit LayerMap(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void take_job(std::shared_ptr<const cam::PreparedJob> job);
    /// At screen rate.
    void refresh();
    /// Of the finishing pass, in whole mm.
    double most_mm() const noexcept { return radii_.most_mm; }
    UnrolledView& view() noexcept { return *view_; }

private:
    std::shared_ptr<const PointPlan> planned_points() const;
    void show_chosen();
    void show_radii();
    void take_points();
    QString why_unknown() const;
    void show_times();
    void show_bounds();

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    std::shared_ptr<const cam::PreparedJob> job_;
    session::RadiusMap radii_;
    std::shared_ptr<const PointPlan> points_;  ///< that times_ is of; null: not known
    session::TimeMap times_;
    UnrolledView* view_;
    QComboBox* choice_;
};

}  // namespace psicarve::ui
