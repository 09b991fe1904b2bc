// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hmi/phrase/phrase.hpp"
#include "hmi/profile/profile_draft.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/pending_saves.hpp"

namespace psicarve::session {

/// The machine profile that is edited in the window; a thread of its own reads and writes its files, one
/// after the other: callers check lock() first. The poll() that finds a task done calls `told`. All calls
/// come from one thread, the owner's.
class ProfileFiles {
public:
    using Told = std::function<void(const Result<void>&)>;

    explicit ProfileFiles(PendingSaves saves = {}) : saves_(std::move(saves)) {}

    const profile::ProfileDraft& draft() const noexcept { return draft_; }
    bool is_busy() const noexcept { return under_way_.has_value(); }
    bool is_saving() const noexcept { return under_way_ == Work::saving; }
    /// True while other values are being read: then there is no draft to type into.
    bool takes_values() const noexcept { return is_busy() && !is_saving(); }
    /// The task under way, which blocks all others.
    std::optional<Phrase> lock() const;

    /// Does nothing while takes_values(). Text typed during a save is a change after it.
    void type(std::size_t key, std::string_view text);

    // The following do nothing while is_busy():
    void undo_all();
    void show(profile::ProfileDraft draft);
    /// Opens a file in its place, if it can be read.
    void open(const std::string& path, Told told);
    /// Reads its file again after another program has changed it; typed and unsaved values stay.
    void open_again(Told told);
    /// As the functions of ProfileDraft.
    void save(Told told);
    void save_as(const std::string& path, Told told);
    void take_backup(const std::string& backup, Told told);

    /// Call it at screen rate.
    void poll() { queue_.deliver(); }

private:
    enum class Work : std::uint8_t { opening, saving, taking_backup };
    using Step = std::function<Result<void>(profile::ProfileDraft&)>;

    void begin(Work work, const std::string& path, profile::ProfileDraft asked, Step step, Told told);
    void finish(const profile::ProfileDraft& asked, const Result<profile::ProfileDraft>& made,
                const Told& told);

    profile::ProfileDraft draft_;
    std::optional<Work> under_way_;
    PendingSaves saves_;
    BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::session
