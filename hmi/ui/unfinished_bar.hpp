// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <cstdint>
#include <optional>

#include "hmi/session/going_on.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/notice_bar.hpp"
#include "hmi/ui/side_panels.hpp"

class QLabel;
class QPushButton;

namespace psicarve::ui {

class ActionButton;

/// Which piece is unfinished, where it goes on, on which way the heads come there and what has to be done
/// first. Above all pages whenever there is one and nothing louder, until it goes on or somebody has
/// dismissed it. Begins it anew, once asked.
class UnfinishedBar : public NoticeBar {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::UnfinishedBar)
public:
    explicit UnfinishedBar(Bench& bench, QWidget* parent = nullptr);

    /// In a small window all but what has to be done or known first is in the tool tip.
    void set_room(Room room);
    void refresh() override;

private:
    std::optional<session::UnfinishedPiece> piece() const;
    std::uint64_t job_generation() const;
    void forget_dismissed();
    void begin_anew();

    Bench& bench_;
    QLabel* details_;
    ActionButton* anew_;
    QPushButton* dismiss_;
    std::optional<session::UnfinishedPiece> dismissed_;
    std::uint64_t dismissed_job_ = 0;  ///< generation
    bool is_small_ = false;
};

}  // namespace psicarve::ui
