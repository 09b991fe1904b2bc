// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/session/job_places.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/window_context.hpp"

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace psicarve::ui {

class ElidedLabel;
class JobFactsView;

/// The machine's job and the one on the desk, one below the other; below the one in question what it is. Of
/// a recording there is one job.
class JobPairView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::JobPairView)
public:
    /// `machine_head`, `machine_note`: above the machine's job; not this one's.
    JobPairView(WindowContext& context, QLabel& machine_head, QLabel& machine_note,
                QWidget* parent = nullptr);

    /// Beside the machine's job, whose run it tells of.
    void add_button(QWidget* button);
    void refresh();
    void set_room(Room room);
    /// Lines close together; in as few of them as it can be said.
    void set_density(bool is_close, bool is_brief);
    /// The job in question; null: none.
    const replay::JobPointer& job() const noexcept { return job_; }

private:
    void make_rows();
    void show_machine();
    void show_desk();
    QString name_on_desk() const;
    session::JobPlace place() const;
    void put_facts(session::JobPlace place);

    WindowContext& context_;
    QLabel& machine_head_;
    QLabel& machine_note_;
    QVBoxLayout* column_;
    QHBoxLayout* machine_row_ = nullptr;
    ElidedLabel* machine_name_;
    ActionButton* take_over_;
    QWidget* desk_;
    QLabel* desk_note_;
    ElidedLabel* desk_name_;
    JobFactsView* facts_;
    replay::JobPointer job_;
    std::uint64_t shown_edition_ = ~std::uint64_t{0};
};

}  // namespace psicarve::ui
