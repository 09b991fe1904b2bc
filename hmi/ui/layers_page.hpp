// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <memory>

#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;
class QSlider;
class QSpinBox;

namespace psicarve::ui {

class PolarView;
class UnrolledView;

/// The job layer by layer; while it is carved, the layer that the machine is at, until another one is chosen.
class LayersPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::LayersPage)
public:
    explicit LayersPage(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// A layer's number may be typed.
    void choose_number();

private:
    void take_job();
    void show_layer(int number);
    void follow_machine();

    Bench& bench_;
    std::shared_ptr<const cam::PreparedJob> job_;
    double most_mm_ = 1.0;
    std::uint32_t followed_layer_ = 0;
    PolarView* polar_;
    UnrolledView* unrolled_;
    QSlider* slider_;
    QSpinBox* number_;
    QLabel* section_;
    QLabel* facts_;
};

}  // namespace psicarve::ui
