// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/work_keeper.hpp"

#include <QStringList>
#include <QSysInfo>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace psicarve::ui {
namespace {

using session::FileWatch;

constexpr std::chrono::seconds kPauseOfLooks{2};

/// A process that ran when the computer was started the last time is another one, whatever its number is.
QString start_of(qint64 pid) {
    std::ifstream boot{"/proc/sys/kernel/random/boot_id"};
    std::string boot_id;
    std::getline(boot, boot_id);
    std::ifstream file{"/proc/" + std::to_string(pid) + "/stat"};
    const std::string stat{std::istreambuf_iterator<char>{file}, {}};
    // The name of the program may have blanks and brackets; 20 fields follow it to the time of the start.
    constexpr int kStartField = 20;
    const QStringList fields =
        QString::fromStdString(stat.substr(stat.rfind(')') + 1)).split(' ', Qt::SkipEmptyParts);
    if (stat.empty() || fields.size() < kStartField) return {};
    return QString::fromStdString(boot_id) + ' ' + fields[kStartField - 1];
}

QVariantMap as_kept(const UnfinishedWork& work) {
    return {{"host", QSysInfo::machineHostName()},
            {"pid", static_cast<qint64>(::getpid())},
            {"start", start_of(::getpid())},
            {"path", work.path},
            {"time", static_cast<qint64>(work.stamp.time.time_since_epoch().count())},
            {"bytes", static_cast<quint64>(work.stamp.bytes)},
            {"sliced", work.is_sliced},
            {"fields", work.fields}};
}

UnfinishedWork from_kept(const QVariantMap& kept) {
    FileWatch::Stamp stamp;
    stamp.time = std::filesystem::file_time_type{
        std::filesystem::file_time_type::duration{kept.value("time").toLongLong()}};
    stamp.bytes = kept.value("bytes").toULongLong();
    return {kept.value("path").toString(), stamp, kept.value("sliced").toBool(),
            kept.value("fields").toMap()};
}

bool is_left_here(const QVariantMap& kept) {
    if (kept.value("path").toString().isEmpty()) return false;
    if (kept.value("host").toString() != QSysInfo::machineHostName()) return false;
    return start_of(kept.value("pid").toLongLong()) != kept.value("start").toString();
}

WorkKeeper::FileState state_of(const UnfinishedWork& work) {
    const auto there = FileWatch::stamp_of(work.path.toStdString());
    if (!there) return WorkKeeper::FileState::gone;
    return *there == work.stamp ? WorkKeeper::FileState::same : WorkKeeper::FileState::changed;
}

SettingsChange without(const QString& id) {
    return {WorkKeeper::kKey, [id](const QVariant& before) {
                QVariantMap all = before.toMap();
                all.remove(id);
                return all.isEmpty() ? QVariant{} : QVariant{all};
            }};
}

}  // namespace

WorkKeeper::WorkKeeper(SettingsStore& settings) : settings_(settings) {
    static std::atomic<int> count{0};  // a process of a test has several windows
    id_ = QStringList{QSysInfo::machineHostName(), QString::number(::getpid()), start_of(::getpid()),
                      QString::number(++count)}
              .join(' ');
}

void WorkKeeper::remember(const UnfinishedWork& work) {
    if (kept_ == work) return;
    kept_ = work;
    settings_.change({kKey, [id = id_, value = as_kept(work)](const QVariant& before) {
                          QVariantMap all = before.toMap();
                          all[id] = value;
                          return QVariant{all};
                      }});
}

void WorkKeeper::forget() {
    if (!std::exchange(kept_, std::nullopt)) return;
    settings_.change(without(id_));
}

void WorkKeeper::poll(Clock::time_point now) {
    queue_.deliver();
    if (now < next_look_ || !settings_.is_read() || !queue_.is_idle()) return;
    next_look_ = now + kPauseOfLooks;
    if (!std::exchange(has_looked_, true)) return look();
    if (!left_.empty()) look_for_file();
}

void WorkKeeper::look() {
    queue_.post([this, all = settings_.value(kKey).toMap()]() -> session::BackgroundQueue::Finish {
        std::vector<Left> found;
        for (auto one = all.begin(); one != all.end(); ++one) {
            const QVariantMap kept = one.value().toMap();
            if (!is_left_here(kept)) continue;
            const UnfinishedWork work = from_kept(kept);
            found.push_back({one.key(), work, state_of(work)});
        }
        return [this, found] { left_ = found; };
    });
}

/// A stick may be plugged in, and another program may write.
void WorkKeeper::look_for_file() {
    queue_.post([this, next = left_.front()]() -> session::BackgroundQueue::Finish {
        return [this, id = next.id, state = state_of(next.work)] {
            for (Left& one : left_) {
                if (one.id == id) one.file = state;
            }
        };
    });
}

void WorkKeeper::drop_left(const QString& id) {
    const auto is_it = [&id](const Left& one) { return one.id == id; };
    const auto found = std::find_if(left_.begin(), left_.end(), is_it);
    if (found == left_.end()) return;
    settings_.change(without(id));
    left_.erase(found);
}

}  // namespace psicarve::ui
