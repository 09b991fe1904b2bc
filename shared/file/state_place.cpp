// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/state_place.hpp"

#include <xxhash.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace psicarve {
namespace {

constexpr const char* kStateVariable = "PSICARVE_STATE";
constexpr std::size_t kChecksumDigits = 16;

constexpr std::string_view job_ending(bool is_simulator) noexcept {
    return is_simulator ? ".simulated.job" : ".job";
}

bool is_set(const char* name) {
    return std::getenv(name) != nullptr;  // NOLINT(concurrency-mt-unsafe): no thread changes the environment
}

std::string text_of_variable(const char* name) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return value == nullptr ? std::string{} : std::string{value};
}

/// The XDG base directory specification says to ignore a path that is not absolute.
std::string state_folder_of_user() {
    const std::string state = text_of_variable("XDG_STATE_HOME");
    const std::string home = text_of_variable("HOME");
    if (state.starts_with("/")) return state + "/psicarve";
    return home.starts_with("/") ? home + "/.local/state/psicarve" : std::string{};
}

constexpr unsigned kMarkBits = 30;
constexpr std::uint32_t kMarkMask = (std::uint32_t{1} << kMarkBits) - 1;

/// Does not ask a disk, which may hang. Never 0.
std::uint32_t mark_of(const std::string& folder) {
    std::error_code error;
    const auto from_root = std::filesystem::absolute(folder, error);
    std::string path = (error ? std::filesystem::path{folder} : from_root).lexically_normal().string();
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    const auto mark = static_cast<std::uint32_t>(XXH3_64bits(path.data(), path.size())) & kMarkMask;
    return mark == 0 ? 1 : mark;
}

}  // namespace

CoreKeeping CoreKeeping::in(const std::string& folder, How how) {
    return folder.empty() ? CoreKeeping{How::nowhere, 0} : CoreKeeping{how, mark_of(folder)};
}

CoreKeeping CoreKeeping::unpack(std::uint32_t word) noexcept {
    return {static_cast<How>(word >> kMarkBits), word & kMarkMask};
}

std::uint32_t CoreKeeping::pack() const noexcept {
    return (static_cast<std::uint32_t>(how) << kMarkBits) | (folder_mark & kMarkMask);
}

bool CoreKeeping::is_in(const std::string& folder) const {
    return is_somewhere() && folder_mark == mark_of(folder);
}

std::string state_folder_of_core(bool is_of_system) {
    if (is_set(kStateVariable)) return text_of_variable(kStateVariable);
    const std::string given = text_of_variable("STATE_DIRECTORY");
    // Several are separated by colons.
    if (given.starts_with("/")) return given.substr(0, given.find(':'));
    return is_of_system ? std::string{kSystemStateFolder} : state_folder_of_user();
}

std::vector<std::string> state_folders_to_read() {
    std::vector<std::string> folders;
    if (is_set(kStateVariable)) {
        if (const std::string named = text_of_variable(kStateVariable); !named.empty())
            folders.push_back(named);
        return folders;
    }
    if (const std::string own = state_folder_of_user(); !own.empty()) folders.push_back(own);
    folders.emplace_back(kSystemStateFolder);
    return folders;
}

OffsetsFolder offsets_folder() {
    if (is_set(kStateVariable)) return {text_of_variable(kStateVariable), false};
    const std::string shared_folder = std::string{kSystemStateFolder} + "/offsets";
    std::error_code error;
    if (std::filesystem::is_directory(shared_folder, error)) return {shared_folder, true};
    return {state_folder_of_user(), false};
}

StateNames::StateNames(const std::string& folder, const std::string& segment_name, bool is_simulated)
    : base(folder + "/" + segment_name.substr(segment_name.starts_with("/") ? 1 : 0)),
      is_simulator(is_simulated) {}

std::string StateNames::job(std::uint64_t job_checksum) const {
    std::array<char, kChecksumDigits + 1> digits{};
    (void)std::snprintf(digits.data(), digits.size(), "%016" PRIx64, job_checksum);
    return base + "-" + digits.data() + std::string{job_ending(is_simulator)};
}

bool StateNames::is_job(const std::string& path) const {
    const std::string_view ending = job_ending(is_simulator);
    if (path.size() != base.size() + 1 + kChecksumDigits + ending.size()) return false;
    if (!path.starts_with(base + "-") || !path.ends_with(ending)) return false;
    const std::string_view digits = std::string_view{path}.substr(base.size() + 1, kChecksumDigits);
    return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace psicarve
