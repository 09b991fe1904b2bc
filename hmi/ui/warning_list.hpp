// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include <string>
#include <vector>

#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// What was noticed about a model or job, a line each; not there while there is nothing.
class WarningList : public QListWidget {
public:
    explicit WarningList(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_warnings(std::vector<std::string> warnings);

private:
    void fill();

    const Tokens* tokens_ = nullptr;
    std::vector<std::string> warnings_;
};

}  // namespace psicarve::ui
