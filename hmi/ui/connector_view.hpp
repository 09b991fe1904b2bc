// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <array>
#include <vector>

#include "hmi/profile/pin_rows.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// The port's 25-way connector as one looks at the socket of the computer: pins that are high are filled, by
/// logical levels.
class ConnectorView : public QWidget {
public:
    explicit ConnectorView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_rows(const std::vector<session::PinRow>& rows);
    void show_levels(SignalWord levels);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void draw_tripped(QPainter& painter) const;
    static constexpr int kPins = 25;
    static constexpr int kUpperPins = 13;

    QPointF centre_of(int pin) const;

    const Tokens* tokens_ = nullptr;
    std::array<SignalWord, kPins + 1> signals_{};  ///< by pin: which signals it carries
    std::array<QString, kPins + 1> labels_;
    SignalWord levels_ = 0;
};

}  // namespace psicarve::ui
