// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_files.hpp"

#include <utility>

#include "shared/profile/profile_text.hpp"

namespace psicarve::session {

using profile::ProfileDraft;

namespace {

Result<void> opened_in_place(ProfileDraft& draft, const std::string& path) {
    auto opened = ProfileDraft::open(path);
    if (!opened) return opened.error();
    draft = std::move(*opened);
    return {};
}

}  // namespace

std::optional<Phrase> ProfileFiles::lock() const {
    if (!is_busy()) return std::nullopt;
    switch (*under_way_) {
        case Work::opening:
            return phrase("The profile is being opened");
        case Work::saving:
            return phrase("The profile is being saved");
        case Work::taking_backup:
            break;
    }
    return phrase("The backup is being read");
}

void ProfileFiles::type(std::size_t key, std::string_view text) {
    if (!takes_values()) draft_.type(key, text);
}

void ProfileFiles::undo_all() {
    if (!is_busy()) draft_.undo_all();
}

void ProfileFiles::show(ProfileDraft draft) {
    if (!is_busy()) draft_ = std::move(draft);
}

void ProfileFiles::open(const std::string& path, Told told) {
    begin(
        Work::opening, path, draft_, [path](ProfileDraft& draft) { return opened_in_place(draft, path); },
        std::move(told));
}

void ProfileFiles::open_again(Told told) {
    ProfileDraft unchanged = draft_;
    unchanged.undo_all();
    begin(
        Work::opening, draft_.path(), std::move(unchanged),
        [path = draft_.path()](ProfileDraft& draft) { return opened_in_place(draft, path); },
        std::move(told));
}

void ProfileFiles::save(Told told) {
    begin(
        Work::saving, draft_.path(), draft_, [](ProfileDraft& draft) { return draft.save(); },
        std::move(told));
}

void ProfileFiles::save_as(const std::string& path, Told told) {
    begin(
        Work::saving, path, draft_, [path](ProfileDraft& draft) { return draft.save_as(path); },
        std::move(told));
}

void ProfileFiles::take_backup(const std::string& backup, Told told) {
    begin(
        Work::taking_backup, backup, draft_,
        [backup](ProfileDraft& draft) { return draft.take_backup(backup); }, std::move(told));
}

void ProfileFiles::begin(Work work, const std::string& path, ProfileDraft asked, Step step, Told told) {
    if (is_busy()) return;
    under_way_ = work;
    BackgroundQueue::Task task = [this, asked = std::move(asked), step = std::move(step),
                                  told = std::move(told)]() -> BackgroundQueue::Finish {
        ProfileDraft draft = asked;
        const auto done = step(draft);
        const auto made = done ? Result<ProfileDraft>{std::move(draft)} : Result<ProfileDraft>{done.error()};
        return [this, asked, made, told] { finish(asked, made, told); };
    };
    queue_.post(work == Work::saving ? saves_.noted(path, std::move(task)) : std::move(task));
}

/// A value that has changed since the request was typed meanwhile, and stays.
void ProfileFiles::finish(const ProfileDraft& asked, const Result<ProfileDraft>& made, const Told& told) {
    under_way_.reset();
    if (made) {
        const ProfileDraft present = std::exchange(draft_, *made);
        for (std::size_t key = 0; key < profile_keys().size(); ++key) {
            if (present.typed(key) != asked.typed(key)) draft_.type(key, present.typed(key));
        }
    }
    told(made ? Result<void>{} : Result<void>{made.error()});
}

}  // namespace psicarve::session
