// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <functional>

namespace psicarve::ui {

/// A panel that was taken out of the window, in a frame of its own above it. Closing the frame puts it back.
class FloatingPanel : public QWidget {
public:
    /// `left` is called when another window becomes the active one.
    FloatingPanel(QWidget& panel, const QString& title, QWidget* owner, std::function<void()> put_back,
                  std::function<void()> left);

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::function<void()> put_back_;
    std::function<void()> left_;
};

}  // namespace psicarve::ui
