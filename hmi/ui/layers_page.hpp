// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <memory>
#include <optional>

#include "hmi/scene/radius_map.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QGridLayout;
class QLabel;
class QLayout;
class QSlider;
class QSpinBox;
class QStackedLayout;

namespace psicarve::ui {

class LayerMap;
class PolarView;
class RadiusPlot;
class TickBox;

/// The job layer by layer and point by point; while it is carved, where the machine is, until another place
/// is chosen. Its members: widgets, and what they show, so that it draws only what has changed.
class LayersPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::LayersPage)
public:
    explicit LayersPage(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// A layer's number may be typed.
    void choose_number();

private:
    QLayout* make_views();
    QLayout* make_along();
    QWidget* make_facts();
    QLabel* add_fact(QGridLayout& grid, const QString& name, const char* id, const char* role = "label");
    void take_job();
    void show_place();
    void show_layer(std::uint32_t layer);
    std::optional<double> planned_seconds() const;
    void show_times(std::uint32_t layer);
    void show_point(std::uint32_t point);
    void follow_machine();

    WindowContext& context_;
    std::shared_ptr<const cam::PreparedJob> job_;
    std::optional<session::TablePlace> shown_;
    bool is_planned_ = false;        ///< the times that are shown
    std::optional<double> whole_s_;  ///< of the job, as the core plans it; goes on counting while it runs
    std::optional<double> shown_whole_s_;
    session::LayerRim rim_;  ///< of the layer that is shown
    double most_mm_ = 1.0;
    QStackedLayout* stack_ = nullptr;
    PolarView* polar_;
    LayerMap* map_;
    RadiusPlot* plot_;
    QSlider* slider_;
    QSlider* point_slider_;
    QSpinBox* number_;
    TickBox* follow_ = nullptr;
    QLabel* section_;
    QLabel* along_;
    QLabel* heads_;
    QLabel* point_text_ = nullptr;
    QLabel* r1_text_ = nullptr;
    QLabel* r2_text_ = nullptr;
    QLabel* range_text_ = nullptr;
    QLabel* time_text_ = nullptr;
    QLabel* until_text_ = nullptr;
};

}  // namespace psicarve::ui
