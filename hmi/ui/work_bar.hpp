// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "hmi/ui/bench.hpp"
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
    };
    WorkBar(Bench& bench, Form form, QWidget* parent = nullptr);

    /// Once the form is as for the file on the desk. `changes`: of the fields, counted; `is_stale`: the job
    /// was sliced otherwise than they say.
    void refresh(std::uint64_t changes, bool is_stale);
    /// The window goes in order.
    void forget() { keeper_.forget(); }

private:
    struct Seen {
        std::uint64_t edition = 0;
        std::uint64_t changes = 0;
        session::DeskState state = session::DeskState::empty;
        bool is_saved = false;
        bool operator==(const Seen&) const = default;
    };
    void take_up();
    void fill_in_taken();
    void keep(std::uint64_t changes, bool is_stale);
    void slice_again();
    void show_offer();

    Bench& bench_;
    Form form_;
    WorkKeeper keeper_;
    std::optional<Seen> seen_;
    QString told_;  ///< the offer that the messages have
    std::optional<WorkKeeper::Left> taking_;
    std::uint64_t edition_before_ = 0;  ///< of the desk, when that was asked for
    std::string sliced_path_;           ///< to be sliced once it is as it was; empty: none
    QLabel* offer_;
    QLabel* note_;
    QPushButton* take_;
};

}  // namespace psicarve::ui
