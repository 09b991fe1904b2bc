// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/message_model.hpp"

#include <QDate>
#include <QDateTime>

#include <algorithm>
#include <utility>

#include "hmi/ui/icon.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::Severity;

Glyph glyph_of(Severity severity) {
    if (severity == Severity::alarm) return Glyph::octagon;
    return severity == Severity::warning ? Glyph::triangle : Glyph::info;
}

MessageFilter::Kind kind_of(const session::Message& message) {
    if (message.severity == Severity::alarm) return MessageFilter::Kind::alarms;
    if (message.severity == Severity::warning) return MessageFilter::Kind::warnings;
    return message.is_command ? MessageFilter::Kind::commands : MessageFilter::Kind::information;
}

bool is_known(const session::Message& message) {
    return message.time != decltype(message.time){};
}

/// Of another day with the day, of another year that day alone: in as much room.
QString short_time(const session::Message& message) {
    if (!is_known(message)) return QStringLiteral("\u2013");
    const QDate today = QDate::currentDate();
    if (local_time(message.time, "yyyy-MM-dd") == today.toString("yyyy-MM-dd"))
        return local_time(message.time, "HH:mm:ss.zzz");
    const bool is_this_year = local_time(message.time, "yyyy") == today.toString("yyyy");
    return local_time(message.time, is_this_year ? "MM-dd HH:mm:ss" : "yyyy-MM-dd");
}

bool has_text(const session::Message& message, const QString& text) {
    return text.isEmpty() || words(message.what).contains(text, Qt::CaseInsensitive) ||
           words(message.remedy).contains(text, Qt::CaseInsensitive) ||
           QString::fromStdString(message.axes).contains(text, Qt::CaseInsensitive);
}

}  // namespace

bool MessageFilter::takes(const session::Message& message) const {
    if (message.journal && !with_earlier_runs) return false;
    const bool is_wanted =
        kind == Kind::all || kind == kind_of(message) || (kind == Kind::commands && message.is_command);
    return is_wanted && has_text(message, text);
}

void MessageModel::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    fill();
}

void MessageModel::set_filter(MessageFilter filter) {
    if (filter_ == filter) return;
    filter_ = std::move(filter);
    fill();
}

/// The core still has the alarm itself, with all that is to be done.
bool MessageModel::is_told_here(const session::Message& earlier) const {
    if (!earlier.place || earlier.place->core_pid == 0) return false;
    return std::ranges::any_of(context_.log.messages(), [&](const session::Message& message) {
        return message.place && message.place->core_pid == earlier.place->core_pid &&
               message.place->tick == earlier.place->tick;
    });
}

void MessageModel::fill() {
    beginResetModel();
    rows_.clear();
    const auto& messages = context_.log.messages();
    shown_count_ = context_.log.count();
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const std::uint64_t number = shown_count_ - 1 - i;
        if (filter_.takes(messages[messages.size() - 1 - i])) rows_.push_back({false, number});
    }
    const auto& earlier = context_.history.messages();
    shown_earlier_ = earlier.size();
    for (std::size_t i = earlier.size(); i-- > 0;)
        if (filter_.takes(earlier[i]) && !is_told_here(earlier[i])) rows_.push_back({true, i});
    endResetModel();
}

/// Rows whose message the log has forgotten.
void MessageModel::forget_oldest() {
    const std::uint64_t first = context_.log.count() - context_.log.messages().size();
    const auto gone = [&](const Row& row) { return !row.is_earlier && row.number < first; };
    const auto begin = std::ranges::find_if(rows_, gone);
    if (begin == rows_.end()) return;
    const auto end = std::find_if_not(begin, rows_.end(), gone);
    const auto at = static_cast<int>(begin - rows_.begin());
    beginRemoveRows({}, at, at + static_cast<int>(end - begin) - 1);
    rows_.erase(begin, end);
    endRemoveRows();
}

bool MessageModel::refresh() {
    const auto& messages = context_.log.messages();
    const auto fresh = static_cast<std::size_t>(context_.log.count() - shown_count_);
    const bool has_more_history = shown_earlier_ != context_.history.messages().size();
    if (tokens_ == nullptr || (fresh == 0 && !has_more_history)) return false;
    const auto known = messages.size() - std::min(fresh, messages.size());
    const bool may_be_earlier =
        std::any_of(messages.begin() + static_cast<std::ptrdiff_t>(known), messages.end(),
                    [](const auto& message) { return message.place.has_value(); });
    if (has_more_history || (may_be_earlier && shown_earlier_ > 0) || fresh >= messages.size()) {
        fill();
        return true;
    }
    std::vector<Row> news;
    for (std::size_t i = messages.size(); i-- > known;)
        if (filter_.takes(messages[i])) news.push_back({false, context_.log.count() - messages.size() + i});
    shown_count_ = context_.log.count();
    if (!news.empty()) {
        beginInsertRows({}, 0, static_cast<int>(news.size()) - 1);
        rows_.insert(rows_.begin(), news.begin(), news.end());
        endInsertRows();
    }
    forget_oldest();
    return true;
}

int MessageModel::index_of(const Row& row) const {
    const auto found = std::ranges::find(rows_, row);
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

const session::Message* MessageModel::message_of(const Row& row) const {
    if (row.is_earlier) {
        const auto& earlier = context_.history.messages();
        return row.number < earlier.size() ? &earlier[row.number] : nullptr;
    }
    const auto& messages = context_.log.messages();
    const std::uint64_t first = context_.log.count() - messages.size();
    if (row.number < first || row.number - first >= messages.size()) return nullptr;
    return &messages[row.number - first];
}

QString MessageModel::name_of(const session::Message& message) {
    if (message.severity == Severity::alarm) return tr("Alarm");
    if (message.severity == Severity::warning) return tr("Warning");
    return message.is_command ? tr("Command") : tr("Info");
}

int MessageModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int MessageModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QString MessageModel::text_of(const session::Message& message, int column) const {
    switch (column) {
        case kTime:
            return short_time(message);
        case kKind:
            return name_of(message);
        case kAxes:
            return message.axes.empty() ? tr("–") : QString::fromStdString(message.axes);
        case kWhat:
            return words(message.what);
        default:
            return words(message.remedy);
    }
}

QVariant MessageModel::look_of(const session::Message& message, int column, int role) const {
    const bool is_alarm = message.severity == Severity::alarm;
    const QColor colour = is_alarm                                ? tokens_->alarm
                          : message.severity == Severity::warning ? tokens_->warn
                                                                  : tokens_->text2;
    if (role == Qt::BackgroundRole && is_alarm && !message.journal) return tokens_->alarm_ground;
    if (column == kKind && role == Qt::DecorationRole)
        return glyph_icon(glyph_of(message.severity), colour, colour);
    if (role != Qt::ForegroundRole) return {};
    if (column == kKind) return colour;
    return message.journal ? QVariant{tokens_->text2} : QVariant{};
}

QVariant MessageModel::data(const QModelIndex& index, int role) const {
    const session::Message* const message = index.row() < rowCount() ? message_of(row(index.row())) : nullptr;
    if (message == nullptr || tokens_ == nullptr) return {};
    if (role == Qt::DisplayRole) return text_of(*message, index.column());
    if (role == Qt::ToolTipRole && index.column() == kTime && is_known(*message))
        return local_time(message->time, "yyyy-MM-dd HH:mm:ss.zzz");
    if (role == Qt::ToolTipRole) return plain_tip(text_of(*message, index.column()));
    return look_of(*message, index.column(), role);
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    const QString names[kColumns] = {tr("Time"), tr("Kind"), tr("Axis"), tr("What happened"),
                                     tr("What to do")};
    return section >= 0 && section < kColumns ? names[section] : QVariant{};
}

}  // namespace psicarve::ui
