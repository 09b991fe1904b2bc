// SPDX-License-Identifier: GPL-3.0-or-later
#include <xxhash.h>

#include <algorithm>
#include <cassert>
#include <cstring>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/job/job_layout.hpp"

namespace psicarve {
namespace {

/// Copies as much of a name as fits, cut between characters of UTF-8, zero-terminated, control characters
/// replaced.
void copy_name(char (&field)[128], const std::string& name) {
    std::size_t length = std::min(name.size(), sizeof field - 1);
    const auto continues = [&](std::size_t at) {
        return at < name.size() && (static_cast<unsigned char>(name[at]) & 0xC0) == 0x80;
    };
    while (length > 0 && length < name.size() && continues(length)) --length;
    const auto shown = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c; };
    std::transform(name.data(), name.data() + length, static_cast<char*>(field), shown);
}

template <typename Container>
void copy_part(std::vector<std::byte>& blob, std::uint64_t offset, const Container& part) {
    if (part.empty()) return;
    std::memcpy(blob.data() + offset, part.data(), part.size() * sizeof(part[0]));
}

}  // namespace

std::uint64_t job_checksum(std::span<const std::byte> blob) noexcept {
    return XXH3_64bits(blob.data(), blob.size());
}

std::int64_t table_angle_pulses(Joining joining, std::int64_t psi_sweep_pulses, std::int64_t point_count,
                                std::int64_t layer, std::int64_t point) noexcept {
    const std::int64_t within = point_angle_pulses(point, psi_sweep_pulses, point_count);
    return joining == Joining::zigzag ? within : layer * psi_sweep_pulses + within;
}

std::int64_t table_height_pulses(Joining joining, std::span<const std::int64_t> layer_heights_pulses,
                                 std::int64_t point_count, std::size_t layer, std::int64_t point) noexcept {
    const std::int64_t height = layer_heights_pulses[layer];
    if (joining != Joining::spiral || layer == 0) return height;
    const std::int64_t below = layer_heights_pulses[layer - 1];
    return below + point_angle_pulses(point, height - below, point_count);
}

std::uint32_t carved_point(Joining joining, std::uint32_t point_count, std::uint32_t layer,
                           std::uint32_t step) noexcept {
    const bool backwards = joining == Joining::zigzag && layer % 2 == 1;
    return backwards ? point_count - 1 - step : step;
}

std::uint64_t job_blob_bytes(std::uint64_t layer_count, std::uint64_t point_count,
                             std::uint64_t profile_bytes, std::uint64_t report_bytes,
                             std::uint64_t pass_count) noexcept {
    return job_layout(layer_count, point_count, profile_bytes, report_bytes, pass_count).total_bytes;
}

std::vector<std::byte> job_blob_from_table(const JobTable& table) {
    [[maybe_unused]] const std::size_t cells = std::size_t{table.layer_count} * table.point_count;
    assert(table.layer_height_pulses.size() == table.layer_count);
    assert(table.r_left_pulses.size() == cells && table.r_right_pulses.size() == cells);
    const JobLayout layout = job_layout(table.layer_count, table.point_count, table.profile_toml.size(),
                                        table.report_json.size(), table.passes.size());
    JobHeader header{};
    header.magic = kJobMagic;
    header.total_bytes = layout.total_bytes;
    header.layer_count = table.layer_count;
    header.point_count = table.point_count;
    header.psi_sweep_pulses = table.psi_sweep_pulses;
    header.joining = static_cast<std::uint32_t>(table.joining);
    header.pass_count = static_cast<std::uint32_t>(table.passes.size());
    // job_profile() reports a text that is no profile; its signs do not matter then.
    const Result<Profile> parsed = parse_profile(table.profile_toml, "profile");
    const Profile profile = parsed ? *parsed : Profile{};
    for (const Axis axis : kAllAxes) {
        header.direction_sign[index_of(axis)] = axis_motion(profile, axis).positive_is_high ? 1 : -1;
    }
    header.feed_mm_s = table.feed_mm_s;
    header.source_hash = table.source_hash;
    copy_name(header.source_name, table.source_name);
    header.profile_offset = layout.profile_offset;
    header.profile_bytes = table.profile_toml.size();
    header.report_offset = layout.report_offset;
    header.report_bytes = table.report_json.size();
    header.heights_offset = layout.heights_offset;
    header.r_left_offset = layout.r_left_offset;
    header.r_right_offset = layout.r_right_offset;

    std::vector<std::byte> blob(layout.total_bytes);
    std::memcpy(blob.data(), &header, sizeof header);
    copy_part(blob, layout.profile_offset, table.profile_toml);
    copy_part(blob, layout.report_offset, table.report_json);
    copy_part(blob, layout.heights_offset, table.layer_height_pulses);
    copy_part(blob, layout.r_left_offset, table.r_left_pulses);
    copy_part(blob, layout.r_right_offset, table.r_right_pulses);
    copy_part(blob, layout.passes_offset, table.passes);
    return blob;
}

}  // namespace psicarve
