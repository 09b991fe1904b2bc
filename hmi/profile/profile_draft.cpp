// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/profile_draft.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "hmi/profile/toml_edit.hpp"
#include "hmi/profile/typed_value.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::profile {
namespace {

std::string expectation_of(const ProfileKey& key) {
    switch (key.value) {
        case ProfileValue::number:
            return "this is no number; enter " + key.bounds;
        case ProfileValue::integer:
            return "this is no whole number; enter " + key.bounds;
        case ProfileValue::range:
            return "these are no two numbers; enter them as 0.0 ... 60.0";
        case ProfileValue::text:
        case ProfileValue::word:
            break;
    }
    return "it has a character that is none to print; remove it";
}

Result<std::string> text_of(const std::string& path) {
    const auto bytes = read_file_start(path, kProfileTextBytes + 1);
    if (!bytes) return bytes.error();
    return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
}

/// Makes each backup one older; removes the oldest.
void age_backups(const std::string& path) {
    std::error_code none_yet;
    for (int age = ProfileDraft::kOlderBackups; age > 1; --age)
        std::filesystem::rename(ProfileDraft::older_backup_path(path, age - 1),
                                ProfileDraft::older_backup_path(path, age), none_yet);
    std::filesystem::rename(ProfileDraft::backup_path(path), ProfileDraft::older_backup_path(path, 1),
                            none_yet);
}

}  // namespace

ProfileDraft::ProfileDraft() : entries_(profile_keys().size()) {
    for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i].saved_toml = profile_keys()[i].built_in;
    undo_all();
}

std::vector<std::string> ProfileDraft::backups_of(const std::string& path) {
    std::vector<std::string> backups{backup_path(path)};
    for (int age = 1; age <= kOlderBackups; ++age) backups.push_back(older_backup_path(path, age));
    return backups;
}

Result<ProfileDraft> ProfileDraft::open(const std::string& path) {
    auto text = text_of(path);
    if (!text) return text.error();
    const ProfileReading read = read_profile(*text);
    const std::vector<ProfileKey>& keys = profile_keys();
    std::vector<std::string> values = profile_values(read.profile);
    for (const ProfileProblem& problem : read.problems) {
        const auto key = std::find_if(keys.begin(), keys.end(),
                                      [&](const ProfileKey& each) { return each.path == problem.key; });
        if (key == keys.end()) return parse_profile(*text, path).error();
        if (read.is_each_value_read) continue;
        // Keep it as written, since it means the same; a table in its place cannot be corrected here.
        auto written = value_in(*text, key->path);
        if (!written) return parse_profile(*text, path).error();
        values[static_cast<std::size_t>(key - keys.begin())] = std::move(*written);
    }
    ProfileDraft draft;
    draft.path_ = path;
    draft.file_text_ = std::move(*text);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Entry& entry = draft.entries_[i];
        entry.saved_toml = std::move(values[i]);
        entry.typed = typed_from_toml(keys[i], entry.saved_toml);
        entry.toml = entry.saved_toml;
    }
    draft.check();
    return draft;
}

void ProfileDraft::type(std::size_t key, std::string_view text) {
    Entry& entry = entries_[key];
    entry.typed = text;
    const ProfileKey& kind = profile_keys()[key];
    // Typed back to what it was, it is what it was: 400 and 400.0 are no change.
    entry.toml = text == typed_from_toml(kind, entry.saved_toml)
                     ? entry.saved_toml
                     : toml_from_typed(kind, text).value_or(std::string{});
    check();
}

std::string ProfileDraft::saved(std::size_t key) const {
    return typed_from_toml(profile_keys()[key], entries_[key].saved_toml);
}

bool ProfileDraft::is_changed(std::size_t key) const {
    return entries_[key].toml != entries_[key].saved_toml;
}

bool ProfileDraft::differs_from_built_in(std::size_t key) const {
    return entries_[key].toml != profile_keys()[key].built_in;
}

bool ProfileDraft::differs_from(std::size_t key, std::string_view toml) const {
    return entries_[key].toml != toml;
}

std::size_t ProfileDraft::changed_count() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) count += is_changed(i) ? 1 : 0;
    return count;
}

std::size_t ProfileDraft::problem_count() const {
    return static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.end(), [](const Entry& e) { return !e.problem.empty(); }));
}

void ProfileDraft::undo_all() {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        entries_[i].toml = entries_[i].saved_toml;
        entries_[i].typed = saved(i);
    }
    check();
}

/// All keys as a profile. Leaves out invalid values: they have problems of their own already.
std::string ProfileDraft::every_value() const {
    std::string text;
    std::string_view present;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const std::string_view path = profile_keys()[i].path;
        const std::string_view table = table_of_key(path);
        if (table != present) text += "[" + std::string(table) + "]\n";
        present = table;
        if (entries_[i].toml.empty()) continue;
        text += std::string(leaf_of_key(path)) + " = " + entries_[i].toml + "\n";
    }
    return text;
}

void ProfileDraft::check() {
    const std::vector<ProfileKey>& keys = profile_keys();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        entries_[i].problem = entries_[i].toml.empty() ? expectation_of(keys[i]) : "";
    }
    for (const ProfileProblem& problem : profile_problems(every_value())) {
        const auto at = std::find_if(keys.begin(), keys.end(),
                                     [&](const ProfileKey& key) { return key.path == problem.key; });
        if (at == keys.end()) continue;
        Entry& entry = entries_[static_cast<std::size_t>(at - keys.begin())];
        if (entry.problem.empty()) entry.problem = problem.text;
    }
}

Result<Profile> ProfileDraft::profile() const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (entries_[i].problem.empty()) continue;
        return bad_input(profile_keys()[i].path + ": " + entries_[i].problem);
    }
    return parse_profile(every_value(), path_.empty() ? "the profile" : path_);
}

Result<std::string> ProfileDraft::new_file_text(const Profile& profile) const {
    if (file_text_.empty()) return profile_to_toml(profile);
    std::string text = file_text_;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (!is_changed(i)) continue;
        auto changed = with_value(text, profile_keys()[i].path, entries_[i].toml);
        if (!changed) return bad_input(path_ + ": " + changed.error().message);
        text = std::move(*changed);
    }
    // The file must read back to what is shown here.
    const auto read = parse_profile(text, path_);
    if (!read) return read.error();
    if (*read != profile) return bad_input(path_ + ": it would not say what is shown here; open it again");
    return text;
}

namespace {

/// Follows a link: a profile that is kept elsewhere stays there.
std::string file_behind(const std::string& path) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::canonical(path, error);
    return error ? path : target.string();
}

}  // namespace

Result<void> ProfileDraft::write(const std::string& path, const std::string& present_text) {
    const auto wanted = profile();
    if (!wanted) return wanted.error();
    const auto text = new_file_text(*wanted);
    if (!text) return text.error();
    const auto save_text = [](const std::string& to, const std::string& what) {
        return write_file_atomically(to, std::as_bytes(std::span(what)));
    };
    if (!present_text.empty()) {
        age_backups(path);
        if (auto kept = save_text(backup_path(path), present_text); !kept) return kept.error();
    }
    if (auto written = save_text(file_behind(path), *text); !written) return written.error();
    path_ = path;
    file_text_ = *text;
    for (Entry& entry : entries_) entry.saved_toml = entry.toml;
    return {};
}

Result<void> ProfileDraft::save() {
    if (path_.empty()) return bad_input("the built-in profile has no file: save it under a name");
    const auto present = text_of(path_);
    if (!present) return present.error();
    if (*present != file_text_) {
        return bad_input(path_ +
                         ": somebody has changed this file since it was opened; save under another name, or "
                         "open it again and lose these changes");
    }
    return write(path_, *present);
}

Result<void> ProfileDraft::save_as(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return write(path, "");
    const auto present = text_of(path);
    if (!present) return present.error();
    return write(path, *present);
}

Result<void> ProfileDraft::take_backup(const std::string& backup) {
    const auto old = open(backup);
    if (!old) return old.error();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        entries_[i].toml = old->entries_[i].toml;
        entries_[i].typed = old->entries_[i].typed;
    }
    check();
    return {};
}

}  // namespace psicarve::profile
