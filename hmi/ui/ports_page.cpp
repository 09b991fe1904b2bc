// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/ports_page.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/connector_view.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/timing_view.hpp"
#include "hmi/ui/wiring_bar.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

enum PinColumn { kPin, kSignal, kRegister, kWay, kLevel, kPinColumns };
constexpr std::array<int, kPinColumns> kWidths{34, 122, 96, 50, 84};
constexpr int kMostRowHeight_px = 22;
constexpr int kLeastRowHeight_px = 16;
constexpr int kHeadHeight_px = 24;

}  // namespace

PortsPage::PortsPage(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      connector_(new ConnectorView),
      table_(new QTableWidget{0, kPinColumns}),
      timing_(new TimingView),
      note_(role_label("small")),
      wiring_(new WiringBar{context}) {
    setObjectName("ports_page");
    core_pid_ = context.machine.view().core_pid;
    table_->setObjectName("pins");
    table_->setHorizontalHeaderLabels({tr("Pin"), tr("Signal"), tr("Register bit"), {}, tr("Level")});
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setMinimumSectionSize(kLeastRowHeight_px);
    table_->horizontalHeader()->setFixedHeight(kHeadHeight_px);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setShowGrid(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    note_->setWordWrap(true);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addWidget(table_);
    middle->addWidget(timing_, 1);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kGap);
    all->addWidget(connector_);
    all->addLayout(middle, 1);
    make_record_button();
    auto* foot = new QHBoxLayout;
    foot->addWidget(note_, 1);
    foot->addWidget(record_);
    all->addLayout(foot);
    all->addWidget(wiring_);
    take_profile(Profile{});
}

void PortsPage::make_record_button() {
    record_ =
        new ActionButton{[](const WindowContext& now) {
                             return session::record_lock(
                                 now.machine.view(), now.open_job.core_job() != nullptr, now.pins.state());
                         },
                         tr("Record pins…"), [this] { change_recording(); }};
    record_->setObjectName("record_pins");
    record_->setProperty("small", true);
    record_->set_hint(
        tr("Every edge of every pin into a file, from here on; a job that is carved whole meanwhile is "
           "verified"));
}

void PortsPage::change_recording() {
    if (context_.pins.state() != session::PinRecorder::State::idle) return context_.pins.end();
    const QString path =
        ask_where_to_save(this, tr("Record pins"), "run.trace", tr("Traces (*.trace *.vcd);;All files (*)"));
    if (!path.isEmpty()) record_to(path);
}

void PortsPage::record_to(const QString& path) {
    context_.pins.begin(path.toStdString(), context_.open_job.core_job());
}

void PortsPage::refresh_record_button() {
    const auto state = context_.pins.state();
    const bool is_on =
        state == session::PinRecorder::State::recording || state == session::PinRecorder::State::starting;
    const QString text = is_on ? tr("Stop recording") : tr("Record pins…");
    if (record_->text() != text) record_->setText(text);
    record_->refresh(context_);
}

void PortsPage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    connector_->set_theme(tokens);
    timing_->set_theme(tokens);
    wiring_->set_theme(tokens);
    shown_levels_.reset();
    refresh();
}

void PortsPage::take_profile(const Profile& profile) {
    if (profile_ && profile_->port == profile.port) return;
    profile_ = profile;
    rows_ = session::pin_rows(profile);
    connector_->show_rows(rows_);
    wiring_->show_rows(rows_);
    row_height_px_ = 0;
    fill_table();
}

// All signals are in view, whatever else the page has to show.
void PortsPage::fit_rows() {
    const int room_px = table_->viewport()->height() / std::max(1, table_->rowCount());
    const int height_px = std::clamp(room_px, kLeastRowHeight_px, kMostRowHeight_px);
    if (height_px == row_height_px_) return;
    row_height_px_ = height_px;
    fit_columns();
    table_->verticalHeader()->setDefaultSectionSize(height_px);
    std::vector<Signal> order;
    order.reserve(rows_.size());
    for (const session::PinRow& row : rows_) order.push_back(row.signal);
    timing_->set_rows(std::move(order), kHeadHeight_px + 1, height_px);
}

void PortsPage::fill_table() {
    table_->setRowCount(static_cast<int>(rows_.size()));
    for (int i = 0; i < table_->rowCount(); ++i) {
        const session::PinRow& row = rows_[static_cast<std::size_t>(i)];
        const QString pin = row.pin == 0 ? QStringLiteral("\u2013")
                                         : (row.is_active_low ? QStringLiteral("\u2212") : QString{}) +
                                               QString::number(row.pin);
        const QString texts[kPinColumns] = {pin,
                                            words(row.name),
                                            QString::fromStdString(row.register_bit),
                                            is_output(row.signal) ? tr("out") : tr("in"),
                                            {}};
        for (int column = 0; column < kPinColumns; ++column)
            table_->setItem(i, column, new QTableWidgetItem{texts[column]});
        table_->item(i, kPin)->setToolTip(row.is_active_low ? tr("Active low") : QString{});
    }
    shown_levels_.reset();
}

/// As wide as their words are in this language.
void PortsPage::fit_columns() {
    int width = 2;
    for (int column = 0; column < kPinColumns; ++column) {
        const int head = table_->horizontalHeader()->sectionSizeHint(column);
        const int cells = static_cast<const QAbstractItemView&>(*table_).sizeHintForColumn(column);
        table_->setColumnWidth(column, std::max({kWidths[static_cast<std::size_t>(column)], head, cells}));
        width += table_->columnWidth(column);
    }
    table_->setFixedWidth(width);
}

void PortsPage::show_levels(SignalWord levels) {
    connector_->show_levels(levels);
    if (tokens_ == nullptr || shown_levels_ == levels) return;
    for (int i = 0; i < table_->rowCount(); ++i) {
        const session::PinRow& row = rows_[static_cast<std::size_t>(i)];
        const bool is_high = (levels & bit_of(row.signal)) != 0;
        QTableWidgetItem* item = table_->item(i, kLevel);
        item->setText(row.pin == 0 ? tr("no pin")
                      : is_high    ? QStringLiteral("\u25A0 ") + tr("high")
                                   : QStringLiteral("\u25A1 ") + tr("low"));
        QFont font = item->font();
        font.setBold(is_high);
        item->setFont(font);
        item->setForeground(row.pin == 0 ? tokens_->dis : is_high ? tokens_->text : tokens_->text2);
    }
    shown_levels_ = levels;
}

void PortsPage::let_go() {
    wiring_->let_go();
}

void PortsPage::note_live_levels() {
    const auto& view = context_.machine.view();
    if (view.core_pid != core_pid_) context_.levels.forget();
    core_pid_ = view.core_pid;
    if (view.status && view.is_heard())
        context_.levels.note(*view.status, session::LevelHistory::Clock::now());
}

void PortsPage::show_recording() {
    const auto& view = context_.replay.view();
    if (view.profile) take_profile(*view.profile);
    fit_rows();
    note_->setVisible(true);
    show_levels(view.status ? view.status->signals : 0);
    timing_->show_history(context_.replay.history(),
                          replay::PinLooks::time_point(context_.replay.shown().time_ns));
    const QString note = context_.replay.facts().knows_every_pulse
                             ? tr("Recorded levels of the 20 seconds before this moment.")
                             : tr("Recorded levels at the entries of the flight recorder. Steps are not in a "
                                  "snapshot.");
    if (note_->text() != note) note_->setText(note);
}

void PortsPage::refresh() {
    wiring_->refresh();
    context_.replay.want_looks(isVisible());
    note_live_levels();
    if (!isVisible()) return;
    // A recording's timeline takes the room of the connector.
    const bool is_replay = context_.replay.is_open();
    record_->setVisible(!is_replay && !wiring_->is_armed());
    refresh_record_button();
    connector_->setVisible(!is_replay);
    wiring_->setVisible(!is_replay);
    if (is_replay) return show_recording();
    const auto& view = context_.machine.view();
    // A job's profile may have other pins.
    const bool knows_pins = view.profile && !view.is_profile_of_job;
    if (knows_pins) take_profile(*view.profile);
    fit_rows();
    note_->setVisible(!wiring_->is_armed());
    show_levels(view.status ? view.status->signals : 0);
    timing_->show_history(context_.levels, session::LevelHistory::Clock::now());
    const QString note =
        !view.is_heard() ? tr("No core: these are the last levels known.")
        : knows_pins
            ? tr("Logical levels, looked at 30 times a second; steps by how many there were in between. "
                 "A recording holds every edge.")
            : tr("The machine's profile is not known here: pins are those of the built-in profile.");
    if (note_->text() != note) note_->setText(note);
}

}  // namespace psicarve::ui
