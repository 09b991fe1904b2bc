// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/ui/fit_audit.hpp"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QListWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QStyleOptionSpinBox>
#include <QTabBar>
#include <QTableWidget>
#include <QTextDocument>

#include <algorithm>
#include <vector>

#include "hmi/ui/state_pill.hpp"

namespace psicarve::ui::test {
namespace {

constexpr int kRounding = 1;     // px: widths of texts are fractions
constexpr int kIconGap = 4;      // px: between a button's icon and its text
constexpr int kCellPadding = 6;  // px: of a table's cell, both sides
constexpr int kHeaderPadding = 12;

/// Its own name, or that of the nearest with one.
std::string name_of(const QWidget& widget) {
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget()) {
        if (at->objectName().isEmpty() || at->objectName().startsWith("qt_")) continue;
        const std::string name = at->objectName().toStdString();
        return at == &widget ? name : name + "/" + widget.metaObject()->className();
    }
    return widget.metaObject()->className();
}

/// The widest line.
int text_width(const QFont& font, const QString& text) {
    int widest = 0;
    QString plain = text;
    plain.replace("&&", "\1").remove('&').replace('\1', '&');
    for (const QString& line : plain.split('\n'))
        widest = std::max(widest, QFontMetrics{font}.horizontalAdvance(line));
    return widest;
}

class Audit {
public:
    std::set<std::string> run(const QWidget& root) {
        look(root);
        return std::move(found_);
    }

private:
    void add(const QWidget& widget, const std::string& what, const QString& text = {}) {
        found_.insert(name_of(widget) + ": " + what + (text.isEmpty() ? "" : ": " + text.toStdString()));
    }
    void need(const QWidget& widget, const char* what, int needed, int there, const QString& text) {
        if (needed > there + kRounding)
            add(widget, std::string{what} + " " + std::to_string(there) + " of " + std::to_string(needed),
                text);
    }

    void look(const QWidget& widget) {
        look_at_words(widget);
        if (const auto* area = qobject_cast<const QScrollArea*>(&widget)) look_at_area(*area);
        if (const auto* layout = widget.layout()) look_at_children(widget, *layout);
        for (const QObject* child : widget.children()) {
            const auto* inner = qobject_cast<const QWidget*>(child);
            if (inner != nullptr && inner->isVisible() && !inner->isWindow()) look(*inner);
        }
    }

    void look_at_words(const QWidget& widget) {
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) look_at_button(*button);
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) look_at_label(*label);
        if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) look_at_tabs(*tabs);
        if (const auto* box = qobject_cast<const QComboBox*>(&widget)) look_at_box(*box);
        if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(&widget)) look_at_spin(*spin);
        if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
            need(*group, "title", text_width(group->font(), group->title()), group->width(), group->title());
        if (const auto* list = qobject_cast<const QListWidget*>(&widget)) look_at_list(*list);
        if (const auto* table = qobject_cast<const QTableWidget*>(&widget)) look_at_table(*table);
        if (const auto* pill = dynamic_cast<const StatePill*>(&widget)) {
            if (pill->is_cut_off()) add(*pill, "cut off", pill->accessibleName());
        }
    }

    void look_at_button(const QAbstractButton& button) {
        if (button.text().isEmpty()) return;
        QStyleOptionButton option;
        option.initFrom(&button);
        const bool is_box = qobject_cast<const QCheckBox*>(&button) != nullptr;
        const QRect room = button.style()->subElementRect(
            is_box ? QStyle::SE_CheckBoxContents : QStyle::SE_PushButtonContents, &option, &button);
        QFont font = button.font();
        if (button.isCheckable() && !is_box) font.setBold(true);  // as it is when it is chosen
        const int icon = button.icon().isNull() ? 0 : button.iconSize().width() + kIconGap;
        need(button, "button", text_width(font, button.text()) + icon, room.width(), button.text());
        const auto lines = static_cast<int>(button.text().count('\n')) + 1;
        need(button, "button's height", lines * QFontMetrics{font}.height(), button.height(), button.text());
    }

    /// Where its least size is another one since it was asked for its hint a label gives the old one still.
    static void forget_old_size(const QLabel& label) {
        if (label.minimumSize().isNull()) return;
        QEvent change{QEvent::ContentsRectChange};
        QApplication::sendEvent(const_cast<QLabel*>(&label), &change);
    }

    void look_at_label(const QLabel& label) {
        if (label.text().isEmpty()) return;
        const bool has_marks = label.text().contains("</") || label.text().contains("&nbsp;");
        if (label.textFormat() == Qt::PlainText && has_marks)
            add(label, "marks instead of colours", label.text());
        const QRect room = label.contentsRect();
        if (!label.wordWrap()) {
            forget_old_size(label);
            need(label, "label", label.minimumSizeHint().width(), label.width(), label.text());
            need(label, "label's height", label.minimumSizeHint().height(), label.height(), label.text());
            return;
        }
        need(label, "wrapped label's height", label.heightForWidth(label.width()), label.height(),
             label.text());
        QTextDocument document;
        document.setHtml(label.text());
        const QString plain = Qt::mightBeRichText(label.text()) ? document.toPlainText() : label.text();
        const QRect taken = label.fontMetrics().boundingRect(QRect{0, 0, room.width(), QWIDGETSIZE_MAX},
                                                             Qt::TextWordWrap, plain);
        need(label, "a word in label", taken.width(), room.width(), label.text());
    }

    void look_at_tabs(const QTabBar& bar) {
        for (int i = 0; i < bar.count(); ++i) {
            if (!bar.isTabVisible(i)) continue;
            const QRect tab = bar.tabRect(i);
            const int text = text_width(bar.font(), bar.tabText(i));
            const QWidget* const badge = bar.tabButton(i, QTabBar::RightSide);
            need(bar, "tab", text + (badge != nullptr ? badge->width() + kIconGap : 0), tab.width(),
                 bar.tabText(i));
            if (!bar.rect().contains(tab)) add(bar, "tab out of sight", bar.tabText(i));
        }
    }

    void look_at_box(const QComboBox& box) {
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.editable = box.isEditable();
        const QRect room =
            box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
        need(box, "choice", text_width(box.font(), box.currentText()), room.width(), box.currentText());
    }

    void look_at_spin(const QAbstractSpinBox& spin) {
        QStyleOptionSpinBox option;
        option.initFrom(&spin);
        option.buttonSymbols = spin.buttonSymbols();
        option.frame = spin.hasFrame();
        option.subControls = QStyle::SC_All;
        const QRect room =
            spin.style()->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxEditField, &spin);
        need(spin, "field", text_width(spin.font(), spin.text()), room.width(), spin.text());
    }

    void look_at_list(const QListWidget& list) {
        if (list.wordWrap()) return;
        for (int i = 0; i < list.count(); ++i)
            need(list, "entry", list.sizeHintForIndex(list.model()->index(i, 0)).width(),
                 list.viewport()->width(), list.item(i)->text());
    }

    void look_at_table(const QTableWidget& table) {
        for (int c = 0; c < table.columnCount(); ++c) {
            const auto* head = table.horizontalHeaderItem(c);
            if (head == nullptr || table.isColumnHidden(c) || !table.horizontalHeader()->isVisible())
                continue;
            need(table, "column's head",
                 text_width(table.horizontalHeader()->font(), head->text()) + kHeaderPadding,
                 table.columnWidth(c), head->text());
            for (int r = 0; r < table.rowCount(); ++r) look_at_cell(table, r, c);
        }
    }

    void look_at_cell(const QTableWidget& table, int row, int column) {
        const auto* item = table.item(row, column);
        // With its whole text to be read it may end in dots; wrapped it is as high as it needs.
        if (item == nullptr || !item->toolTip().isEmpty()) return;
        need(table, "cell", text_width(table.font(), item->text()) + kCellPadding, table.columnWidth(column),
             item->text());
    }

    /// Pages scroll downwards alone.
    void look_at_area(const QScrollArea& area) {
        if (area.widget() == nullptr) return;
        need(area, "scrolls sideways, width", area.widget()->width(), area.viewport()->width(),
             area.widget()->objectName());
    }

    void collect(const QLayout& layout, std::vector<const QWidget*>& into) {
        for (int i = 0; i < layout.count(); ++i) {
            QLayoutItem* const item = layout.itemAt(i);
            if (item->layout() != nullptr) collect(*item->layout(), into);
            if (item->widget() != nullptr && item->widget()->isVisible()) into.push_back(item->widget());
        }
    }

    /// What is laid out side by side stays so, inside its parent.
    void look_at_children(const QWidget& parent, const QLayout& layout) {
        if (qobject_cast<const QStackedWidget*>(&parent) != nullptr) return;
        std::vector<const QWidget*> children;
        collect(layout, children);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const QRect here = children[i]->geometry();
            if (!parent.rect().contains(here) && qobject_cast<const QMainWindow*>(&parent) == nullptr)
                add(*children[i], "reaches out of " + name_of(parent));
            for (std::size_t j = i + 1; j < children.size(); ++j) {
                if (here.intersects(children[j]->geometry()))
                    add(*children[i], "lies over " + name_of(*children[j]));
            }
        }
    }

    std::set<std::string> found_;
};

}  // namespace

std::set<std::string> misfits(const QWidget& root) {
    return Audit{}.run(root);
}

}  // namespace psicarve::ui::test
