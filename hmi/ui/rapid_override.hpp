// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/ui/window_context.hpp"

class QLabel;
class QSlider;

namespace psicarve::ui {

/// The override of a program's rapid ways: a slider that no key and no wheel reaches, and its percentage.
class RapidOverride : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RapidOverride)
public:
    explicit RapidOverride(WindowContext& context, QWidget* parent = nullptr);
    void refresh();

private:
    WindowContext& context_;
    QSlider* slider_;
    QLabel* percent_;
};

}  // namespace psicarve::ui
