// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::profile {

/// A machine profile while it is edited: every key of profile_keys() by its index, as typed, checked after
/// each change. Saving keeps every byte of the file but the changed values.
class ProfileDraft {
public:
    /// The built-in profile; it has no file until it is saved as one.
    ProfileDraft();
    /// Wrong values of a file show at their keys. Errors: bad_input when it cannot be read, is no TOML, or
    /// has unknown keys or a table where a value belongs.
    static Result<ProfileDraft> open(const std::string& path);

    /// Empty: the draft is not from a file.
    const std::string& path() const noexcept { return path_; }
    static std::string backup_path(const std::string& path) { return path + ".bak"; }
    /// The older backups: 1 is the next older one, up to kOlderBackups.
    static std::string older_backup_path(const std::string& path, int age) {
        return backup_path(path) + "." + std::to_string(age);
    }
    static constexpr int kOlderBackups = 4;
    /// The paths of all possible backups, newest first.
    static std::vector<std::string> backups_of(const std::string& path);

    const std::string& typed(std::size_t key) const { return entries_[key].typed; }
    void type(std::size_t key, std::string_view text);
    /// The value in the file, as it would be typed.
    std::string saved(std::size_t key) const;

    bool is_changed(std::size_t key) const;
    bool differs_from_built_in(std::size_t key) const;
    /// Compares with a value as profile_values() gives it. A text that is no value differs.
    bool differs_from(std::size_t key, std::string_view toml) const;
    /// "what is wrong; remedy", or nothing.
    const std::string& problem(std::size_t key) const { return entries_[key].problem; }
    std::size_t changed_count() const;
    std::size_t problem_count() const;

    void undo(std::size_t key) { type(key, saved(key)); }
    void undo_all();

    /// The profile with all changes. Errors: bad_input as long as something is wrong.
    Result<Profile> profile() const;

    /// Writes the file, whose old state becomes the backup. Errors: bad_input while something is wrong, when
    /// another program has changed the file meanwhile, or where a value cannot be put in its place; those of
    /// write_file_atomically: the old file stays.
    Result<void> save();
    /// Whether save() leaves a backup: not of an empty file.
    bool keeps_backup() const noexcept { return !file_text_.empty(); }
    /// Saves under another name, which is the draft's from now on; an old file of that name becomes the
    /// backup.
    Result<void> save_as(const std::string& path);
    /// Reads a backup's values into the draft, without saving.
    Result<void> take_backup(const std::string& backup);

private:
    struct Entry {
        std::string typed;
        std::string toml;        ///< of what is typed; empty: no value
        std::string saved_toml;  ///< what the file says
        std::string problem;
    };

    void check();
    std::string every_value() const;
    /// The file's text with the changed values changed. Errors: bad_input, naming file and line.
    Result<std::string> new_file_text(const Profile& profile) const;
    Result<void> write(const std::string& path, const std::string& present_text);

    std::string path_;
    std::string file_text_;
    std::vector<Entry> entries_;
};

}  // namespace psicarve::profile
