// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <cstdint>
#include <optional>

#include "hmi/session/going_on.hpp"
#include "hmi/ui/notice_bar.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/window_context.hpp"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace psicarve::ui {

class ActionButton;

/// Which piece is unfinished, also one that only a disk knows after the computer was switched off, where it
/// goes on, on which way the heads come there and what has to be done first. Above all pages whenever there
/// is one and nothing louder, until it goes on or is dismissed. Begins it anew, once asked, and,
/// where Start goes on within a layer, goes on from that layer's begin.
class UnfinishedBar : public NoticeBar {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::UnfinishedBar)
public:
    explicit UnfinishedBar(WindowContext& context, QWidget* parent = nullptr);

    /// In a small window all but what has to be done or known first is in the tool tip.
    void set_room(Room room);
    void refresh() override;

private:
    std::optional<session::UnfinishedPiece> piece() const;
    /// Only while nothing is open here: null else.
    const FoundCheckpoint* saved_piece() const;
    void show_piece(const session::UnfinishedPiece& piece);
    void show_saved(const FoundCheckpoint& found);
    void show_texts(const QString& heading, const QString& details, const QString& all);
    void dismiss();
    std::uint64_t job_generation() const;
    void forget_dismissed();
    void begin_anew();
    void begin_layer_anew();

    WindowContext& context_;
    QLabel* details_;
    ActionButton* from_begin_;  ///< of the layer within which it goes on
    ActionButton* anew_;
    QPushButton* open_;
    QPushButton* forget_;
    QPushButton* dismiss_;
    QBoxLayout* ways_out_;  ///< the two
    std::optional<session::UnfinishedPiece> dismissed_;
    std::uint64_t dismissed_job_ = 0;    ///< generation
    std::uint64_t dismissed_saved_ = 0;  ///< its checksum
    bool is_small_ = false;
};

}  // namespace psicarve::ui
