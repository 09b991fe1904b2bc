// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hmi/piece/job_piece.hpp"
#include "hmi/piece/piece_deviation.hpp"
#include "hmi/piece/placed_model.hpp"
#include "tests/hmi/cam/built_job.hpp"

namespace psicarve::piece {

/// A tool for bodies of up to 20 mm about the axis.
inline Profile with_tool(ToolShape shape, double diameter_mm, double angle_deg) {
    Profile profile;
    profile.tool = {shape, diameter_mm, angle_deg, 0.0};
    profile.blank = {22.0, 12.0};
    return profile;
}

/// A job's piece against the model.
inline PieceDeviation carved(const model::Mesh& mesh, const Profile& profile, std::uint32_t layers,
                             std::uint32_t points, std::size_t columns = 720) {
    cam::JobOptions options = cam::small(layers, points);
    options.axis_at = cam::AxisAt::origin;
    const auto built = cam::built(mesh, profile, options);
    const std::vector<std::byte> blob = job_blob_from_table(built.table);
    const auto job = JobView::check(blob);
    const auto placed = place_as_sliced(std::make_shared<const model::Mesh>(mesh), *job, profile);
    EXPECT_TRUE(placed) << (placed ? "" : placed.error().message);
    const auto piece = job_piece(*job, profile, &*placed, columns, {1, {}});
    EXPECT_TRUE(piece);
    return piece->deviation.value();
}

}  // namespace psicarve::piece
