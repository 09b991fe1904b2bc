// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/message_pane.hpp"

#include <QGridLayout>
#include <QLabel>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

/// One at a time, of this window's user: the next takes its place.
constexpr const char* kRecorderFile = "/alarm.psi";

std::optional<session::Phrase> recorder_lock(const Bench& bench,
                                             const std::optional<session::AlarmPlace>& place) {
    if (!place) return session::phrase("Only an alarm has a place in the flight recorder");
    if (place->core_pid != bench.machine.sight().core_pid)
        return session::phrase("Its core is gone, and its flight recorder with it");
    if (bench.replay.is_opening()) return session::phrase("A recording is being opened");
    if (bench.keeper.folder().empty()) return session::phrase("This user has no folder to keep it in");
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

MessagePane::MessagePane(Bench& bench, QWidget* parent)
    : QFrame(parent),
      bench_(bench),
      title_(role_label("title")),
      when_(role_label("label")),
      cause_(plain_label()),
      steps_(plain_label()),
      recorder_(new ActionButton{[this](const Bench& now) { return recorder_lock(now, place_); },
                                 tr("Show in the flight recorder"), [this] { show_recorder(); }}) {
    setObjectName("message_pane");
    setProperty("dock", true);
    title_->setObjectName("message_title");
    when_->setObjectName("message_when");
    cause_->setObjectName("message_cause");
    steps_->setObjectName("message_steps");
    recorder_->setObjectName("message_recorder");
    recorder_->set_hint(
        tr("Opens what the core has recorded, at the moment of this alarm; it moves nothing"));
    for (QLabel* label : {title_, when_, cause_, steps_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setFocusPolicy(Qt::NoFocus);
    }
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    grid->setSpacing(kSmallGap);
    grid->setColumnStretch(0, 1);
    grid->addWidget(title_, 0, 0);
    grid->addWidget(recorder_, 0, 1, Qt::AlignTop);
    grid->addWidget(when_, 1, 0, 1, 2);
    grid->addWidget(cause_, 2, 0, 1, 2);
    grid->addWidget(steps_, 3, 0, 1, 2);
    hide();
}

void MessagePane::show_message(const session::Message* message, const QString& kind) {
    setHidden(message == nullptr);
    place_.reset();
    if (message == nullptr) return;
    place_ = message->place;
    const bool has_time = message->time != decltype(message->time){};
    QStringList facts{kind};
    facts.prepend(has_time ? local_time(message->time, "yyyy-MM-dd HH:mm:ss.zzz") : tr("time not known"));
    if (!message->axes.empty()) facts << tr("axis %1").arg(QString::fromStdString(message->axes));
    show_or_hide(*title_, words(message->what));
    show_or_hide(*when_, facts.join(QStringLiteral(" \u00B7 ")));
    show_or_hide(*cause_, words(message->cause));
    show_or_hide(*steps_, steps_of(*message));
    recorder_->setVisible(place_.has_value());
    refresh();
}

void MessagePane::refresh() {
    if (place_) recorder_->refresh(bench_);
}

void MessagePane::show_recorder() {
    if (recorder_lock(bench_, place_)) return;
    const std::string path = bench_.keeper.folder() + kRecorderFile;
    bench_.files.take_recorder(path, [this, path, tick = place_->tick] {
        bench_.replay.open_at(path, bench_.machine_profile(), tick);
    });
}

}  // namespace psicarve::ui
