// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/warning_list.hpp"

#include <QCoreApplication>

#include <utility>

#include "hmi/phrase/warning_phrase.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kMostHeight = 96;

}  // namespace

WarningList::WarningList(QWidget* parent) : QListWidget(parent) {
    setObjectName("warnings");
    setAccessibleName(QCoreApplication::translate("psicarve::ui::WarningList", "Warnings"));
    setWordWrap(true);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::TabFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMaximumHeight(kMostHeight);
    hide();
}

void WarningList::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    fill();
}

void WarningList::show_warnings(std::vector<std::string> warnings) {
    if (warnings == warnings_) return;
    warnings_ = std::move(warnings);
    fill();
}

void WarningList::fill() {
    clear();
    for (const std::string& warning : warnings_) {
        addItem(words(session::warning_phrase(warning)));
        if (tokens_ != nullptr)
            item(count() - 1)->setIcon(glyph_icon(Glyph::triangle, tokens_->warn, tokens_->warn));
    }
    setVisible(!warnings_.empty());
}

}  // namespace psicarve::ui
