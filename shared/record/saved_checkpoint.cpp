// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/saved_checkpoint.hpp"

#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <type_traits>
#include <utility>

#include "shared/base/shared_text.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/file/withdrawn_file.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve {
namespace {

constexpr std::uint64_t kSavedMagic = 0x315450454b435350ULL;  // "PSCKEPT1"
constexpr std::uint32_t kSavedVersion = 1;

struct SavedFile {
    std::uint64_t magic;
    std::uint32_t version;
    std::uint32_t total_bytes;
    std::uint64_t checksum;  ///< XXH3 over the whole file with this field 0
    Checkpoint checkpoint;
    std::uint64_t job_bytes;
    std::uint64_t profile_hash;
    std::int64_t written_s;
    std::uint32_t is_simulator;
    std::uint32_t reserved;
    std::uint64_t sequence;
    char segment_name[256];
    char source_name[128];
    char tool[64];
};
static_assert(sizeof(SavedFile) == 544 && std::is_trivially_copyable_v<SavedFile>, "bump kSavedVersion");

std::uint64_t checksum_of_saved(SavedFile file) noexcept {
    file.checksum = 0;
    return XXH3_64bits(&file, sizeof file);
}

std::string without_zeros(std::string text) {
    while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
        const bool was_point = text.back() == '.';
        text.pop_back();
        if (was_point) break;
    }
    return text;
}

}  // namespace

std::string tool_text(const ToolProfile& tool) {
    const std::string name{name_of(tool.shape)};
    if (tool.shape == ToolShape::point) return name;
    std::array<char, 64> size{};
    (void)std::snprintf(size.data(), size.size(), "%.3f", tool.diameter_mm);
    return name + ", " + without_zeros(size.data()) + " mm";
}

std::vector<std::byte> saved_checkpoint_bytes(const SavedCheckpoint& saved) {
    SavedFile file{};
    file.magic = kSavedMagic;
    file.version = kSavedVersion;
    file.total_bytes = sizeof(SavedFile);
    file.checkpoint = saved.checkpoint;
    file.sequence = saved.sequence;
    file.job_bytes = saved.job_bytes;
    file.profile_hash = saved.profile_hash;
    file.written_s = saved.written_s;
    file.is_simulator = saved.is_simulator ? 1 : 0;
    text_into_field(file.segment_name, saved.segment_name);
    text_into_field(file.source_name, saved.source_name);
    text_into_field(file.tool, saved.tool);
    file.checksum = checksum_of_saved(file);
    const auto bytes = std::as_bytes(std::span{&file, 1});
    return {bytes.begin(), bytes.end()};
}

Result<SavedCheckpoint> parse_saved_checkpoint(std::span<const std::byte> bytes,
                                               const std::string& file_name) {
    const auto wrong = [&](const std::string& what) { return bad_input(file_name + ": " + what); };
    SavedFile file{};
    const bool is_ours = bytes.size() >= sizeof(kSavedMagic) &&
                         std::memcmp(bytes.data(), &kSavedMagic, sizeof(kSavedMagic)) == 0;
    if (!is_ours) return wrong("is no psicarve checkpoint");
    constexpr std::size_t kSizedBytes = offsetof(SavedFile, checksum);
    if (bytes.size() < kSizedBytes) return wrong("truncated");
    std::memcpy(&file, bytes.data(), kSizedBytes);
    if (file.version != kSavedVersion) {
        return wrong("file version " + std::to_string(file.version) + ", this program knows " +
                     std::to_string(kSavedVersion));
    }
    if (bytes.size() < sizeof file) return wrong("truncated");
    if (bytes.size() > sizeof file || file.total_bytes != sizeof file) return wrong("has a wrong size");
    std::memcpy(&file, bytes.data(), sizeof file);
    if (checksum_of_saved(file) != file.checksum) return wrong("damaged: its checksum is wrong");
    if (!is_checkpoint(file.checkpoint) || file.is_simulator > 1) return wrong("holds no checkpoint");
    SavedCheckpoint saved;
    saved.checkpoint = file.checkpoint;
    saved.job_bytes = file.job_bytes;
    saved.profile_hash = file.profile_hash;
    saved.written_s = file.written_s;
    saved.is_simulator = file.is_simulator != 0;
    saved.sequence = file.sequence;
    saved.segment_name = text_from_field(file.segment_name);
    saved.source_name = text_from_field(file.source_name);
    saved.tool = text_from_field(file.tool);
    return saved;
}

Result<SavedCheckpoint> load_saved_checkpoint(const std::string& path) {
    // One byte more than the file may have.
    const auto bytes = read_file_start(path, sizeof(SavedFile) + 1);
    if (!bytes) return bytes.error();
    return parse_saved_checkpoint(*bytes, path);
}

Result<void> save_checkpoint(const SavedCheckpoint& saved, const std::string& path) {
    const std::vector<std::byte> bytes = saved_checkpoint_bytes(saved);
    const std::array parts{std::span<const std::byte>{bytes}};
    return write_parts_atomically(path, parts, FileRights{kForEverybody, {}});
}

std::optional<FoundCheckpoint> find_in(const std::string& folder, const std::string& segment_name,
                                       bool is_simulator) {
    const StateNames names{folder, segment_name, is_simulator};
    auto saved = load_saved_checkpoint(names.checkpoint());
    if (!saved || !saved->is_of(segment_name, is_simulator)) return std::nullopt;
    const std::string job = names.job(saved->checkpoint.job_checksum);
    return FoundCheckpoint{std::move(*saved), names.checkpoint(),
                           is_snapshot_file(job) ? job : std::string{}};
}

std::optional<FoundCheckpoint> find_newest(const std::string& segment_name, bool is_simulator,
                                           const std::vector<std::string>& folders, const CoreKeeping& core) {
    std::vector<FoundCheckpoint> all;
    for (const std::string& folder : folders) {
        auto found = find_in(folder, segment_name, is_simulator);
        if (core.is_in(folder)) {
            if (found) found->keeper = Keeper::this_core;
            return found;
        }
        if (found) all.push_back(std::move(*found));
    }
    if (all.empty()) return std::nullopt;
    const auto is_older = [](const FoundCheckpoint& one, const FoundCheckpoint& other) {
        return one.saved.written_s < other.saved.written_s;
    };
    const auto newest = std::ranges::max_element(all, is_older);
    FoundCheckpoint found = *newest;
    if (core.how != CoreKeeping::How::unknown) found.keeper = Keeper::other_core;
    for (const FoundCheckpoint& other : all)
        if (other.path != found.path && other.saved.is_unfinished()) found.other_paths.push_back(other.path);
    return found;
}

std::optional<FoundCheckpoint> find_unfinished(const std::string& segment_name,
                                               std::optional<bool> is_simulator, const std::string& folder,
                                               const CoreKeeping& core) {
    const std::vector<std::string> folders =
        folder.empty() ? state_folders_to_read() : std::vector<std::string>{folder};
    for (const bool is_simulated : {false, true}) {
        if (is_simulator && *is_simulator != is_simulated) continue;
        auto found = find_newest(segment_name, is_simulated, folders, core);
        if (found && found->saved.is_unfinished()) return found;
    }
    return std::nullopt;
}

Result<void> forget_piece(const FoundCheckpoint& found) {
    if (auto gone = withdraw_record(found.path, found.saved.name()); !gone) return gone.error();
    // Without its checkpoint it is a job like any other: harmless where it stays.
    if (!found.job_path.empty()) ::unlink(found.job_path.c_str());
    return {};
}

Result<void> withdraw_record(const std::string& path, const RecordName& record) {
    const auto standing = load_saved_checkpoint(path);
    std::error_code error;
    if (!standing && !std::filesystem::exists(path, error) && !error) return {};
    if (!standing) return standing.error();  // another program's, or the disk does not answer
    if (standing->name() != record)
        return Error{ErrorCode::machine_refused, path + ": another record has come meanwhile; it is left"};
    return withdraw_file(path);
}

Command command_to_forget(const RecordName& record) noexcept {
    constexpr unsigned kHalfBits = 32;
    Command command{};
    command.kind = CommandKind::forget_piece;
    command.axis = record.is_simulator ? 1 : 0;
    command.value2 = record.sequence;
    command.lease_token = static_cast<std::uint32_t>(record.job_checksum);
    command.lease_ms = static_cast<std::uint32_t>(record.job_checksum >> kHalfBits);
    return command;
}

RecordName record_to_forget(const Command& command, const std::string& segment_name) {
    constexpr unsigned kHalfBits = 32;
    const std::uint64_t high = command.lease_ms;
    return {segment_name, command.axis != 0, (high << kHalfBits) | command.lease_token, command.value2};
}

}  // namespace psicarve
