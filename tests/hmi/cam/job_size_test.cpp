// SPDX-License-Identifier: GPL-3.0-or-later
// How large a model may be, and in how many layers and points.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

TEST(JobSize, HeightScalesTheWholeModel) {
    JobOptions options = small(4, 5);
    options.height_mm = 16.0;
    const BuiltJob sut = built(oblong(), Profile{}, options);
    EXPECT_EQ(sut.report.scale, 2.0);
    EXPECT_EQ(left(sut.table, 0, 0), 6 * 400);
    EXPECT_EQ(sut.table.layer_height_pulses.back(), 14 * 400);
}

TEST(JobSize, HeightAndScaleTogetherAreWrongUsage) {
    JobOptions options = small(4, 5);
    options.height_mm = 16.0;
    options.scale = 2.0;
    EXPECT_EQ(refused(oblong(), Profile{}, options).code, ErrorCode::bad_usage);
}

TEST(JobSize, AModelTooWideIsRefusedWithAxisAndMillimetres) {
    JobOptions options = small(4, 5);
    options.scale = 15.0;  // 45 by 75 mm from the axis, 120 high
    const Error sut = refused(oblong(), Profile{}, options);
    EXPECT_EQ(sut.code, ErrorCode::bad_input);
    EXPECT_THAT(sut.message, AllOf(HasSubstr("larger than the machine's travel"), HasSubstr("r1"),
                                   HasSubstr("75.00 mm"), HasSubstr("60.00")));
}

TEST(JobSize, AModelTooHighIsRefusedWithAxisAndMillimetres) {
    JobOptions options = small(400, 5);
    options.height_mm = 200.0;
    const Error sut = refused(shapes::cylinder(1.0, 0.0, 10.0, 12), Profile{}, options);
    EXPECT_THAT(sut.message, AllOf(HasSubstr("larger than the machine's travel"), HasSubstr("axis y"),
                                   HasSubstr("150.00 mm")));
}

TEST(JobSize, AModelOfKilometresIsRefused) {
    JobOptions options = small(4, 5);
    options.scale = 1e30;
    EXPECT_EQ(refused(oblong(), Profile{}, options).code, ErrorCode::bad_input);
}

TEST(JobSize, MorePointsThanPulsesAreRefused) {
    EXPECT_EQ(built(oblong(), Profile{}, small(2, 3201)).table.point_count, 3201U);
    EXPECT_THAT(refused(oblong(), Profile{}, small(2, 3202)).message,
                AllOf(HasSubstr("more points than pulses"), HasSubstr("at most --points 3201")));
}

TEST(JobSize, MoreLayersThanPulsesAreRefused) {
    model::Mesh mesh = oblong();
    mesh.source_name = "oblong.stl";
    EXPECT_THAT(refused(mesh, Profile{}, small(3201, 5)).message,
                AllOf(HasSubstr("oblong.stl: more layers than pulses"), HasSubstr("at most --layers 3200")));
}

TEST(JobSize, ASmallModelGetsNoMoreLayersThanItHasPulses) {
    const BuiltJob sut = built(shapes::cylinder(4.0, 0.0, 0.5, 20), Profile{}, JobOptions{});
    EXPECT_EQ(sut.table.layer_count, 200U);
    EXPECT_EQ(sut.table.point_count, 500U);
    EXPECT_THAT(sut.report.notes, Contains(HasSubstr("200 layers, not 500")));
}

TEST(JobSize, ACoarseTableGetsNoMorePointsThanItHasPulses) {
    Profile profile;
    profile.psi.pulses_per_rev = 400;
    const BuiltJob sut = built(oblong(), profile, JobOptions{});
    EXPECT_EQ(sut.table.point_count, 201U);
    EXPECT_THAT(sut.report.notes, Contains(HasSubstr("201 points a layer, not 500")));
}

TEST(JobSize, AUsualModelGetsTheOriginalsTable) {
    const BuiltJob sut = built(oblong(), Profile{}, JobOptions{});
    EXPECT_EQ(sut.table.layer_count, 500U);
    EXPECT_EQ(sut.table.point_count, 500U);
    EXPECT_TRUE(sut.report.notes.empty());
}

}  // namespace
}  // namespace psicarve::cam
