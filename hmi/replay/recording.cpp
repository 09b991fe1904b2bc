// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/recording.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "hmi/machine/unique_fd.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "hmi/replay/snapshot_recording.hpp"
#include "hmi/replay/trace_recording.hpp"
#include "hmi/trace/carried_job.hpp"
#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::replay {
namespace {

using Company = TraceRecording::Company;

bool is_snapshot_of_a_machine(const std::string& path) {
    const machine::UniqueFd file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    SnapshotHeader header{};
    if (file.get() < 0 || ::pread(file.get(), &header, sizeof header, 0) != sizeof header) return false;
    return header.magic == kSnapshotMagic && header.status_bytes + header.recorder_bytes != 0;
}

/// run.trace: run.snap, run.job, run.psi; a snapshot first, since it holds more.
std::vector<std::string> companies_beside(const std::string& path) {
    std::vector<std::string> found;
    std::filesystem::path beside{path};
    for (const char* extension : {".snap", ".job", ".psi"}) {
        std::error_code none;
        beside.replace_extension(extension);
        if (std::filesystem::is_regular_file(beside, none)) found.push_back(beside.string());
    }
    return found;
}

Result<Company> company_of(const std::string& path) {
    auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    Company company{path, nullptr, std::move(snapshot->records), {}};
    auto job = cam::prepare_snapshot(std::move(*snapshot), path);
    if (!job) return job.error();
    company.job = std::make_shared<const cam::PreparedJob>(std::move(*job));
    return company;
}

/// For a company with the same job. Its records belong to the trace's run only if they match it, too.
void add_records_beside(Company& company, std::vector<session::Phrase>& warnings) {
    const std::uint64_t checksum = job_checksum(company.job->blob);
    for (const std::string& path : companies_beside(company.path)) {
        auto snapshot = load_snapshot(path);
        if (!snapshot) {
            warnings.push_back(session::error_phrase(snapshot.error()));
            continue;
        }
        if (snapshot->records.empty() || job_checksum(snapshot->job_blob) != checksum) continue;
        company.records = std::move(snapshot->records);
        company.records_path = path;
        return;
    }
}

/// With its own job; null: it carries none, or a damaged one.
Result<std::unique_ptr<TraceRecording>> open_with_own_job(const OpenOptions& options,
                                                          std::vector<session::Phrase>& warnings,
                                                          const Progress& progress) {
    auto blob = verify::first_carried_job(options.path);
    if (blob && !*blob) return std::unique_ptr<TraceRecording>{};
    Snapshot snapshot;
    if (blob) snapshot.job_blob = std::move(**blob);
    auto job = blob ? cam::prepare_snapshot(std::move(snapshot), options.path) : blob.error();
    if (!job) {
        warnings.push_back(session::error_phrase(job.error()));
        return std::unique_ptr<TraceRecording>{};
    }
    Company company{options.path, std::make_shared<const cam::PreparedJob>(std::move(*job)), {}, {}, true};
    add_records_beside(company, warnings);
    return TraceRecording::open(options.path, company, options.profile, progress);
}

Result<std::unique_ptr<Recording>> as_recording(Result<std::unique_ptr<TraceRecording>> opened) {
    if (!opened) return opened.error();
    return std::unique_ptr<Recording>{std::move(*opened)};
}

/// With the job that it carries; else with the first neighbour of the same run.
Result<std::unique_ptr<Recording>> open_with_company(const OpenOptions& options, const Progress& progress) {
    std::vector<std::string> refused;
    std::vector<session::Phrase> warnings;  // of those that cannot be read
    auto own = open_with_own_job(options, warnings, progress);
    if (!own) return own.error();
    std::unique_ptr<TraceRecording> made = std::move(*own);
    if (made) {
        for (session::Phrase& warning : warnings) made->warn(std::move(warning));
        return std::unique_ptr<Recording>{std::move(made)};
    }
    for (const std::string& path : companies_beside(options.path)) {
        const auto company = company_of(path);
        if (!company) {
            warnings.push_back(session::error_phrase(company.error()));
            continue;
        }
        auto opened = TraceRecording::open(options.path, *company, options.profile, progress);
        if (!opened) return opened.error();
        made = std::move(*opened);
        if (made) break;
        refused.push_back(path);
    }
    if (!made) {
        auto alone = TraceRecording::open(options.path, {}, options.profile, progress);
        if (!alone) return alone.error();
        made = std::move(*alone);
    }
    for (const std::string& path : refused) made->tell_refused(path);
    for (session::Phrase& warning : warnings) made->warn(std::move(warning));
    return std::unique_ptr<Recording>{std::move(made)};
}

}  // namespace

bool is_recording(const std::string& path) {
    return verify::is_binary_trace(path) || is_snapshot_of_a_machine(path);
}

Result<std::unique_ptr<Recording>> open_recording(const OpenOptions& options, const Progress& progress) {
    if (!verify::is_binary_trace(options.path)) return SnapshotRecording::open(options.path);
    if (options.job_path.empty()) return open_with_company(options, progress);
    auto company = company_of(options.job_path);
    if (!company) return company.error();
    company->is_asked_for = true;
    const auto fits =
        verify::check_is_of_trace(options.path, job_checksum(company->job->blob), options.job_path);
    if (!fits) return fits.error();
    return as_recording(TraceRecording::open(options.path, *company, options.profile, progress));
}

}  // namespace psicarve::replay
