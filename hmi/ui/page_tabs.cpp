// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/page_tabs.hpp"

#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "hmi/ui/carving_page.hpp"
#include "hmi/ui/entries_page.hpp"
#include "hmi/ui/layers_page.hpp"
#include "hmi/ui/messages_page.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/ports_page.hpp"
#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/program_page.hpp"
#include "hmi/ui/realtime_page.hpp"
#include "hmi/ui/tab_badge.hpp"

namespace psicarve::ui {
namespace {

/// In a small window pages may be larger than their room; their names stay where they are.
QScrollArea* scrolled(QWidget* page) {
    auto* room = new QScrollArea;
    room->setObjectName("pages");
    room->setWidgetResizable(true);
    room->setFrameShape(QFrame::NoFrame);
    room->setFocusPolicy(Qt::NoFocus);
    room->setWidget(page);
    page->setAutoFillBackground(false);  // the room has the theme's colour
    return room;
}

}  // namespace

PageTabs::PageTabs(WindowContext& context, Drawing drawing, std::function<void(const QString& path)> open,
                   QWidget* parent)
    : QTabWidget(parent),
      context_(context),
      model_(new ModelPage{context, drawing, open}),
      layers_(new LayersPage{context}),
      carving_(new CarvingPage{context, drawing}),
      ports_(new PortsPage{context}),
      realtime_(new RealtimePage{context}),
      messages_(new MessagesPage{context}),
      entries_(new EntriesPage{context}),
      messages_or_entries_(new QStackedWidget),
      profile_(new ProfilePage{context}),
      program_(new ProgramPage{context, std::move(open)}) {
    setObjectName("tabs");
    setDocumentMode(true);
    tabBar()->setDrawBase(false);
    messages_or_entries_->addWidget(messages_);
    messages_or_entries_->addWidget(entries_);
    add(model_, tr("Model"));
    add(layers_, tr("Layers"));
    add(carving_, tr("Carving"));
    add(ports_, tr("Ports"));
    add(realtime_, tr("Real time"));
    add(messages_or_entries_, tr("Messages"));
    add(profile_, tr("Profile"));
    add(program_, tr("Program"));
    setUsesScrollButtons(true);
}

void PageTabs::add(QWidget* page, const QString& name) {
    addTab(scrolled(page), name);
}

bool PageTabs::is_current(const QWidget& page) const {
    return currentWidget()->isAncestorOf(&page);
}

int PageTabs::tab_of(const QWidget& page) const {
    for (int i = 0; i < count(); ++i) {
        if (widget(i)->isAncestorOf(&page)) return i;
    }
    return -1;
}

void PageTabs::show_page(const QWidget& page) {
    setCurrentIndex(tab_of(page));
}

void PageTabs::show_entries(bool is_shown) {
    messages_or_entries_->setCurrentIndex(is_shown ? 1 : 0);
}

void PageTabs::set_theme(const Tokens& tokens) {
    model_->set_theme(tokens);
    layers_->set_theme(tokens);
    carving_->set_theme(tokens);
    ports_->set_theme(tokens);
    realtime_->set_theme(tokens);
    messages_->set_theme(tokens);
    profile_->set_theme(tokens);
    program_->set_theme(tokens);
    entries_->set_theme(tokens);
}

void PageTabs::refresh() {
    model_->refresh();
    layers_->refresh();
    carving_->refresh();
    ports_->refresh();
    realtime_->refresh();
    messages_->refresh();
    profile_->refresh();
    program_->refresh();
    show_badges();
}

bool PageTabs::is_quiet() const {
    return messages_->is_quiet() && realtime_->is_quiet();
}

void PageTabs::refresh_entries() {
    entries_->refresh();
}

void PageTabs::show_badges() {
    if (messages_->isVisible()) context_.read_messages = context_.log.count();
    std::size_t unread = 0;
    BadgeTone tone = BadgeTone::warning;
    const auto& all = context_.log.messages();
    const auto fresh = std::min<std::uint64_t>(context_.log.count() - context_.read_messages, all.size());
    for (auto i = all.size() - fresh; i < all.size(); ++i) {
        if (all[i].is_from_before) continue;
        unread += all[i].severity != session::Severity::info ? 1 : 0;
        if (all[i].severity == session::Severity::alarm) tone = BadgeTone::alarm;
    }
    set_tab_badge(*tabBar(), tab_of(*model_), model_->warning_count(), BadgeTone::warning);
    set_tab_badge(*tabBar(), tab_of(*messages_), unread, tone);
    set_tab_badge(*tabBar(), tab_of(*profile_), profile_->problem_count(), BadgeTone::alarm);
    set_tab_badge(*tabBar(), tab_of(*program_), program_->error_count(), BadgeTone::alarm);
}

}  // namespace psicarve::ui
