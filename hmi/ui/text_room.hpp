// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace psicarve::ui {

/// Words one below the other: as high as they are where there is room for that, and scrolled where there is
/// none.
class TextRoom : public QScrollArea {
public:
    explicit TextRoom(QWidget* parent = nullptr);

    /// Of what is inside.
    QVBoxLayout& column() noexcept { return *column_; }
    void show_top();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh_height();

    QVBoxLayout* column_;
    int full_height_ = 0;
};

}  // namespace psicarve::ui
