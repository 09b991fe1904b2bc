// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/window_context.hpp"

class QCheckBox;
class QSlider;
class QSpinBox;

namespace psicarve::ui {

class OrderCard;
class JobPairView;
class PreflightList;

/// The job: what it is, what is missing before it can start, and its buttons. Its members: widgets.
class JobPanel : public Dock {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::JobPanel)
public:
    explicit JobPanel(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    void set_room(Room room);
    /// Ctrl+Enter starts the job.
    void let_keys_start(bool may_start);
    /// By so many per cent of the planned feed; 0: back to 100 %. Nothing while the override is locked.
    void change_override(int percent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// How much room its lines are given.
    enum class Density : std::uint8_t { loose, close, brief };

    void make_jobs();
    void make_buttons();
    void make_point_box();
    void make_override();
    void refresh_jobs();
    void fit();
    void arrange(Density density);
    int least_height() const;
    void refresh_checks();
    void refresh_buttons();
    void refresh_layer();
    void refresh_override();
    /// 0 layers: all that follow.
    void start_at_layer(std::uint32_t layers);
    void show_report();
    session::StartPlace chosen_place() const;
    bool may_start_from(const session::StartPlace& from, session::RunKind kind);

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    int fitted_height_ = 0;
    Room room_ = Room::usual;
    JobPairView* jobs_;
    PreflightList* checks_;
    QCheckBox* dry_run_;
    ActionButton* start_;
    ActionButton* hold_;
    ActionButton* resume_;
    ActionButton* stop_;
    ActionButton* report_;
    ActionButton* one_layer_;
    ActionButton* from_layer_;
    QSpinBox* layer_;
    QSpinBox* point_;
    QLabel* reason_;
    OrderCard* refused_;
    QSlider* override_;
    QLabel* percent_;
    ActionButton* full_;
};

}  // namespace psicarve::ui
