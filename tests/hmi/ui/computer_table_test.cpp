// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be done at a computer is read whole, however many lines it takes.
#include "hmi/ui/computer_table.hpp"

#include <gtest/gtest.h>

#include "hmi/ui/language.hpp"
#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

constexpr int kTextMargin = 3;  // px: of a cell's text, each side

/// Every word of every cell is inside its cell.
void expect_whole(const QTableWidget& table, const char* where) {
    for (int row = 0; row < table.rowCount(); ++row) {
        EXPECT_GE(table.rowHeight(row), static_cast<const QAbstractItemView&>(table).sizeHintForRow(row))
            << where << ", row " << row;
        for (int column = 0; column < table.columnCount(); ++column) {
            const QTableWidgetItem& cell = *table.item(row, column);
            const int icon = cell.icon().isNull() ? 0 : table.iconSize().width();
            const QRect room{0, 0, table.columnWidth(column) - icon - 2 * kTextMargin, QWIDGETSIZE_MAX};
            const QRect taken = table.fontMetrics().boundingRect(room, Qt::TextWordWrap, cell.text());
            EXPECT_LE(taken.height(), table.rowHeight(row)) << where << ": " << cell.text().toStdString();
        }
    }
}

class ComputerIsRead : public test::PagesRig, public ::testing::WithParamInterface<Language> {
protected:
    ComputerIsRead() { use_language(GetParam()); }
    ~ComputerIsRead() override { use_language(Language::english); }
};

TEST_P(ComputerIsRead, WholeAtAComputerWithAllThatCanBeWrong) {
    using doctor::Finding;
    using doctor::Verdict;
    std::vector<Finding> findings(
        12,
        Finding{"kernel", Verdict::warning, "6.18.44-fc-v669, not PREEMPT_RT",
                "the kernel itself keeps the tick waiting, at times for milliseconds; they are skipped and "
                "counted",
                "install a real-time kernel: apt install linux-image-rt-amd64"});
    findings.push_back(
        Finding{"processor of the tick", Verdict::warning, "none is kept free",
                "other programs and interrupts run where the tick does",
                "start the kernel with isolcpus=N nohz_full=N rcu_nocbs=N, N the last processor"});
    ComputerTable sut;
    const Tokens& tokens = tokens_of(Theme::light);
    sut.setStyleSheet(style_sheet(tokens, false));
    sut.set_theme(tokens);
    sut.resize(708, 334);  // on a screen of 1280 x 720
    sut.show();
    QApplication::processEvents();
    sut.show_rows(session::finding_rows(findings));
    for (const int width : {708, 520, 900, 708}) {
        sut.resize(width, 334);
        // Rows, the bar at their side, the width that it takes, rows.
        for (int look = 0; look < 4; ++look) QApplication::processEvents();
        expect_whole(sut, std::to_string(width).c_str());
    }
}

TEST_P(ComputerIsRead, WholeOnItsPage) {
    open_window();
    show_page("realtime_page");
    ASSERT_TRUE(click("check_computer"));
    auto& table = part<QTableWidget>("computer_table");
    ASSERT_TRUE(comes_true([&] { return table.rowCount() >= 10; }));
    for (int look = 0; look < 4; ++look) QApplication::processEvents();
    take_picture(QString{"this_computer_%1"}.arg(
        QLatin1String(kLanguages[static_cast<std::size_t>(GetParam())].code)));
    expect_whole(table, "the page");
}

INSTANTIATE_TEST_SUITE_P(InEveryLanguage, ComputerIsRead,
                         ::testing::Values(Language::english, Language::chinese, Language::russian),
                         [](const auto& named) {
                             return std::string{kLanguages[static_cast<std::size_t>(named.param)].code};
                         });

}  // namespace
}  // namespace psicarve::ui
