// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <cstdint>

#include "hmi/ui/notice_bar.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QPushButton;

namespace psicarve::ui {

/// The core runs with another profile than the window was given: both, in what they differ, and a button that
/// takes the core's over. Where the core's was not found: only that.
class CoreProfileBar : public NoticeBar {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::CoreProfileBar)
public:
    explicit CoreProfileBar(WindowContext& context, QWidget* parent = nullptr);

    /// Where it is short the keys are in the tooltip only.
    void set_room(Room room);
    void refresh() override;

private:
    bool is_there() const;
    void show_both();
    void show_given();

    WindowContext& context_;
    QLabel* details_;
    QPushButton* take_;
    std::uint64_t shown_hash_ = 0;
    bool shown_known_ = false;
    bool is_small_ = false;
};

}  // namespace psicarve::ui
