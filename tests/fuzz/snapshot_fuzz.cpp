// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/fuzz/require.hpp"

namespace {

using namespace psicarve;
using fuzz::require;
using Bytes = std::vector<std::byte>;

const std::string& default_profile_text() {
    static const std::string s_text = profile_to_toml(Profile{});
    return s_text;
}

/// Every field a job offers is looked at: what the check let through must be safe to use.
void use_job(const Bytes& blob) {
    const auto job = JobView::check(blob);
    require(job.has_value(), "a snapshot's job passes its own check");
    std::uint64_t sum = 0;
    for (std::uint32_t layer = 0; layer < job->layer_count(); ++layer) {
        sum += static_cast<std::uint64_t>(job->y_pulses(layer, job->point_count() / 2));
        require(job->pass_of(layer) < job->passes().size() && job->pass_end(layer) > layer,
                "a layer has a pass");
        for (const std::int32_t radius : job->r_left_pulses(layer)) sum += static_cast<std::uint32_t>(radius);
        for (const std::int32_t radius : job->r_right_pulses(layer))
            sum += static_cast<std::uint32_t>(radius);
    }
    // A use of the sum, so that the compiler reads every cell.
    static std::uint64_t s_last_sum = 0;
    require(std::exchange(s_last_sum, sum) != 1 || job->layer_count() > 0, "a job has layers");
    require(job->source_name().size() < sizeof(JobHeader::source_name), "the source's name ends");
    (void)check_job(*job, Profile{}).has_value();
    // Reading the profile takes most of the time, and profile_fuzz is there for it: only what was changed.
    if (job->profile_toml() == default_profile_text()) return;
    if (const auto profile = job_profile(*job)) (void)check_job(*job, *profile).has_value();
}

void parse_and_use(const Bytes& bytes) {
    const auto snapshot = parse_snapshot(bytes, "f.psi");
    if (!snapshot) {
        require(snapshot.error().message.starts_with("f.psi: "), "a refusal names the file");
        return;
    }
    const auto again = parse_snapshot(snapshot_bytes(*snapshot), "again");
    require(again.has_value() && again->job_blob == snapshot->job_blob,
            "what parses can be saved and parsed");
    require(again->records.size() == snapshot->records.size(), "records are kept");
    const bool has_source = snapshot->source != nullptr;
    require(has_source == (again->source != nullptr), "a program's source is kept");
    require(
        !has_source || std::memcmp(snapshot->source.get(), again->source.get(), sizeof(RecordedSource)) == 0,
        "a program's source is kept as it was");
    if (!snapshot->job_blob.empty()) use_job(snapshot->job_blob);
}

/// The checksum guards everything behind it; with a right one the fuzzer gets in.
void fix_checksum(Bytes& bytes) {
    if (bytes.size() < sizeof(SnapshotHeader)) return;
    const std::uint64_t checksum = snapshot_checksum(bytes);
    std::memcpy(bytes.data() + offsetof(SnapshotHeader, checksum), &checksum, sizeof(checksum));
}

Bytes valid_file() {
    JobTable table;
    table.layer_count = 3;
    table.point_count = 4;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    table.layer_height_pulses = {100, 200, 300};
    table.r_left_pulses.assign(12, 5000);
    table.r_right_pulses.assign(12, 6000);
    table.source_name = "seed.stl";
    table.profile_toml = default_profile_text();
    table.report_json = "{}";
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(table);
    snapshot.status.emplace();
    snapshot.records.resize(2);
    return snapshot_bytes(snapshot);
}

/// A valid file with the input as edits of four bytes: where (two), how, and with what.
Bytes edited_file(std::span<const std::uint8_t> edits) {
    static const Bytes s_valid = valid_file();
    Bytes bytes = s_valid;
    for (; edits.size() >= 4; edits = edits.subspan(4)) {
        const std::size_t place = (edits[0] + 256U * edits[1]) % bytes.size();
        const auto value = static_cast<std::byte>(edits[3]);
        if (edits[2] % 4 == 0) bytes[place] = value;
        if (edits[2] % 4 == 1) bytes[place] ^= value;
        if (edits[2] % 4 == 2) bytes.resize(bytes.size() + edits[3] % 64);
        if (edits[2] % 4 == 3) bytes.resize(bytes.size() - edits[3] % 64 % bytes.size());
    }
    return bytes;
}

}  // namespace

// Any bytes: refused in one line, or a snapshot that saves, parses back equal and whose job can be used.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span input{data, size};
    Bytes raw(size);
    if (size != 0) std::memcpy(raw.data(), data, size);
    parse_and_use(raw);
    fix_checksum(raw);
    parse_and_use(raw);
    Bytes edited = edited_file(input);
    fix_checksum(edited);
    parse_and_use(edited);
    return 0;
}
