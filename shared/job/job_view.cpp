// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>

#include "shared/job/job.hpp"
#include "shared/job/job_layout.hpp"

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
    if (header.pass_count > kMaxJobPasses) {
        return not_a_job(text_of(header.pass_count) + " passes, where " + text_of(kMaxJobPasses) +
                         " are the most");
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
    const JobLayout layout = job_layout(header.layer_count, header.point_count, header.profile_bytes,
                                        header.report_bytes, header.pass_count);
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

Result<void> check_pass(const JobPass& pass, std::size_t index, std::uint32_t number_before, bool is_last) {
    const auto wrong = [index](const std::string& what) {
        return not_a_job("pass " + text_of(index) + " " + what);
    };
    const PassKind kind = is_last ? PassKind::finishing : PassKind::roughing;
    if (pass.kind != static_cast<std::uint32_t>(kind)) {
        return wrong("is of kind " + text_of(pass.kind) + ", where " +
                     text_of(static_cast<std::uint32_t>(kind)) + " (" +
                     (is_last ? "finishing, the last" : "roughing, before the last") + ") must be");
    }
    if (pass.number < number_before || pass.number > number_before + 1 || pass.number < 1) {
        return wrong("has the number " + text_of(pass.number) + " after " + text_of(number_before));
    }
    for (const double length_mm : {pass.allowance_mm, pass.depth_mm, pass.clear_mm}) {
        if (!(length_mm >= 0.0 && length_mm <= kMostPassRadius_mm)) {
            return wrong("has a length that is none from 0 to " +
                         text_of(static_cast<std::uint64_t>(kMostPassRadius_mm)) + " mm");
        }
    }
    return {};
}

/// The passes are all layers, one after the other, roughing first.
Result<void> check_passes(std::span<const JobPass> passes, std::uint32_t layer_count) {
    std::uint64_t end = 0;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const JobPass& pass = passes[i];
        if (pass.first_layer != end || pass.layer_count < 1 || pass.layer_count > layer_count - end) {
            return not_a_job("pass " + text_of(i) + " has " + text_of(pass.layer_count) +
                             " layers from layer " + text_of(pass.first_layer) + " on, where " +
                             text_of(end) + " is next of " + text_of(layer_count));
        }
        if (auto checked = check_pass(pass, i, number, i + 1 == passes.size()); !checked) return checked;
        end += pass.layer_count;
        number = pass.number;
    }
    if (!passes.empty() && end != layer_count) {
        return not_a_job("its passes hold " + text_of(end) + " of " + text_of(layer_count) + " layers");
    }
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
    const JobLayout layout = job_layout(header.layer_count, header.point_count, header.profile_bytes,
                                        header.report_bytes, header.pass_count);
    view.passes_ = part_of<JobPass>(blob, layout.passes_offset, header.pass_count);
    if (auto passes = check_passes(view.passes_, header.layer_count); !passes) return passes.error();
    view.whole_ = {static_cast<std::uint32_t>(PassKind::finishing), 1, 0, header.layer_count, 0.0, 0.0, 0.0};
    view.finishing_layer_ = view.passes().back().first_layer;
    return view;
}

std::uint32_t JobView::pass_of(std::uint32_t layer) const noexcept {
    if (layer >= finishing_layer_) return static_cast<std::uint32_t>(passes().size() - 1);
    const auto after =
        std::upper_bound(passes_.begin(), passes_.end(), layer,
                         [](std::uint32_t wanted, const JobPass& pass) { return wanted < pass.first_layer; });
    return static_cast<std::uint32_t>(after - passes_.begin() - 1);
}

std::string pass_name(const JobPass& pass) {
    if (pass.kind == static_cast<std::uint32_t>(PassKind::finishing)) return "finishing pass";
    return "roughing pass " + std::to_string(pass.number);
}

std::int32_t JobView::max_radius_pulses(Axis head) const noexcept {
    const auto& radii = head == Axis::r2 ? r_right_ : r_left_;
    return *std::max_element(radii.begin(), radii.end());
}

std::int32_t JobView::max_finishing_radius_pulses(Axis head) const noexcept {
    const auto finishing =
        (head == Axis::r2 ? r_right_ : r_left_).subspan(std::size_t{finishing_layer_} * point_count());
    return *std::max_element(finishing.begin(), finishing.end());
}

Result<Profile> job_profile(const JobView& job) {
    return parse_profile(job.profile_toml(), "job's profile");
}

}  // namespace psicarve
