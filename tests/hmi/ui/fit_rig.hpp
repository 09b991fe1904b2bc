// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QStackedWidget>
#include <QSysInfo>
#include <QTabBar>
#include <QTabWidget>
#include <QVariantMap>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "hmi/session/going_on.hpp"
#include "hmi/session/saved_piece.hpp"
#include "hmi/ui/keys_dialog.hpp"
#include "hmi/ui/language.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/words.hpp"
#include "hmi/ui/work_keeper.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/ui/fit_audit.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::ui {

using test::WindowRig;

inline constexpr QSize kUsualScreen{1280, 690};  // less a desktop's bar
inline constexpr QSize kScaledScreen{960, 515};
inline constexpr QSize kLeastScreen{640, 360};
inline constexpr const char* kLongName =
    "a_name_without_a_space_as_programs_for_drawing_make_them_by_themselves_1234.stl";

/// Every screen. Where a sanitizer looks on, which counts no pixels, the window as it is arranged where room
/// is short: as it usually is all others of its tests have it.
inline std::vector<QSize> screens_looked_at() {
    if (psicarve::test::kIsSanitized) return {kLeastScreen};
    return {kUsualScreen, kScaledScreen, kLeastScreen};
}

/// A window in a language, in which nothing may be cut off on any screen. One window goes from screen to
/// screen, there and back, with whatever it shows.
class Fit : public WindowRig, public ::testing::WithParamInterface<Language> {
protected:
    Fit() { use_language(language()); }
    ~Fit() override { use_language(Language::english); }

    static Language language() { return GetParam(); }
    static QString code() { return QLatin1String(kLanguages[static_cast<std::size_t>(language())].code); }
    QSize size() const { return screens_.front(); }

    void open_small() {
        start_core();
        open_on_screen();
        settle();
    }
    void open_on_screen() {
        open_window();
        window_->resize(size());
    }
    /// What was written anew takes its room with the second look; where that scrolls, the room round it with
    /// the fourth.
    void settle() {
        for (int look = 0; look < 5; ++look) {
            window_->refresh();
            QApplication::processEvents();
        }
        // A figure may have grown since.
        QApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
    /// On that where the window is first: to stay costs nothing.
    template <typename Look>
    void on_each_screen(Look look) {
        const std::vector<QSize> way = screens_;
        for (const QSize& screen : way) {
            screens_.front() = screen;
            window_->resize(screen);
            ASSERT_NO_FATAL_FAILURE(look());
        }
        screens_.assign(way.rbegin(), way.rend());
    }
    /// 1280 x 720 at 200 % is half of what the window is made for: names of pages go on behind arrows there,
    /// and drawn views and tables beside each other are wider.
    bool is_excused(const std::string& misfit) const {
        if (size() != kLeastScreen) return false;
        for (const char* what :
             {"tabs/QTabBar: tab out of sight", "ports_page", "layers_page", "messages: column"})
            if (misfit.find(what) != std::string::npos) return true;
        return false;
    }
    void look_here(const QString& where) {
        settle();
        EXPECT_EQ(window_->size(), size()) << where.toStdString();
        for (const std::string& misfit : test::misfits(*window_)) {
            if (!is_excused(misfit) && seen_.insert(misfit).second)
                ADD_FAILURE() << where.toStdString() << ", " << size().width() << ": " << misfit;
        }
        take_picture(QString{"fit_%1_%2_%3"}.arg(code(), QString::number(size().width()), where));
    }
    /// Position, Jog and Job, where they are pages of one column.
    void look_at_panels_here(const QString& where) {
        settle();
        look_at_panels_but(-1, where);
    }
    /// Where the window has just been looked at with one of them.
    void look_at_other_panels_here(const QString& where) {
        look_at_panels_but(part<QTabBar>("side_names").currentIndex(), where);
    }
    void expect_fit(const QString& where) {
        on_each_screen([&] { look_here(where); });
    }
    void expect_panels_fit(const QString& where) {
        on_each_screen([&] { look_at_panels_here(where); });
    }
    /// On one walk over the screens: each takes as long as many looks, for every widget is styled anew.
    void expect_with_panels_fit(const QString& where) {
        on_each_screen([&] {
            look_here(where);
            look_at_other_panels_here(where);
        });
    }
    void expect_pages_and_panels_fit(const QString& where) {
        on_each_screen([&] {
            auto& tabs = part<QTabWidget>("tabs");
            for (int i = 0; i < tabs.count(); ++i) {
                tabs.setCurrentIndex(i);
                look_here(where + "_" + QString::number(i + 1));
            }
            look_at_other_panels_here(where);
        });
    }
    void start_core_anew() {
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
        start_core();
    }
    void open_example(const char* name, session::OpenJobState state = session::OpenJobState::model) {
        window_->open(QString::fromStdString(example("")) + name);
        ASSERT_TRUE(comes_to(state));
    }

private:
    void look_at_panels_but(int seen, const QString& where) {
        auto& names = part<QTabBar>("side_names");
        if (!names.isVisible()) return;
        for (int i = 0; i < names.count(); ++i) {
            if (i == seen) continue;
            names.setCurrentIndex(i);
            look_here(where + "_panel_" + QString::number(i + 1));
        }
        names.setCurrentIndex(0);
    }

    std::vector<QSize> screens_ = screens_looked_at();  ///< the window is on the first
    std::set<std::string> seen_;
};

}  // namespace psicarve::ui
