// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariant>
#include <QVariantMap>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hmi/session/background_queue.hpp"
#include "hmi/session/pending_saves.hpp"
#include "shared/base/result.hpp"

namespace psicarve::ui {

/// What a value becomes; invalid: there is none any more.
struct SettingsChange {
    QString key;
    std::function<QVariant(const QVariant& before)> make;
};

/// Where settings are kept. Both are called by a thread of their own, one at a time; a disk may take its
/// time.
struct SettingsFile {
    std::string path;  ///< as it is told of
    std::function<QVariantMap()> read;
    /// In order, on what is kept by then: another window may have written since. Errors: out_of_room when
    /// they could not be kept.
    std::function<Result<void>(const std::vector<SettingsChange>&)> write;
};
/// The user's own: psicarve/psicarve-hmi.ini.
SettingsFile settings_file();

/// The window's settings in memory. The caller never waits for their file: it is read, and written, by a
/// thread. One thread, the owner's.
class SettingsStore {
public:
    explicit SettingsStore(SettingsFile file = settings_file(), session::PendingSaves saves = {});
    /// What was changed is written, however long it takes.
    ~SettingsStore();
    SettingsStore(const SettingsStore&) = delete;
    SettingsStore& operator=(const SettingsStore&) = delete;

    /// Until then values are what was changed since, and nothing else.
    bool is_read() const noexcept { return is_read_; }
    /// Waits for that, no longer than the limit.
    bool await_read(std::chrono::milliseconds limit);
    QVariant value(const QString& key) const { return values_.value(key); }
    void set(const QString& key, const QVariant& value);
    /// Holds at once, and on whatever is read later.
    void change(SettingsChange change);
    /// At screen rate: hands changes to the writer, and calls `read` once the file was read later
    /// than the window waited for it.
    void poll();
    void set_on_read(std::function<void()> read) { on_read_ = std::move(read); }
    /// Called by poll(), of the first changes that could not be written.
    void set_on_unwritten(std::function<void(const Error&)> unwritten) {
        on_unwritten_ = std::move(unwritten);
    }
    session::PendingSaves saves() const { return saves_; }

private:
    struct Arrival;

    void write();
    void take(const QVariantMap& read);
    void complain(const Error& why);

    SettingsFile file_;
    session::PendingSaves saves_;
    QVariantMap values_;
    bool is_read_ = false;
    std::vector<SettingsChange> before_read_;
    std::vector<SettingsChange> unwritten_;
    std::function<void()> on_read_;
    std::function<void(const Error&)> on_unwritten_;
    bool has_complained_ = false;
    std::shared_ptr<Arrival> arrival_;
    session::BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::ui
