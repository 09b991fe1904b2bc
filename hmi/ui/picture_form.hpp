// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <functional>

#include "hmi/flat/load_model.hpp"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace psicarve::ui {

class TickBox;

/// How a picture becomes a relief round a cylinder: what `psicarve slice` takes for pictures alone.
class PictureForm : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PictureForm)
public:
    explicit PictureForm(std::function<void()> changed, QWidget* parent = nullptr);

    /// As for another picture; the change is not told.
    void begin_anew();
    void fill(flat::FlatOptions& options) const;

private:
    QDoubleSpinBox* field(const char* name, double least, double most, const QString& name_of_it);
    void make_around();
    QWidget* pair(QWidget* first, QWidget* second);

    std::function<void()> changed_;
    bool is_told_ = true;
    QFormLayout* form_;
    QDoubleSpinBox* diameter_;
    QDoubleSpinBox* around_ = nullptr;
    QDoubleSpinBox* black_;
    QDoubleSpinBox* white_;
    QDoubleSpinBox* gamma_;
    QDoubleSpinBox* smooth_;
    TickBox* invert_;
    TickBox* full_turn_;
    QComboBox* seam_;
};

}  // namespace psicarve::ui
