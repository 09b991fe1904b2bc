// SPDX-License-Identifier: GPL-3.0-or-later
// The window in each of its languages.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>

#include <csignal>
#include <set>
#include <string>
#include <vector>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/phrase/message_phrase.hpp"
#include "hmi/session/action_lock.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/language.hpp"
#include "hmi/ui/state_pill.hpp"
#include "hmi/ui/words.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/profile/profile_table.hpp"
#include "shared/profile/profile_text.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"
#include "tests/hmi/session/sights.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

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
            const auto* const pages = static_cast<const QScrollArea*>(tabs->currentWidget());
            EXPECT_EQ(pages->horizontalScrollBar()->maximum(), 0) << "page " << i + 1 << " is too wide";
        }
    }

    static constexpr int kFrameWidth = 10;
    static constexpr int kArrowWidth = 28;

    static void expect_room(const QWidget& field, const QString& text, int around) {
        if (!field.isVisible()) return;
        EXPECT_GE(field.width(), field.fontMetrics().horizontalAdvance(text) + around)
            << field.objectName().toStdString() << ": " << text.toStdString();
    }

    /// Labels and buttons have the room that their words need.
    void expect_nothing_cut_off() {
        for (const QAbstractButton* button : window_->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->text().isEmpty()) continue;
            EXPECT_GE(button->width(), button->minimumSizeHint().width())
                << button->objectName().toStdString() << ": " << button->text().toStdString();
        }
        for (const QComboBox* box : window_->findChildren<QComboBox*>())
            expect_room(*box, box->currentText(), kArrowWidth);
        for (const QAbstractSpinBox* box : window_->findChildren<QAbstractSpinBox*>())
            expect_room(*box, box->text(), kFrameWidth);
        for (const QLabel* label : window_->findChildren<QLabel*>()) {
            // Figures grow as one looks; their column does a moment later.
            const bool is_figure = label->objectName().startsWith("realtime_");
            if (!label->isVisible() || label->text().isEmpty() || label->wordWrap() || is_figure) continue;
            EXPECT_GE(label->width() + 1, label->minimumSizeHint().width())
                << label->objectName().toStdString() << ": " << label->text().toStdString();
        }
    }
};

// Every state with its second line, in the strip's usual and its smallest room.
TEST_P(Languages, SayEveryStateInFull) {
    constexpr std::uint32_t kMany = 4000;
    std::vector<session::MachineView> all{session::test::limit_alarm(Axis::psi), session::MachineView{}};
    for (std::uint32_t k = 0; k < kMachineStateCount; ++k) {
        for (const std::uint8_t is_dry : {std::uint8_t{0}, std::uint8_t{1}}) {
            all.push_back(session::test::machine_in(static_cast<MachineState>(k)));
            all.back().status->is_dry = is_dry;
            all.back().status->layer = kMany - 1;
        }
    }
    for (std::uint32_t k = 0; k < kAlarmCauseCount; ++k) {
        all.push_back(session::test::machine_in(MachineState::alarm));
        all.back().status->alarm_cause = static_cast<AlarmCause>(k);
    }
    StatePill sut;
    sut.setStyleSheet(style_sheet(tokens_of(Theme::light)));
    for (const Room room : {Room::usual, Room::small}) {
        sut.set_room(room);
        for (const session::MachineView& machine_view : all) {
            sut.show_state(session::state_text(machine_view, kMany), Glyph::info, tokens_of(Theme::light));
            EXPECT_FALSE(sut.is_cut_off()) << sut.accessibleName().toStdString() << ", " << sut.width();
        }
    }
}

// How late ticks are stands beside the state for as long as the window is open.
TEST_P(Languages, KeepRoomForTheLargestFiguresOfTheTick) {
    start_core();
    open_window();
    window_->resize(1280, 720);
    QApplication::processEvents();
    const auto in_own = [](const char* english, const char* value) {
        return words(session::phrase(english, value));
    };
    auto& tick = part<QLabel>("tick_text");
    const QString longest = in_own("tick %1 µs", "1\u2009000") + " · " + in_own("p99 %1", "999 µs");
    EXPECT_GE(tick.width(), tick.fontMetrics().horizontalAdvance(longest)) << longest.toStdString();
    const QString missed = in_own("missed %1", "999\u2009999\u2009999");
    EXPECT_GE(tick.width(), tick.fontMetrics().horizontalAdvance(missed)) << missed.toStdString();
}

// The longest there is: about so many hours, and when they end. What has no room is in the tip.
TEST_P(Languages, TellTheTimeLeftOfALongJobOnTheSmallestScreen) {
    start_core();
    open_window();
    window_->resize(1280, 720);
    ASSERT_TRUE(comes_to(MachineState::off));
    core_->send_signal(SIGSTOP);  // its words are ours
    const double left_s = 3600.0 * 23 + 60.0 * 58 + 48;
    auto& record = segment_->header().status;
    CoreStatus status = load_words<CoreStatus>(record.words);
    status.state = MachineState::carving;
    status.is_virtual_clock = 0;
    status.points_done = 1000;
    status.points_total = 4'000'000;
    status.seconds_left = left_s;
    status.is_left_forecast = 1;
    const QString left = words(session::phrase("about %1 left", session::clock_text(left_s)));
    const auto& time = part<QLabel>("time_left");
    ASSERT_TRUE(comes_true([&] {
        ++status.heartbeat;
        write_record(record, status);
        return time.text().startsWith(left);
    })) << time.text().toStdString();
    const QString all = time.toolTip().isEmpty() ? time.text() : time.toolTip();
    EXPECT_TRUE(all.startsWith(left + " · ")) << all.toStdString();
    EXPECT_FALSE(all.endsWith(QStringLiteral("…"))) << all.toStdString();
    EXPECT_TRUE(comes_true([&] { return time.fontMetrics().horizontalAdvance(time.text()) <= time.width(); }))
        << time.text().toStdString() << ", " << time.width();
    take_picture("time_left_" + QString::number(static_cast<int>(GetParam())));
    expect_nothing_cut_off();
}

// What is told of it stands under the view, beside warnings and a form with all a tool's fields.
TEST_P(Languages, TellWhatTheToolWillLeave) {
    open_window();
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model)) << all_messages().toStdString();
    part<QComboBox>("tool").setCurrentIndex(4);
    ASSERT_TRUE(click("view_piece"));
    const auto& facts = part<QLabel>("piece_facts");
    ASSERT_TRUE(comes_true([&] { return facts.text().count('\n') >= 2; })) << facts.text().toStdString();
    ASSERT_TRUE(click("model_report_open"));
    const auto& report = part<QDialog>("model_report");
    const auto told = [&] {
        for (const QLabel* label : report.findChildren<QLabel*>())
            if (label->text().contains(QStringLiteral("…"))) return false;
        return true;
    };
    ASSERT_TRUE(comes_true(told));
    const QString code = QLatin1String(kLanguages[static_cast<std::size_t>(GetParam())].code);
    take_picture("expected_piece_" + code);
    test::keep_picture(part<QDialog>("model_report"), "model_report_" + code);
    expect_nothing_cut_off();
    EXPECT_GE(facts.height(), facts.heightForWidth(facts.width()));
    for (const QLabel* label : report.findChildren<QLabel*>()) {
        if (!label->isVisible() || !label->wordWrap()) continue;
        EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
    }
}

// The profile's parts, and the words between its bounds.
TEST_P(Languages, NameThePartsOfTheProfile) {
    open_window();
    window_->findChild<QTabWidget*>()->setCurrentIndex(6);
    const auto& groups = part<QListWidget>("profile_groups");
    std::set<std::string> tables;
    for (const ProfileKey& key : profile_keys()) tables.insert(std::string{table_of_key(key.path)});
    EXPECT_EQ(static_cast<int>(tables.size()), groups.count());
    for (int i = 0; i < groups.count(); ++i)
        EXPECT_FALSE(tables.contains(groups.item(i)->text().toStdString())) << "a table's name is no title";
    if (GetParam() == Language::english) return;
    for (int i = 0; i < groups.count(); ++i) {
        part<QListWidget>("profile_groups").setCurrentRow(i);
        QApplication::processEvents();
        for (const QLabel* label : window_->findChildren<QLabel*>()) {
            for (const char* english : {" bytes", " or "})
                EXPECT_FALSE(label->text().contains(english)) << label->text().toStdString();
        }
    }
}

TEST_P(Languages, FitTheSmallestScreen) {
    const QString code = QLatin1String(kLanguages[static_cast<std::size_t>(GetParam())].code);
    start_core();
    open_window();
    window_->resize(1280, 720);
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    EXPECT_LE(window_->minimumSizeHint().width(), 1280);
    EXPECT_LE(window_->minimumSizeHint().height(), 720);
    look_at_all_pages(code);
    // Page Model with all that may be asked of a mesh.
    window_->findChild<QTabWidget*>()->setCurrentIndex(0);
    part<QComboBox>("axis_at").setCurrentIndex(3);
    part<QComboBox>("tool").setCurrentIndex(4);
    part<QDoubleSpinBox>("blank_radius").setValue(10.0);
    part<QComboBox>("roughing").setCurrentIndex(1);
    QApplication::processEvents();
    const auto& room = part<QScrollArea>("model_fields");
    EXPECT_LE(room.widget()->minimumSizeHint().width(), room.viewport()->width()) << "nothing is cut off";
    EXPECT_GT(room.viewport()->height(), 250) << "and the fields have room beside the picture";
    room.verticalScrollBar()->setValue(room.verticalScrollBar()->maximum());
    take_picture(code + "_passes");
    // A model with longer figures.
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_true([&] { return window_->context().open_job.path().ends_with("figurine.stl"); }));
    look_at_all_pages(code + "_owl");
}

TEST_P(Languages, HaveATextForAllThatTheWindowAsksFor) {
    if (GetParam() == Language::english) return;  // the texts themselves
    Listener listener{GetParam()};
    QCoreApplication::installTranslator(&listener);
    start_core();
    open_window();
    window_->open(QString::fromStdString(example("small.stl")));
    EXPECT_TRUE(comes_to(session::OpenJobState::model));
    EXPECT_TRUE(click("slice"));
    EXPECT_TRUE(comes_to(session::OpenJobState::job));
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

// Speeds and pulses grow between two layouts; a label that was as wide as its text then cuts it off.
TEST_P(Languages, KeepRoomForTheLargestFigures) {
    start_core();
    open_window();
    window_->resize(1280, 720);
    window_->findChild<QTabWidget*>()->setCurrentIndex(2);
    QApplication::processEvents();
    const std::pair<const char*, const char*> largest[] = {
        {"axis_pulses_", "9\u2009999\u2009999\u2009999"},
        {"axis_speed_", "1\u2009999.9 mm/s"},
        {"axis_share_", "100 %"},
        {"axis_left_", "9\u2009999\u2009999\u2009999"},
    };
    for (const auto& [name, text] : largest) {
        for (const Axis axis : kAllAxes) {
            auto& label = part<QLabel>((name + std::string{name_of(axis)}).c_str());
            ASSERT_TRUE(label.isVisible());
            EXPECT_GE(label.width(), label.fontMetrics().horizontalAdvance(QString::fromUtf8(text)))
                << label.objectName().toStdString();
        }
    }
}

TEST_P(Languages, HaveTheCoresWords) {
    if (GetParam() == Language::english) return;
    const auto in_own = [](const char* english) { return words(session::phrase("%1", english)); };
    for (std::uint32_t k = 0; k < kMachineStateCount; ++k) {
        const std::string name{name_of(static_cast<MachineState>(k))};
        EXPECT_NE(in_own(name.c_str()).toStdString(), name);
    }
    const psicarve::Message refused =
        message_of(MessageId::wrong_state, argument_of(CommandKind::hold), argument_of(MachineState::ready),
                   way_out_of(MachineState::ready));
    const session::Phrase refusal =
        session::refusal_phrase(session::phrase("Hold"), error_from(ErrorCode::machine_refused, refused));
    const QString said = words(refusal);
    for (const char* english : {"Hold", "not while", "ready", "start first"})
        EXPECT_FALSE(said.contains(english)) << said.toStdString();
    if (GetParam() == Language::chinese) {
        EXPECT_TRUE(said.contains(QStringLiteral("：")) && !said.contains(':')) << said.toStdString();
    }
    EXPECT_FALSE(words(session::error_phrase("a.stl: no such file")).contains("no such file"));
}

/// Sanitizers see no more in a second catalogue, and the other tests are in English.
std::vector<Language> languages_looked_at() {
    if (psicarve::test::kIsSanitized) return {Language::russian};
    return {Language::english, Language::chinese, Language::russian};
}

INSTANTIATE_TEST_SUITE_P(OfTheWindow, Languages, ::testing::ValuesIn(languages_looked_at()),
                         [](const auto& named) {
                             return kLanguages[static_cast<std::size_t>(named.param)].code;
                         });

class LanguageMenu : public WindowRig {};

TEST_F(LanguageMenu, IsRemembered) {
    open_window();
    // Made anew with each language.
    const auto entries = [this] { return part<QMenu>("languages").actions(); };
    ASSERT_EQ(entries().size(), 4);
    EXPECT_TRUE(entries().front()->isChecked());
    entries().back()->trigger();
    EXPECT_TRUE(comes_true([] { return test::KeptSettings{}.language() == Language::russian; }));
    EXPECT_TRUE(comes_true([] { return used_language() == Language::russian; }));
    entries().front()->trigger();
    EXPECT_TRUE(comes_true([] { return test::KeptSettings{}.language() == std::nullopt; }));
}

}  // namespace
}  // namespace psicarve::ui
