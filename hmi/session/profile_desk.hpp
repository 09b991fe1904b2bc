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
#include "hmi/session/save_ledger.hpp"
#include "hmi/session/work_lane.hpp"

namespace psicarve::session {

/// The machine profile that somebody edits, whose files are read and written on a thread of its own, one
/// after the other: who asks for anything looks at lock() first. `told` is called by the poll() that finds it
/// done. One thread, the owner's.
class ProfileDesk {
public:
    using Told = std::function<void(const Result<void>&)>;

    explicit ProfileDesk(SaveLedger saves = {}) : saves_(std::move(saves)) {}

    const profile::ProfileDraft& draft() const noexcept { return draft_; }
    bool is_busy() const noexcept { return under_way_.has_value(); }
    bool is_saving() const noexcept { return under_way_ == Work::saving; }
    /// Other values are on their way: what would be typed now has no place.
    bool takes_values() const noexcept { return is_busy() && !is_saving(); }
    /// What is under way, and in the way of anything else.
    std::optional<Phrase> lock() const;

    /// Nothing while takes_values(). What is typed while it is being saved is a change since.
    void type(std::size_t key, std::string_view text);

    // All below: nothing while is_busy().
    void undo_all();
    void show(profile::ProfileDraft draft);
    /// In its place, when it can be opened.
    void open(const std::string& path, Told told);
    /// What somebody else has made of its file; what is typed and not saved stays so.
    void open_again(Told told);
    /// These three as those of ProfileDraft.
    void save(Told told);
    void save_as(const std::string& path, Told told);
    void take_backup(const std::string& backup, Told told);

    /// At screen rate.
    void poll() { lane_.deliver(); }

private:
    enum class Work : std::uint8_t { opening, saving, taking_backup };
    using Step = std::function<Result<void>(profile::ProfileDraft&)>;

    void begin(Work work, const std::string& path, profile::ProfileDraft asked, Step step, Told told);
    void finish(const profile::ProfileDraft& asked, const Result<profile::ProfileDraft>& made,
                const Told& told);

    profile::ProfileDraft draft_;
    std::optional<Work> under_way_;
    SaveLedger saves_;
    WorkLane lane_;  // last: its thread uses the others
};

}  // namespace psicarve::session
