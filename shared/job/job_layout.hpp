// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/job/job.hpp"

namespace psicarve {

/// Where the parts of a job blob stand. Five numbers determine it, so that readers need not trust a stored
/// offset.
struct JobLayout {
    std::uint64_t profile_offset;
    std::uint64_t report_offset;
    std::uint64_t heights_offset;
    std::uint64_t r_left_offset;
    std::uint64_t r_right_offset;
    std::uint64_t passes_offset;
    std::uint64_t total_bytes;
};

/// Requires counts up to kMaxJobCount (kMaxJobPasses) and text sizes below 2^32: then no sum here can
/// overflow.
constexpr JobLayout job_layout(std::uint64_t layer_count, std::uint64_t point_count,
                               std::uint64_t profile_bytes, std::uint64_t report_bytes,
                               std::uint64_t pass_count) noexcept {
    const auto aligned = [](std::uint64_t bytes) { return (bytes + 7) & ~std::uint64_t{7}; };
    const std::uint64_t table_bytes = aligned(layer_count * point_count * sizeof(std::int32_t));
    JobLayout layout{};
    layout.profile_offset = sizeof(JobHeader);
    layout.report_offset = aligned(layout.profile_offset + profile_bytes);
    layout.heights_offset = aligned(layout.report_offset + report_bytes);
    layout.r_left_offset = layout.heights_offset + layer_count * sizeof(std::int64_t);
    layout.r_right_offset = layout.r_left_offset + table_bytes;
    layout.passes_offset = layout.r_right_offset + table_bytes;
    layout.total_bytes = layout.passes_offset + pass_count * sizeof(JobPass);
    return layout;
}

}  // namespace psicarve
