// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/support_bundle.hpp"

#include <sys/utsname.h>

#include <chrono>
#include <filesystem>
#include <span>
#include <system_error>

#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/snapshot_taker.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::session {
namespace {

namespace fs = std::filesystem;
using machine::MachineLink;

constexpr std::chrono::milliseconds kLockLimit{2000};

Result<void> write_text(const fs::path& path, const std::string& text) {
    return write_file_atomically(path.string(), std::as_bytes(std::span{text}));
}

Result<void> save_segment(const SupportBundle& bundle, const fs::path& path) {
    auto link = MachineLink::attach(bundle.segment_name, bundle.group);
    if (!link) return link.error();
    const auto snapshot = machine::take_snapshot(*link, kLockLimit);
    if (!snapshot) return snapshot.error();
    return save_snapshot(*snapshot, path.string(), bundle.group);
}

/// Copies the logs; returns those that could not be copied, a line each.
std::string copy_logs(const std::string& from, const fs::path& into) {
    std::string missing;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{from, error}) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("psicarve-hmi.log")) continue;
        fs::copy_file(entry.path(), into / name, error);
        if (error) missing += name + ": " + error.message() + "\n";
    }
    if (error) missing += from + ": " + error.message() + "\n";
    return missing;
}

}  // namespace

std::string system_text() {
    utsname system{};
    if (uname(&system) != 0) return {};
    return std::string{"system     "} + system.sysname + " " + system.release + " " + system.machine + "\n" +
           "kernel     " + system.version + "\n";
}

Result<std::string> write_support_bundle(const SupportBundle& bundle, const std::string& folder,
                                         const std::string& stamp) {
    const fs::path into = fs::path{folder} / ("psicarve-support-" + stamp);
    std::error_code error;
    const bool is_new = fs::create_directory(into, error);
    if (error) return Error{ErrorCode::bad_input, into.string() + ": " + error.message()};
    if (!is_new) return Error{ErrorCode::bad_input, into.string() + " is there already"};
    std::string versions = bundle.versions;
    if (!bundle.log_folder.empty()) versions += copy_logs(bundle.log_folder, into);
    if (bundle.profile) {
        if (auto written = write_text(into / "profile.toml", profile_to_toml(*bundle.profile)); !written)
            return written.error();
    } else {
        versions += "profile    not known to the window\n";
    }
    if (const auto saved = save_segment(bundle, into / "snapshot.psi"); !saved)
        versions += "snapshot   " + saved.error().message + "\n";
    if (auto written = write_text(into / "messages.txt", bundle.messages); !written) return written.error();
    if (auto written = write_text(into / "versions.txt", versions); !written) return written.error();
    return into.string();
}

}  // namespace psicarve::session
