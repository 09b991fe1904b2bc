// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/message_pane.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

/// One at a time for each machine, of this window's user: the next takes its place.
std::string recorder_file(const WindowContext& context) {
    std::string machine = context.machine.options().segment_name;
    std::ranges::replace(machine, '/', '_');
    return context.keeper.folder() + "/alarm-" + machine + ".psi";
}

/// A recording takes Hold and Stop away: not from a machine that moves, or may go on by itself.
bool is_under_way(const session::MachineView& machine) {
    return machine.is_heard() && (!is_at_rest(machine.state()) || runs_job(machine.state()));
}

std::optional<session::Phrase> recorder_lock(const WindowContext& context,
                                             const std::optional<session::AlarmPlace>& place) {
    if (!place) return session::phrase("Only an alarm has a place in the flight recorder");
    if (place->core_pid == 0 || place->core_pid != context.machine.view().core_pid)
        return session::phrase("Its core is gone, and its flight recorder with it");
    if (is_under_way(context.machine.view()))
        return session::phrase("The machine is under way; at rest, without a job that waits or is held");
    if (context.replay.is_opening()) return session::phrase("A recording is being opened");
    if (context.keeper.folder().empty()) return session::phrase("This user has no folder to keep it in");
    return std::nullopt;
}

QString steps_of(const session::Message& message) {
    if (message.steps.empty()) return words(message.remedy);
    QStringList lines;
    for (std::size_t i = 0; i < message.steps.size(); ++i)
        lines << QStringLiteral("%1. %2").arg(i + 1).arg(words(message.steps[i]));
    return lines.join('\n');
}

void show_or_hide(QLabel& label, const QString& text) {
    const QString shown = breakable(text);
    if (label.text() != shown) label.setText(shown);
    label.setHidden(shown.isEmpty());
}

}  // namespace

MessagePane::MessagePane(WindowContext& context, QWidget* parent)
    : QFrame(parent),
      context_(context),
      note_(role_label("label")),
      title_(role_label("title")),
      when_(role_label("label")),
      cause_(plain_label()),
      steps_(plain_label()),
      recorder_(new ActionButton{[this](const WindowContext& /*context*/) { return lock(); },
                                 tr("Show in the flight recorder"), [this] { show_recorder(); }}) {
    setObjectName("message_pane");
    setProperty("dock", true);
    note_->setObjectName("message_note");
    title_->setObjectName("message_title");
    when_->setObjectName("message_when");
    cause_->setObjectName("message_cause");
    steps_->setObjectName("message_steps");
    recorder_->setObjectName("message_recorder");
    recorder_->set_hint(
        tr("Opens what the core has recorded, at the moment of this alarm; it moves nothing"));
    make_parts();
    show_message(nullptr, {});
}

void MessagePane::make_parts() {
    auto* text = new QWidget;
    auto* lines = new QVBoxLayout{text};
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(kSmallGap);
    for (QLabel* label : {note_, title_, when_, cause_, steps_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setFocusPolicy(Qt::NoFocus);
        lines->addWidget(label);
    }
    lines->addStretch();
    auto* room = new QScrollArea;
    room->setObjectName("message_room");
    room->setWidgetResizable(true);
    room->setFrameShape(QFrame::NoFrame);
    room->setFocusPolicy(Qt::NoFocus);
    room->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    room->setMinimumHeight(0);
    room->setWidget(text);
    text->setAutoFillBackground(false);  // the pane has the theme's colour
    room->viewport()->setAutoFillBackground(false);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    row->addWidget(room, 1);
    row->addWidget(recorder_, 0, Qt::AlignTop);
}

void MessagePane::show_message(const session::Message* message, const QString& kind) {
    const auto place = message == nullptr ? std::nullopt : message->place;
    if (!place || !place_ || place->tick != place_->tick) note_->hide();
    place_ = place;
    if (message == nullptr) {
        show_or_hide(*title_, {});
        show_or_hide(*when_, tr("A message that is selected above stands here in full."));
        show_or_hide(*cause_, {});
        show_or_hide(*steps_, {});
        return refresh();
    }
    const bool has_time = message->time != decltype(message->time){};
    QStringList facts{kind};
    facts.prepend(has_time ? local_time(message->time, "yyyy-MM-dd HH:mm:ss.zzz") : tr("time not known"));
    if (!message->axes.empty()) facts << tr("axis %1").arg(QString::fromStdString(message->axes));
    if (message->journal) {
        facts << (message->journal->is_simulator ? tr("journal of the simulator, run %1")
                                                 : tr("journal of the machine, run %1"))
                     .arg(message->journal->run);
    }
    show_or_hide(*title_, words(message->what));
    show_or_hide(*when_, facts.join(QStringLiteral(" \u00B7 ")));
    show_or_hide(*cause_, words(message->cause));
    show_or_hide(*steps_, steps_of(*message));
    refresh();
}

std::optional<session::Phrase> MessagePane::lock() const {
    if (is_saving_) return session::phrase("The flight recorder is being saved");
    return recorder_lock(context_, place_);
}

void MessagePane::refresh() {
    const QString text = is_saving_ ? tr("Saving…") : tr("Show in the flight recorder");
    if (recorder_->text() != text) recorder_->setText(text);
    recorder_->refresh(context_);
}

void MessagePane::show_recorder() {
    if (lock()) return;
    const std::string path = recorder_file(context_);
    is_saving_ = true;
    note_->hide();
    context_.files.take_recorder(
        path, [this, path, tick = place_->tick] { open_recorder(path, tick); },
        [this](const session::Phrase& why) {
            is_saving_ = false;
            show_or_hide(*note_, words(why));
        });
    refresh();
}

/// Meanwhile something may have been started.
void MessagePane::open_recorder(const std::string& path, std::uint64_t tick) {
    is_saving_ = false;
    if (!is_under_way(context_.machine.view()))
        return context_.replay.open_at(path, context_.machine_profile(), tick);
    const auto told = session::phrase("Saved as %1; open it once the machine is at rest", path);
    context_.log.add(session::Severity::info, told);
    show_or_hide(*note_, words(told));
}

}  // namespace psicarve::ui
