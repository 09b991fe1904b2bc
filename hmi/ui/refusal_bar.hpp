// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include "hmi/ui/notice_bar.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;

namespace psicarve::ui {

/// Which file was not opened, why, and what Start carves instead. Above all pages, until the next file is
/// asked for or it was read.
class RefusalBar : public NoticeBar {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RefusalBar)
public:
    explicit RefusalBar(WindowContext& context, QWidget* parent = nullptr);

    void refresh() override;
    static QString title_of(const session::RefusedFile& refused);
    /// Without the file's name.
    static QString why_of(const session::RefusedFile& refused);

private:
    QString what_stays() const;

    WindowContext& context_;
    QLabel* why_;
    QLabel* stays_;
};

}  // namespace psicarve::ui
