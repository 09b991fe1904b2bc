// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <vector>

#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/window_context.hpp"

class QGridLayout;
class QLabel;

namespace psicarve::ui {

/// What the job is: counts, size, time; where there is room, its source, joining and what no head reaches.
class JobFactsView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::JobFactsView)
public:
    explicit JobFactsView(WindowContext& context, QWidget* parent = nullptr);

    void set_room(Room room);
    /// Counts and size in one line, and no T_ref.
    void set_brief(bool is_brief);
    /// Of the job that the panel is about; null: none, or not sliced yet.
    void show_job(const replay::JobPointer& job);
    void show_times(const replay::JobPointer& job);

private:
    struct Row {
        QLabel* name;
        QLabel* value;
    };
    Row add_row(const QString& name, const char* id);
    void show_source(const replay::JobPointer& job);
    void show_size(const QString& counts, const QString& size);

    WindowContext& context_;
    QGridLayout* grid_;
    Row counts_;
    Row size_;
    QLabel* brief_;
    Row pass_;
    QLabel* time_;
    Row reference_;
    std::vector<Row> source_rows_;
    bool is_wide_ = false;
    bool is_brief_ = false;
};

}  // namespace psicarve::ui
