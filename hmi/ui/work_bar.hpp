// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "hmi/ui/window_context.hpp"
#include "hmi/ui/work_keeper.hpp"

class QLabel;
class QPushButton;

namespace psicarve::ui {

/// Offers to take up again what a window had on the desk that did not end in order: its model with its form,
/// sliced anew where it was sliced. It publishes nothing and moves nothing. Also keeps what this window has
/// there.
class WorkBar : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::WorkBar)
public:
    struct Form {
        QWidget* fields;  ///< lives as long as this
        std::function<void()> slice;
        std::function<void(const QString& path)> open;  ///< as every file is, with what forbids that
    };
    WorkBar(WindowContext& context, Form form, QWidget* parent = nullptr);

    /// Once the form is as for the file on the desk. `changes`: of the fields, counted; `is_stale`: the job
    /// was sliced otherwise than they say.
    void refresh(std::uint64_t changes, bool is_stale);
    /// The window goes in order.
    void forget() { keeper_.forget(); }

private:
    struct Seen {
        std::uint64_t edition = 0;
        std::uint64_t changes = 0;
        session::OpenJobState state = session::OpenJobState::empty;
        bool is_kept = false;
        bool operator==(const Seen&) const = default;
    };
    /// Until it is as it was, or not to be had.
    struct Taking {
        WorkKeeper::Left left;
        std::uint64_t edition_before = 0;  ///< of the desk, when it was asked for
        bool is_filled_in = false;
        bool is_to_slice = false;
    };
    void take_up();
    void decline();
    void fill_in_taken();
    bool is_job_kept();
    void keep(std::uint64_t changes, bool is_stale);
    void settle_taken();
    void show_offer();

    WindowContext& context_;
    Form form_;
    WorkKeeper keeper_;
    std::optional<Seen> seen_;
    QString told_;  ///< the offer that the messages have
    std::optional<Taking> taking_;
    std::weak_ptr<const cam::PreparedJob> published_job_;  ///< the last one, whichever core runs now
    QLabel* offer_;
    QLabel* note_;
    QPushButton* take_;
};

}  // namespace psicarve::ui
