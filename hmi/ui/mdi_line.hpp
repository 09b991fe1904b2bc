// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <cstddef>

#include "hmi/ui/window_context.hpp"

class QLabel;
class QLineEdit;

namespace psicarve::ui {

/// One block of G-code, typed and run by Return; Up and Down bring back those before. What is wrong with it
/// is told below, with its column.
class MdiLine : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MdiLine)
public:
    explicit MdiLine(WindowContext& context, QWidget* parent = nullptr);

    void refresh();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void run_block();
    void bring_back(bool is_older);
    QString said() const;

    WindowContext& context_;
    QLineEdit* line_;
    QLabel* said_;
    QString refused_;  ///< why Return did nothing; until the text or the machine is another
    bool is_text_refused_ = false;
    std::size_t behind_last_ = 0;  ///< 0: what is being typed, 1: the last block ...
    QString typed_;                ///< before others were brought back
};

}  // namespace psicarve::ui
