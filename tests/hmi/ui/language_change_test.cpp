// SPDX-License-Identifier: GPL-3.0-or-later
// Another language while the window is open.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>

#include <array>
#include <map>
#include <set>

#include "hmi/ui/carving_page.hpp"
#include "hmi/ui/language.hpp"
#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

constexpr int kPages = 8;
using PageTexts = std::array<std::set<QString>, kPages>;

class LanguageChange : public test::PagesRig {
protected:
    void choose_language(Language language) {
        const QString code = QLatin1String(kLanguages[static_cast<std::size_t>(language)].code);
        part<QAction>(("language_" + code).toUtf8().constData()).trigger();
        ASSERT_TRUE(comes_true([&] { return used_language() == language; }));
    }
    void open_with_job() {
        open_window();
        window_->resize(1600, 900);
        window_->open(QString::fromStdString(example("small.stl")));
        ASSERT_TRUE(comes_to(session::OpenJobState::model)) << all_messages().toStdString();
        ASSERT_TRUE(click("slice"));
        ASSERT_TRUE(comes_to(session::OpenJobState::job)) << all_messages().toStdString();
    }
    /// Whatever can be read of a widget, with its tip and what it is called for those who do not see.
    static QStringList texts_of(const QWidget& widget) {
        QStringList texts{widget.toolTip(), widget.accessibleName(), widget.accessibleDescription()};
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) texts << button->text();
        if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
            texts << line->text() << line->placeholderText();
        if (const auto* menu = qobject_cast<const QMenu*>(&widget)) texts << menu->title();
        for (const QAction* action : widget.actions()) texts << action->text() << action->toolTip();
        if (const auto* box = qobject_cast<const QComboBox*>(&widget))
            for (int i = 0; i < box->count(); ++i) texts << box->itemText(i);
        if (const auto* bar = qobject_cast<const QTabBar*>(&widget))
            for (int i = 0; i < bar->count(); ++i) texts << bar->tabText(i) << bar->tabToolTip(i);
        if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) add_cells(*view, texts);
        return texts;
    }
    static void add_cells(const QAbstractItemView& view, QStringList& texts) {
        const QAbstractItemModel* const model = view.model();
        // Two windows have not had the same messages.
        if (model == nullptr || view.objectName() == "messages") return;
        if (qobject_cast<const QHeaderView*>(&view) != nullptr) return;  // of the table round it
        for (int column = 0; column < model->columnCount(); ++column) {
            texts << model->headerData(column, Qt::Horizontal).toString();
            for (int row = 0; row < model->rowCount(); ++row)
                texts << model->index(row, column).data().toString();
        }
    }
    std::set<QString> visible_texts() {
        static const std::set<QString> kOfTheMoment{"last_message", "message_pane"};
        std::set<QString> all;
        for (const QWidget* widget : window_->findChildren<QWidget*>()) {
            const bool is_menu = qobject_cast<const QMenu*>(widget) != nullptr;
            if ((!widget->isVisible() && !is_menu) || kOfTheMoment.contains(widget->objectName())) continue;
            // Files that were opened before.
            if (widget->objectName() == "recent_menu") continue;
            for (const QString& text : texts_of(*widget)) all.insert(text);
        }
        return all;
    }
    std::set<QString> texts_of_page(int page) {
        window_->findChild<QTabWidget*>()->setCurrentIndex(page);
        QApplication::processEvents();
        window_->refresh();
        return visible_texts();
    }
    /// They settle: what is worked out in the background comes later.
    void expect_as_in(const PageTexts& wanted, const char* when) {
        for (int page = 0; page < kPages; ++page) {
            std::set<QString> had;
            const auto& own = wanted[static_cast<std::size_t>(page)];
            const bool is_same = comes_true(
                [&] {
                    had = texts_of_page(page);
                    return had == own;
                },
                two_process::milliseconds{20'000});
            if (is_same) continue;
            for (const QString& text : had)
                if (!own.contains(text))
                    ADD_FAILURE() << when << ", page " << page << " has " << text.toStdString();
            for (const QString& text : own)
                if (!had.contains(text))
                    ADD_FAILURE() << when << ", page " << page << " lacks " << text.toStdString();
        }
    }
    /// As a window has them that was begun in this language, once nothing changes any more.
    PageTexts texts_of_window_begun_in(Language language) {
        use_language(language);
        open_with_job();
        PageTexts texts;
        // Through all pages, again and again: what comes late to one has come when the others have been seen.
        constexpr int kStillRounds = 5;
        int still = 0;
        EXPECT_TRUE(comes_true([&] {
            const PageTexts before = texts;
            for (int page = 0; page < kPages; ++page)
                texts[static_cast<std::size_t>(page)] = texts_of_page(page);
            still = texts == before ? still + 1 : 0;
            return still >= kStillRounds;
        }));
        return texts;
    }
};

TEST_F(LanguageChange, GivesTheTextsOfAWindowThatWasBegunInIt) {
    std::map<Language, PageTexts> begun;
    for (const Language language : {Language::chinese, Language::russian, Language::english})
        begun[language] = texts_of_window_begun_in(language);
    ASSERT_FALSE(HasFailure());
    EXPECT_NE(begun[Language::chinese][0], begun[Language::english][0]);
    open_with_job();
    for (const Language language : {Language::chinese, Language::russian, Language::english}) {
        choose_language(language);
        const char* const code = kLanguages[static_cast<std::size_t>(language)].code;
        expect_as_in(begun[language], code);
        take_picture(QStringLiteral("changed_to_") + code);
    }
}

// What is on the desk, what was typed and where the machine is: nothing of it is asked for once more.
TEST_F(LanguageChange, TakesNothingAway) {
    open_with_job();
    part<QDoubleSpinBox>("height").setValue(31.5);
    part<QAbstractButton>("turn").click();
    part<QDoubleSpinBox>("turn_x").setValue(90.0);
    window_->refresh();
    ASSERT_TRUE(comes_to(session::OpenJobState::model)) << "turned: its job is gone";
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    const auto job = window_->context().open_job.job();
    const std::uint64_t edition = window_->context().open_job.edition();
    show_page("layers_page");
    window_->context().layer_cursor.choose_layer(5);
    part<QAbstractButton>("dry_run").setChecked(true);
    part<QSpinBox>("layer").setMaximum(40);
    part<QSpinBox>("layer").setValue(7);
    show_page("profile_page");
    edit("name", "mill");
    ASSERT_EQ(profile().draft().changed_count(), 1U);
    choose_language(Language::russian);
    EXPECT_EQ(window_->findChild<QTabWidget*>()->currentIndex(), 6);
    EXPECT_EQ(part<QDoubleSpinBox>("height").value(), 31.5);
    EXPECT_TRUE(part<QAbstractButton>("turn").isChecked());
    EXPECT_EQ(part<QDoubleSpinBox>("turn_x").value(), 90.0);
    for (int look = 0; look < 20; ++look) window_->refresh();
    EXPECT_EQ(window_->context().open_job.job(), job);
    EXPECT_EQ(window_->context().open_job.edition(), edition);
    EXPECT_EQ(window_->context().layer_cursor.place().layer, 5U);
    EXPECT_TRUE(part<QAbstractButton>("dry_run").isChecked());
    EXPECT_EQ(window_->findChildren<QObject*>("compare_tool").size(), 1);
    EXPECT_EQ(part<QSpinBox>("layer").value(), 7);
    EXPECT_EQ(profile().draft().changed_count(), 1U);
}

TEST_F(LanguageChange, LeavesTheCarvingAndItsPictureAlone) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
    ASSERT_TRUE(comes_to(MachineState::carving));
    show_page("carving_page");
    const auto& watch = window_->context().carving;
    ASSERT_TRUE(
        comes_true([&] { return watch.record() != nullptr && machine_view().status->points_done > 300; }));
    const session::CarvingRecord* const record = watch.record();
    const std::uint64_t edition = watch.edition();
    for (const Language language : {Language::russian, Language::chinese, Language::english}) {
        choose_language(language);
        EXPECT_EQ(watch.record(), record);
        EXPECT_EQ(watch.edition(), edition);
        EXPECT_EQ(machine_view().state(), MachineState::carving) << all_messages().toStdString();
        ASSERT_TRUE(comes_true([&] { return !part<QLabel>("carving_point").text().isEmpty(); }));
    }
    ASSERT_TRUE(click("hold"));
    EXPECT_TRUE(comes_to(MachineState::held));
}

// Whoever has a hand on something is let go of first.
TEST_F(LanguageChange, DisarmsTheKeys) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    window_->activateWindow();
    ASSERT_TRUE(click("arm_keys"));
    choose_language(Language::russian);
    const auto at = machine_view().status->position_pulses[index_of(Axis::y)];
    QTest::keyClick(window_.get(), Qt::Key_Up);
    for (int look = 0; look < 50; ++look) window_->refresh();
    EXPECT_EQ(machine_view().status->position_pulses[index_of(Axis::y)], at);
    EXPECT_EQ(machine_view().state(), MachineState::ready);
}

}  // namespace
}  // namespace psicarve::ui
