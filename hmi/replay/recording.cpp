// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/recording.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "hmi/machine/unique_fd.hpp"
#include "hmi/replay/snapshot_recording.hpp"
#include "hmi/replay/trace_recording.hpp"
#include "shared/snapshot_file.hpp"

namespace psicarve::replay {
namespace {

using Company = TraceRecording::Company;

bool is_snapshot_of_a_machine(const std::string& path) {
    const machine::UniqueFd file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    SnapshotHeader header{};
    if (file.get() < 0 || ::pread(file.get(), &header, sizeof header, 0) != sizeof header) return false;
    return header.magic == kSnapshotMagic && header.status_bytes + header.recorder_bytes != 0;
}

/// run.trace: run.job, run.psi, run.snap; a snapshot first, as it knows more.
std::string company_beside(const std::string& path) {
    std::filesystem::path beside{path};
    for (const char* extension : {".snap", ".job", ".psi"}) {
        std::error_code none;
        beside.replace_extension(extension);
        if (std::filesystem::is_regular_file(beside, none)) return beside.string();
    }
    return {};
}

Result<Company> company_of(const OpenOptions& options) {
    const bool is_asked_for = !options.job_path.empty();
    const std::string path = is_asked_for ? options.job_path : company_beside(options.path);
    if (path.empty()) return Company{};
    auto snapshot = load_snapshot(path);
    if (!snapshot) return is_asked_for ? Result<Company>{snapshot.error()} : Company{};
    Company company{path, nullptr, std::move(snapshot->records)};
    auto job = cam::prepare_snapshot(std::move(*snapshot), path);
    if (!job) return is_asked_for ? Result<Company>{job.error()} : Company{};
    company.job = std::make_shared<const cam::PreparedJob>(std::move(*job));
    return company;
}

}  // namespace

bool is_recording(const std::string& path) {
    return is_binary_trace(path) || is_snapshot_of_a_machine(path);
}

Result<std::unique_ptr<Recording>> open_recording(const OpenOptions& options, const Progress& progress) {
    if (!is_binary_trace(options.path)) return SnapshotRecording::open(options.path);
    auto company = company_of(options);
    if (!company) return company.error();
    return TraceRecording::open(options.path, *company, options.profile, progress);
}

}  // namespace psicarve::replay
