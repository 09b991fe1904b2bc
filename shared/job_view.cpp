// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>

#include "shared/job.hpp"
#include "shared/job_layout.hpp"

namespace psicarve {
namespace {

Error not_a_job(const std::string& what) {
    return bad_input("job: " + what + "; make the job again");
}

std::string text_of(std::uint64_t number) {
    return std::to_string(number);
}

Result<void> check_counts(const JobHeader& header) {
    if (header.layer_count < 1 || header.layer_count > kMaxJobCount) {
        return not_a_job(text_of(header.layer_count) + " layers, where 1 to " + text_of(kMaxJobCount) +
                         " are possible");
    }
    if (header.point_count < 2 || header.point_count > kMaxJobCount) {
        return not_a_job(text_of(header.point_count) + " points in a layer, where 2 to " +
                         text_of(kMaxJobCount) + " are possible");
    }
    if (header.profile_bytes > kProfileTextBytes) {
        return not_a_job("a profile of " + text_of(header.profile_bytes) + " bytes, where " +
                         text_of(kProfileTextBytes) + " is the most");
    }
    if (header.report_bytes > kReportTextBytes) {
        return not_a_job("a report of " + text_of(header.report_bytes) + " bytes, where " +
                         text_of(kReportTextBytes) + " is the most");
    }
    return {};
}

Result<void> check_places(const JobHeader& header, std::uint64_t blob_bytes) {
    const JobLayout layout =
        job_layout(header.layer_count, header.point_count, header.profile_bytes, header.report_bytes);
    if (header.total_bytes != layout.total_bytes || blob_bytes != layout.total_bytes) {
        return not_a_job("its size is " + text_of(blob_bytes) + " bytes, it says " +
                         text_of(header.total_bytes) + ", and its counts need " +
                         text_of(layout.total_bytes));
    }
    if (header.profile_offset != layout.profile_offset || header.report_offset != layout.report_offset ||
        header.heights_offset != layout.heights_offset || header.r_left_offset != layout.r_left_offset ||
        header.r_right_offset != layout.r_right_offset) {
        return not_a_job("its parts do not stand where its counts put them");
    }
    return {};
}

Result<void> check_values(const JobHeader& header) {
    if (header.joining > static_cast<std::uint32_t>(Joining::spiral)) {
        return not_a_job("its way to join the layers is the unknown number " + text_of(header.joining));
    }
    for (const std::int32_t sign : header.direction_sign) {
        if (sign != 1 && sign != -1) {
            return not_a_job("a direction sign is " + std::to_string(sign) + ", neither 1 nor -1");
        }
    }
    if (header.reserved != 0) return not_a_job("a field that must be 0 is not");
    if (!std::isfinite(header.feed_mm_s) || !(header.feed_mm_s > 0.0)) {
        return not_a_job("its feed is no speed above 0 mm/s");
    }
    if (header.psi_sweep_pulses < 1 || header.psi_sweep_pulses > kMaxSweepPulses) {
        return not_a_job("a layer sweeps " + std::to_string(header.psi_sweep_pulses) +
                         " pulses of psi, where 1 to " + std::to_string(kMaxSweepPulses) + " are possible");
    }
    const char* const name = static_cast<const char*>(header.source_name);
    const char* const end = std::find(name, name + sizeof header.source_name, '\0');
    if (end == name + sizeof header.source_name) return not_a_job("the source's name does not end");
    // The name goes to terminals: no escape sequences.
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (std::any_of(name, end, is_control)) return not_a_job("the source's name holds a control character");
    return {};
}

/// Heights of points lie between those of rows: with these no sum can overflow.
Result<void> check_spiral_heights(const JobHeader& header, std::span<const std::int64_t> heights_pulses) {
    if (header.joining != static_cast<std::uint32_t>(Joining::spiral)) return {};
    for (const std::int64_t height : heights_pulses) {
        if (height >= -kMaxHeightPulses && height <= kMaxHeightPulses) continue;
        return not_a_job("a row of its spiral ends at the height of " + std::to_string(height) +
                         " pulses, where " + std::to_string(kMaxHeightPulses) + " is the most");
    }
    return {};
}

template <typename T>
std::span<const T> part_of(std::span<const std::byte> blob, std::uint64_t offset, std::uint64_t count) {
    // Alignment: the blob's start and every offset are multiples of 8.
    return {reinterpret_cast<const T*>(blob.data() + offset), static_cast<std::size_t>(count)};
}

}  // namespace

Result<JobView> JobView::check(std::span<const std::byte> blob) {
    if (blob.size() < sizeof(JobHeader)) {
        return not_a_job(text_of(blob.size()) + " bytes are too few for a job's header");
    }
    if (reinterpret_cast<std::uintptr_t>(blob.data()) % alignof(JobHeader) != 0) {
        return not_a_job("it does not stand at a multiple of 8 bytes");
    }
    JobView view;
    view.header_ = reinterpret_cast<const JobHeader*>(blob.data());
    const JobHeader& header = *view.header_;
    if (header.magic != kJobMagic) return not_a_job("it does not begin like one");
    if (auto counts = check_counts(header); !counts) return counts.error();
    if (auto places = check_places(header, blob.size()); !places) return places.error();
    if (auto values = check_values(header); !values) return values.error();

    const std::uint64_t cells = std::uint64_t{header.layer_count} * header.point_count;
    const auto profile = part_of<char>(blob, header.profile_offset, header.profile_bytes);
    const auto report = part_of<char>(blob, header.report_offset, header.report_bytes);
    view.profile_ = {profile.data(), profile.size()};
    view.report_ = {report.data(), report.size()};
    view.heights_ = part_of<std::int64_t>(blob, header.heights_offset, header.layer_count);
    if (auto heights = check_spiral_heights(header, view.heights_); !heights) return heights.error();
    view.r_left_ = part_of<std::int32_t>(blob, header.r_left_offset, cells);
    view.r_right_ = part_of<std::int32_t>(blob, header.r_right_offset, cells);
    return view;
}

std::int32_t JobView::max_radius_pulses(Axis head) const noexcept {
    const auto& radii = head == Axis::r2 ? r_right_ : r_left_;
    return *std::max_element(radii.begin(), radii.end());
}

Result<Profile> job_profile(const JobView& job) {
    return parse_profile(job.profile_toml(), "job's profile");
}

}  // namespace psicarve
