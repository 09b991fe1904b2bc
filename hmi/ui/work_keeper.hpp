// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariantMap>

#include <chrono>
#include <optional>
#include <vector>

#include "hmi/session/background_queue.hpp"
#include "hmi/session/file_watch.hpp"
#include "hmi/ui/settings_store.hpp"

namespace psicarve::ui {

/// A model that was on the desk and neither published nor saved as a job: how it is made again.
struct UnfinishedWork {
    QString path;
    session::FileWatch::Stamp stamp;  ///< of the file, when it was opened
    bool is_sliced = false;
    QVariantMap fields;  ///< of the form, by their names

    friend bool operator==(const UnfinishedWork& a, const UnfinishedWork& b) {
        return a.path == b.path && a.stamp == b.stamp && a.is_sliced == b.is_sliced && a.fields == b.fields;
    }
};

/// Keeps what this window's operator has on the desk, and finds what windows have left that were ended before
/// they could forget theirs: not those that run, nor those of other computers with the same home. One thread,
/// the owner's; files are looked at by another.
class WorkKeeper {
public:
    using Clock = std::chrono::steady_clock;
    enum class FileState { same, changed, gone };
    struct Left {
        QString id;
        UnfinishedWork work;
        FileState file = FileState::same;
    };

    explicit WorkKeeper(SettingsStore& settings);

    void remember(const UnfinishedWork& work);
    /// What this window has kept; null: nothing.
    const UnfinishedWork* kept() const noexcept { return kept_ ? &*kept_ : nullptr; }
    /// A window that goes in order leaves nothing.
    void forget();

    /// At screen rate: looks once what was left, as soon as settings are read, and every few seconds for the
    /// file of the next of it.
    void poll(Clock::time_point now);
    /// The next that was left; null: none.
    const Left* left() const noexcept { return left_.empty() ? nullptr : &left_.front(); }
    /// It was taken up, or is not wanted.
    void drop_left(const QString& id);

    /// In the settings: id -> what is kept of it.
    static constexpr const char* kKey = "work/unfinished";

private:
    void look();
    void look_for_file();

    SettingsStore& settings_;
    QString id_;  ///< this window's: computer, process, and when that was started
    std::optional<UnfinishedWork> kept_;
    std::vector<Left> left_;
    bool has_looked_ = false;
    Clock::time_point next_look_{};
    session::BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::ui
