// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/session/model_watch.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/space_canvas.hpp"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QSpinBox;

namespace psicarve::ui {

class MeshView;
class WarningList;

/// The model, how it is to stand and be sliced, and what was noticed about it.
class ModelPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ModelPage)
public:
    explicit ModelPage(Bench& bench, Drawing drawing, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// As the form stands.
    cam::JobOptions job_options() const;
    void slice();

private:
    QWidget* make_view();
    QWidget* make_form();
    void fill_form(QFormLayout& form);
    void refresh_state();
    void show_opened();
    void look();
    void show_sight();
    void show_warnings();
    Profile profile() const;

    Bench& bench_;
    session::ModelWatch watch_;
    std::shared_ptr<const session::ModelWatch::Seen> shown_sight_;
    std::shared_ptr<const session::MeshScene> opened_;
    std::uint64_t shown_edition_ = ~std::uint64_t{0};
    MeshView* view_;
    QLabel* size_;
    WarningList* warnings_;
    QComboBox* up_;
    QComboBox* axis_;
    QDoubleSpinBox* height_;
    QSpinBox* layers_;
    QSpinBox* points_;
    QComboBox* joining_;
    QLabel* state_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    ActionButton* slice_;
    ActionButton* publish_;
};

}  // namespace psicarve::ui
