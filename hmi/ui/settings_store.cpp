// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/settings_store.hpp"

#include <QSettings>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace psicarve::ui {
namespace {

/// A disk that sleeps gets no task for each look.
constexpr int kMostUnderWay = 2;

void apply(const SettingsChange& change, QVariantMap& values) {
    const QVariant made = change.make(values.value(change.key));
    if (made.isValid()) {
        values[change.key] = made;
    } else {
        values.remove(change.key);
    }
}

}  // namespace

SettingsFile settings_file() {
    // A QSettings reads its file as soon as it is made.
    const auto open = [] {
        return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope, "psicarve",
                                           "psicarve-hmi");
    };
    const auto read = [open] {
        const auto file = open();
        QVariantMap values;
        for (const QString& key : file->allKeys()) values[key] = file->value(key);
        return values;
    };
    const auto write = [open](const std::vector<SettingsChange>& changes) -> Result<void> {
        const auto file = open();
        for (const SettingsChange& change : changes) {
            const QVariant made = change.make(file->value(change.key));
            if (made.isValid()) {
                file->setValue(change.key, made);
            } else {
                file->remove(change.key);
            }
        }
        file->sync();
        // What stood in the file and made no sense has been written anew.
        if (file->status() != QSettings::AccessError) return {};
        return Error{ErrorCode::out_of_room, file->fileName().toStdString() + ": cannot be written"};
    };
    return {"psicarve-hmi.ini", read, write};
}

/// What was read, between the two threads.
struct SettingsStore::Arrival {
    std::mutex mutex;
    std::condition_variable come;
    std::optional<QVariantMap> read;
};

SettingsStore::SettingsStore(SettingsFile file, session::PendingSaves saves)
    : file_(std::move(file)), saves_(std::move(saves)), arrival_(std::make_shared<Arrival>()) {
    queue_.post([arrival = arrival_, read = file_.read]() -> session::BackgroundQueue::Finish {
        QVariantMap values = read();
        {
            const std::lock_guard lock{arrival->mutex};
            arrival->read = std::move(values);
        }
        arrival->come.notify_all();
        return {};
    });
}

SettingsStore::~SettingsStore() {
    write();
    queue_.finish();
}

bool SettingsStore::await_read(std::chrono::milliseconds limit) {
    if (is_read_) return true;
    std::unique_lock lock{arrival_->mutex};
    if (!arrival_->come.wait_for(lock, limit, [this] { return arrival_->read.has_value(); })) return false;
    take(*arrival_->read);
    return true;
}

void SettingsStore::take(const QVariantMap& read) {
    is_read_ = true;
    values_ = read;
    for (const SettingsChange& change : before_read_) apply(change, values_);
    before_read_.clear();
}

void SettingsStore::set(const QString& key, const QVariant& value) {
    if (is_read_ && values_.value(key) == value) return;
    change({key, [value](const QVariant&) { return value; }});
}

void SettingsStore::change(SettingsChange change) {
    apply(change, values_);
    if (!is_read_) before_read_.push_back(change);
    unwritten_.push_back(std::move(change));
}

void SettingsStore::poll() {
    if (!is_read_ && await_read(std::chrono::milliseconds{0}) && on_read_) on_read_();
    queue_.deliver();
    const auto saves = saves_.under_way();
    const auto own = std::count_if(saves.begin(), saves.end(),
                                   [this](const auto& save) { return save.path == file_.path; });
    if (own < kMostUnderWay) write();
}

void SettingsStore::write() {
    if (unwritten_.empty()) return;
    queue_.post(saves_.noted(
        file_.path, [this, changes = std::exchange(unwritten_, {})]() -> session::BackgroundQueue::Finish {
            const auto written = file_.write(changes);
            if (written) return {};
            return [this, why = written.error()] { complain(why); };
        }));
}

void SettingsStore::complain(const Error& why) {
    if (!std::exchange(has_complained_, true) && on_unwritten_) on_unwritten_(why);
}

}  // namespace psicarve::ui
