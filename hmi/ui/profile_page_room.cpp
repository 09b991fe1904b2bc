// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBoxLayout>
#include <QListWidget>
#include <QResizeEvent>
#include <QTimer>

#include <utility>

#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/profile_row.hpp"

namespace psicarve::ui {
namespace {

constexpr int kListWidth = 132;
constexpr int kLeastForOneLine = 700;
constexpr int kLeastForList = 560;
constexpr int kStackedListHeight = 92;

}  // namespace

/// In a narrow window a key takes two lines; in a very narrow one three, and the parts' names stand above
/// them.
void ProfilePage::arrange() {
    const bool is_stacked = width() < kLeastForList;
    const int lines = is_stacked ? 3 : width() < kLeastForOneLine ? 2 : 1;
    if (std::exchange(row_lines_, lines) == lines) return;
    middle_->setDirection(is_stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    list_->setMinimumSize(is_stacked ? QSize{0, kStackedListHeight} : QSize{kListWidth, 0});
    list_->setMaximumSize(is_stacked ? QSize{QWIDGETSIZE_MAX, kStackedListHeight}
                                     : QSize{kListWidth, QWIDGETSIZE_MAX});
    ProfileRow::arrange_header(*header_, row_lines_);
    for (ProfileRow* row : rows_) row->arrange(row_lines_);
    updateGeometry();
}

void ProfilePage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void ProfilePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    look_for_files();
    // A page that its room makes narrower while it is being shown is not told so.
    QTimer::singleShot(0, this, [this] { arrange(); });
}

}  // namespace psicarve::ui
