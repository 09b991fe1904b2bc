// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/side_panels.hpp"

class QCheckBox;
class QSlider;
class QSpinBox;

namespace psicarve::ui {

class ElidedLabel;
class JobFactsView;
class PreflightList;

/// The job: what it is, what is missing before it can start, and its buttons.
class JobPanel : public Dock {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::JobPanel)
public:
    explicit JobPanel(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    void set_room(Room room);
    /// By so many per cent of the planned feed; 0: back to 100 %. Nothing while the override is locked.
    void change_override(int percent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void make_facts();
    void make_buttons();
    void make_override();
    void refresh_facts();
    replay::JobPointer job_shown() const;
    void refresh_next();
    void refresh_checks();
    void refresh_buttons();
    void refresh_layer();
    void refresh_override();
    /// 0 layers: all that follow.
    void start_at_layer(std::uint32_t layers);
    void show_report();
    bool may_start_from_layer(std::uint32_t layer, session::RunKind kind);

    Bench& bench_;
    const Tokens* tokens_ = nullptr;
    std::uint64_t shown_edition_ = ~std::uint64_t{0};
    std::uint32_t shown_layer_ = 0;
    replay::JobPointer shown_job_;
    QLabel* next_;
    ElidedLabel* name_;
    JobFactsView* facts_;
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
    QLabel* reason_;
    QSlider* override_;
    QLabel* percent_;
    ActionButton* full_;
};

}  // namespace psicarve::ui
