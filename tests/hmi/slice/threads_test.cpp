// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <vector>

#include "hmi/slice/directions.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::slice {
namespace {

Result<RadialMap> slice_with(unsigned thread_count, const Progress& progress = {}) {
    const model::Mesh mesh = shapes::spring(15.0, 4.0, 3.2, 50.0, 150, 24);
    const std::vector<double> heights =
        layer_heights(mesh.facts.min[2], mesh.facts.max[2] - mesh.facts.min[2], 83);
    return radial_map(mesh, {}, heights, Directions(full_circle_rad(61, 6400, 0.0)),
                      {thread_count, progress});
}

TEST(SliceThreads, GiveTheSameToTheLastBit) {
    const auto one = slice_with(1);
    ASSERT_TRUE(one.has_value());
    for (const unsigned count : {2U, 3U, 7U, 200U}) {
        const auto many = slice_with(count);
        ASSERT_TRUE(many.has_value());
        EXPECT_EQ(one->radius, many->radius) << count;
        for (std::size_t i = 0; i < one->layers.size(); ++i) {
            EXPECT_EQ(one->layers[i].radius_sum, many->layers[i].radius_sum) << count;
            EXPECT_EQ(one->layers[i].hidden_walls, many->layers[i].hidden_walls) << count;
        }
    }
}

TEST(SliceThreads, AllEndWhenProgressSaysSo) {
    const auto sut = slice_with(2, [](double) { return false; });
    ASSERT_FALSE(sut.has_value());
    EXPECT_EQ(sut.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace psicarve::slice
