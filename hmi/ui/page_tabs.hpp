// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTabWidget>

#include <cstdint>
#include <functional>

#include "hmi/ui/space_canvas.hpp"
#include "hmi/ui/window_context.hpp"

class QStackedWidget;

namespace psicarve::ui {

class CarvingPage;
class EntriesPage;
class LayersPage;
class MessagesPage;
class ModelPage;
class PortsPage;
class ProfilePage;
class ProgramPage;
class RealtimePage;
struct Tokens;

/// The window's pages, one a tab, and how many things on them are to be looked at.
class PageTabs : public QTabWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PageTabs)
public:
    /// `open`: a file, as every one is opened.
    PageTabs(WindowContext& context, Drawing drawing, std::function<void(const QString& path)> open,
             QWidget* parent = nullptr);

    ModelPage& model() const noexcept { return *model_; }
    LayersPage& layers() const noexcept { return *layers_; }
    CarvingPage& carving() const noexcept { return *carving_; }
    PortsPage& ports() const noexcept { return *ports_; }
    RealtimePage& realtime() const noexcept { return *realtime_; }
    ProfilePage& profile() const noexcept { return *profile_; }
    ProgramPage& program() const noexcept { return *program_; }
    bool is_current(const QWidget& page) const;
    void show_page(const QWidget& page);
    /// A recording's entries in the place of the window's messages.
    void show_entries(bool is_shown);
    void set_theme(const Tokens& tokens);
    /// But for the entries, whose recording is looked at first.
    void refresh();
    void refresh_entries();
    /// No thread of theirs has anything to tell them.
    bool is_quiet() const;

private:
    void add(QWidget* page, const QString& name);
    int tab_of(const QWidget& page) const;
    void show_badges();

    WindowContext& context_;
    ModelPage* model_;
    LayersPage* layers_;
    CarvingPage* carving_;
    PortsPage* ports_;
    RealtimePage* realtime_;
    MessagesPage* messages_;
    EntriesPage* entries_;
    QStackedWidget* messages_or_entries_;
    ProfilePage* profile_;
    ProgramPage* program_;
};

}  // namespace psicarve::ui
