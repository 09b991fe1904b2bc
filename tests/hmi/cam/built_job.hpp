// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>

#include "hmi/cam/job_builder.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {

inline JobOptions small(std::uint32_t layers, std::uint32_t points) {
    JobOptions options;
    options.layer_count = layers;
    options.point_count = points;
    return options;
}

inline BuiltJob built(const model::Mesh& mesh, const Profile& profile, const JobOptions& options) {
    auto job = build_job(mesh, profile, options);
    EXPECT_TRUE(job.has_value()) << (job ? "" : job.error().message);
    return job ? std::move(*job) : BuiltJob{};
}

/// Why there is no such job; difference_found where there is one.
inline Error refused(const model::Mesh& mesh, const Profile& profile, const JobOptions& options) {
    const auto job = build_job(mesh, profile, options);
    EXPECT_FALSE(job.has_value());
    return job ? Error{ErrorCode::difference_found, ""} : job.error();
}

inline std::int32_t left(const JobTable& table, std::size_t layer, std::size_t point) {
    return table.r_left_pulses[layer * table.point_count + point];
}
inline std::int32_t right(const JobTable& table, std::size_t layer, std::size_t point) {
    return table.r_right_pulses[layer * table.point_count + point];
}

/// An upright oblong: 6 along x, 10 along y.
inline model::Mesh oblong() {
    return shapes::box({-3, -5, 0}, {3, 5, 8});
}

}  // namespace psicarve::cam
