// SPDX-License-Identifier: GPL-3.0-or-later
// The window in each of its languages.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QFontDatabase>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>

#include <set>
#include <string>

#include "hmi/session/action_lock.hpp"
#include "hmi/session/core_phrase.hpp"
#include "hmi/session/error_phrase.hpp"
#include "hmi/ui/language.hpp"
#include "hmi/ui/words.hpp"
#include "shared/command.hpp"
#include "shared/profile_table.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;

/// What a window asks for while it is looked at, and whether the catalogue has it.
class Listener : public QTranslator {
public:
    explicit Listener(Language language) {
        const QString code = QLatin1String(kLanguages[static_cast<std::size_t>(language)].code);
        EXPECT_TRUE(catalogue_.load(":/translations/psicarve_" + code + ".qm"));
    }
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char* note, int count) const override {
        const QString found = catalogue_.translate(context, text, note, count);
        const std::string of = context;
        const bool is_ours = of.starts_with("psicarve") || of == "session" || of == "profile";
        if (found.isEmpty() && (is_ours || is_word_of_the_core(of, text)) && has_words(text))
            missing.insert(text);
        return found;
    }
    mutable std::set<std::string> missing;

private:
    /// Not names, paths and numbers: what the core calls its states, alarms and commands.
    static bool is_word_of_the_core(const std::string& context, const std::string& text) {
        bool is_one = false;
        for (std::uint32_t k = 0; k < kMachineStateCount; ++k)
            is_one |= text == name_of(static_cast<MachineState>(k));
        for (std::uint32_t k = 0; k < kAlarmCauseCount; ++k)
            is_one |= text == name_of(static_cast<AlarmCause>(k));
        for (std::uint32_t k = 0; k < kCommandKindCount; ++k)
            is_one |= text == name_of(static_cast<CommandKind>(k));
        return is_one && context == "core";
    }
    /// Signs and units are the same everywhere.
    static bool has_words(const std::string& text) {
        int letters = 0;
        for (const char c : text) {
            letters = std::isalpha(static_cast<unsigned char>(c)) != 0 ? letters + 1 : 0;
            if (letters >= 2) return true;
        }
        return false;
    }
    Catalogue catalogue_;
};

class Languages : public WindowRig, public ::testing::WithParamInterface<Language> {
protected:
    Languages() { use_language(GetParam()); }
    ~Languages() override { use_language(Language::english); }

    void look_at_all_pages(const QString& language) {
        auto* const tabs = window_->findChild<QTabWidget*>();
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            QApplication::processEvents();
            window_->refresh();
            take_picture(language + "_" + QString::number(i + 1));
            expect_nothing_cut_off();
            const auto* const pages = window_->findChild<QScrollArea*>("pages");
            EXPECT_EQ(pages->horizontalScrollBar()->maximum(), 0) << "page " << i + 1 << " is too wide";
        }
    }

    /// Labels and buttons have the room that their words need.
    void expect_nothing_cut_off() {
        for (const QAbstractButton* button : window_->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->text().isEmpty()) continue;
            EXPECT_GE(button->width(), button->minimumSizeHint().width())
                << button->objectName().toStdString() << ": " << button->text().toStdString();
        }
        for (const QLabel* label : window_->findChildren<QLabel*>()) {
            // Figures grow as one looks; their column does a moment later.
            const bool is_figure = label->objectName().startsWith("realtime_");
            if (!label->isVisible() || label->text().isEmpty() || label->wordWrap() || is_figure) continue;
            EXPECT_GE(label->width() + 1, label->minimumSizeHint().width())
                << label->objectName().toStdString() << ": " << label->text().toStdString();
        }
    }
};

TEST_P(Languages, FitTheSmallestScreen) {
    const QString code = QLatin1String(kLanguages[static_cast<std::size_t>(GetParam())].code);
    start_core();
    open_window();
    window_->resize(1280, 720);
    window_->open(QString::fromLatin1(PSICARVE_EXAMPLES) + "/small.stl");
    ASSERT_TRUE(comes_to(session::DeskState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::DeskState::job));
    EXPECT_LE(window_->minimumSizeHint().width(), 1280);
    EXPECT_LE(window_->minimumSizeHint().height(), 720);
    look_at_all_pages(code);
    // A model with longer figures.
    window_->open(QString::fromLatin1(PSICARVE_EXAMPLES) + "/figurine.stl");
    ASSERT_TRUE(comes_true([&] { return window_->bench().desk.path().ends_with("figurine.stl"); }));
    look_at_all_pages(code + "_owl");
}

TEST_P(Languages, HaveATextForAllThatTheWindowAsksFor) {
    if (GetParam() == Language::english) return;  // the texts themselves
    Listener listener{GetParam()};
    QCoreApplication::installTranslator(&listener);
    start_core();
    open_window();
    window_->open(QString::fromLatin1(PSICARVE_EXAMPLES) + "/small.stl");
    EXPECT_TRUE(comes_to(session::DeskState::model));
    EXPECT_TRUE(click("slice"));
    EXPECT_TRUE(comes_to(session::DeskState::job));
    EXPECT_TRUE(click("publish"));
    EXPECT_TRUE(click("home"));
    EXPECT_TRUE(comes_to(MachineState::ready));
    window_->emergency_stop();
    EXPECT_TRUE(comes_to(MachineState::alarm));
    look_at_all_pages("heard_" + QString::number(static_cast<int>(GetParam())));
    for (const profile_detail::KeySpec& key : profile_detail::key_table())
        (void)QCoreApplication::translate("profile", key.explanation.c_str());
    QCoreApplication::removeTranslator(&listener);
    for (const std::string& text : listener.missing) ADD_FAILURE() << "not translated: " << text;
}

TEST_P(Languages, HaveTheCoresWords) {
    if (GetParam() == Language::english) return;
    const auto in_own = [](const char* english) { return words(session::phrase("%1", english)); };
    for (std::uint32_t k = 0; k < kMachineStateCount; ++k) {
        const std::string name{name_of(static_cast<MachineState>(k))};
        EXPECT_NE(in_own(name.c_str()).toStdString(), name);
    }
    const session::Phrase refusal =
        session::refusal_phrase(session::phrase("Hold"), "hold: not while ready; start first");
    const QString said = words(refusal);
    for (const char* english : {"Hold", "not while", "ready", "start first"})
        EXPECT_FALSE(said.contains(english)) << said.toStdString();
    EXPECT_FALSE(words(session::error_phrase("a.stl: no such file")).contains("no such file"));
}

INSTANTIATE_TEST_SUITE_P(OfTheWindow, Languages,
                         ::testing::Values(Language::english, Language::chinese, Language::russian),
                         [](const auto& named) {
                             return kLanguages[static_cast<std::size_t>(named.param)].code;
                         });

class LanguageMenu : public WindowRig {};

TEST_F(LanguageMenu, IsRemembered) {
    open_window();
    auto* const menu = window_->findChild<QMenu*>("languages");
    ASSERT_NE(menu, nullptr);
    ASSERT_EQ(menu->actions().size(), 4);
    EXPECT_TRUE(menu->actions().front()->isChecked());
    menu->actions().back()->trigger();
    EXPECT_EQ(WindowSettings{}.language(), Language::russian);
    menu->actions().front()->trigger();
    EXPECT_EQ(WindowSettings{}.language(), std::nullopt);
}

}  // namespace
}  // namespace psicarve::ui
