// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/trace/carried_job.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

#include "hmi/trace/binary_reader.hpp"
#include "hmi/trace/byte_source.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "shared/job/job.hpp"
#include "shared/trace/trace_format.hpp"

namespace psicarve::verify {
namespace {

using Reader = std::unique_ptr<BinaryReader>;

/// Null: a form or version that carries no job, or a pipe, which can be read only once.
Result<Reader> open_for_jobs(const std::string& path) {
    if (!is_binary_trace(path)) return Reader{};
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return bad_input(path + ": cannot open: " + std::generic_category().message(errno));
    auto reader = BinaryReader::open_binary(ByteSource(descriptor, path));
    if (reader && !(*reader)->start().may_carry_jobs) return Reader{};
    return reader;
}

/// For a file that carries no job: why it is no trace at all, or cannot give one.
Result<void> check_is_trace(const std::string& path, const std::string& remedy) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0)
        return bad_input(path + ": cannot open: " + std::generic_category().message(errno));
    if (S_ISDIR(facts.st_mode)) return bad_input(path + ": is a folder, not a trace");
    if (!S_ISREG(facts.st_mode))
        return bad_input(path + ": a pipe is read once only, and the job is needed first; " + remedy);
    const auto trace = open_trace(path);
    return trace ? Result<void>{} : trace.error();
}

}  // namespace

bool is_binary_trace(const std::string& path) {
    // Without waiting for a writer that a pipe may never have.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return false;
    std::uint64_t magic = 0;
    const bool has_magic = ::pread(descriptor, &magic, sizeof magic, 0) == sizeof magic;
    ::close(descriptor);
    return has_magic && magic == kTraceMagic;
}

Result<std::optional<std::vector<std::byte>>> first_carried_job(const std::string& path) {
    const auto reader = open_for_jobs(path);
    if (!reader) return reader.error();
    if (*reader == nullptr) return std::optional<std::vector<std::byte>>{};
    auto job = (*reader)->next_job(true);
    if (!job) return job.error();
    if (!*job) return std::optional<std::vector<std::byte>>{};
    return std::optional{std::move((*job)->blob)};
}

Result<std::optional<std::vector<std::byte>>> only_carried_job(const std::string& path,
                                                               const std::string& remedy) {
    const auto reader = open_for_jobs(path);
    if (!reader) return reader.error();
    if (*reader == nullptr) return std::optional<std::vector<std::byte>>{};
    auto first = (*reader)->next_job(true);
    if (!first) return first.error();
    if (!*first) return std::optional<std::vector<std::byte>>{};
    for (;;) {
        const auto job = (*reader)->next_job(false);
        if (!job || !*job) break;  // the trace's reader reports damage behind it
        if ((*job)->checksum != (*first)->checksum)
            return bad_input(std::string{path}.append(": carries several jobs; ").append(remedy));
    }
    return std::optional{std::move((*first)->blob)};
}

Result<std::vector<std::byte>> require_carried_job(const std::string& path, const std::string& remedy) {
    auto job = first_carried_job(path);
    if (!job) return job.error();
    if (*job) return std::move(**job);
    if (const auto trace = check_is_trace(path, remedy); !trace) return trace.error();
    return bad_input(path + ": carries no job; " + remedy);
}

Result<void> check_is_of_trace(const std::string& trace_path, std::uint64_t checksum,
                               const std::string& job_path) {
    const auto reader = open_for_jobs(trace_path);
    if (!reader || *reader == nullptr) return {};
    bool carries_another = false;
    for (;;) {
        const auto job = (*reader)->next_job(true, BinaryReader::WhenDamaged::returns);
        if (!job || !*job) break;
        if ((*job)->checksum == checksum) return {};
        if (job_checksum((*job)->blob) == (*job)->checksum) carries_another = true;
    }
    if (!carries_another) return {};
    return bad_input(job_path + ": is not the job that " + trace_path +
                     " carries; leave it out, or name the right one");
}

}  // namespace psicarve::verify
