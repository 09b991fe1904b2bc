// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/remedy.hpp"

#include <gtest/gtest.h>

#include "hmi/cam/job_builder.hpp"
#include "shared/base/message_text.hpp"
#include "shared/wording/wording.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::session {
namespace {

using Kind = Remedy::Kind;

struct Refused {
    Error error;
    std::vector<Remedy> remedies;
};

/// The error and the remedies for a mesh that cannot be sliced like this.
Refused refused(const model::Mesh& mesh, const cam::JobOptions& options, const Profile& profile = {}) {
    const auto job = cam::build_job(mesh, profile, options);
    if (job) return {{ErrorCode::bad_input, "it can be sliced"}, {}};
    return {job.error(), slicing_remedies(job.error(), mesh, profile, options)};
}

cam::JobOptions few_layers() {
    cam::JobOptions options;
    options.layer_count = 12;
    options.point_count = 20;
    return options;
}

TEST(Remedies, GiveTheHeightAtWhichTheModelFitsAndNoMore) {
    const model::Mesh tall = shapes::cylinder(8.0, 0.0, 400.0, 40);
    cam::JobOptions options = few_layers();
    options.layer_count = 500;  // the topmost stands half a layer below the top
    const Refused sut = refused(tall, options);
    ASSERT_EQ(sut.remedies.size(), 1U) << sut.error.message;
    EXPECT_EQ(sut.remedies[0].kind, Kind::height);
    options.height_mm = sut.remedies[0].value;
    EXPECT_TRUE(cam::build_job(tall, Profile{}, options)) << sut.remedies[0].value;
    options.height_mm = sut.remedies[0].value + 0.3;
    EXPECT_FALSE(cam::build_job(tall, Profile{}, options)) << sut.remedies[0].value;
}

TEST(Remedies, TakeTheOtherSizeThatWasAskedForAway) {
    const model::Mesh small = shapes::cylinder(8.0, 0.0, 20.0, 40);
    cam::JobOptions options = few_layers();
    options.scale = 30.0;
    const Refused sut = refused(small, options);
    ASSERT_EQ(sut.remedies.size(), 1U) << sut.error.message;
    options.scale.reset();
    options.height_mm = sut.remedies[0].value;
    EXPECT_TRUE(cam::build_job(small, Profile{}, options)) << sut.remedies[0].value;
}

TEST(Remedies, AreNoneWhereNothingWouldFit) {
    Profile profile;
    profile.job.base_height_mm = 200.0;  // above all travel
    EXPECT_TRUE(refused(shapes::cylinder(8.0, 0.0, 400.0, 40), few_layers(), profile).remedies.empty());
}

TEST(Remedies, ScaleWhatIsInAnotherUnitUnlessASizeWasAskedFor) {
    const Error inches{ErrorCode::bad_input,
                       "m.stl: lies wholly within the core radius of 1.50 mm: nothing but a plain rod would "
                       "be carved; it is 1.00 x 1.00 x 2.00 mm large: are its units inches (--scale 25.4)?"};
    const model::Mesh mesh = shapes::cylinder(0.5, 0.0, 2.0, 40);
    EXPECT_EQ(slicing_remedies(inches, mesh, {}, {}), (std::vector<Remedy>{{Kind::scale, 25.4}}));
    cam::JobOptions sized;
    sized.scale = 2.0;
    EXPECT_TRUE(slicing_remedies(inches, mesh, {}, sized).empty());
}

TEST(Remedies, GiveTheMostLayersThatThereArePulsesFor) {
    cam::JobOptions options = few_layers();
    options.layer_count = 20'000;
    const model::Mesh low = shapes::cylinder(8.0, 0.0, 2.0, 40);
    const Refused sut = refused(low, options);
    ASSERT_EQ(sut.remedies.size(), 1U) << sut.error.message;
    EXPECT_EQ(sut.remedies[0].kind, Kind::layers);
    options.layer_count = static_cast<std::uint32_t>(sut.remedies[0].value);
    EXPECT_TRUE(cam::build_job(low, Profile{}, options)) << sut.remedies[0].value;
    *options.layer_count += 2;
    EXPECT_FALSE(cam::build_job(low, Profile{}, options));
}

TEST(Remedies, LookForAnAxisInTheModelOnceTheChosenOneMissesIt) {
    cam::JobOptions options = few_layers();
    options.axis_at = cam::AxisAt::point;
    options.axis_x = 400.0;
    options.axis_y = 13.0;
    const model::Mesh mesh = shapes::cylinder(8.0, 0.0, 20.0, 40);
    EXPECT_EQ(refused(mesh, options).remedies, (std::vector<Remedy>{{Kind::best_axis}}))
        << refused(mesh, options).error.message;
}

TEST(Remedies, SliceAgainByTheCoresProfile) {
    const Error refused =
        error_from(ErrorCode::machine_refused,
                   with_text(message_of(MessageId::job_for_other_machine), "axis.r1.pulses_per_mm"));
    EXPECT_EQ(publishing_remedies(refused), (std::vector<Remedy>{{Kind::core_profile}}));
    EXPECT_TRUE(publishing_remedies({ErrorCode::no_core, "no core"}).empty());
}

TEST(Remedies, SayWhatTheyDo) {
    const auto text = [](Remedy remedy) { return in_english(remedy_text(remedy)); };
    EXPECT_EQ(text({Kind::height, 149.9}), "Height 149.9 mm");
    EXPECT_EQ(text({Kind::scale, 25.4}), "Scale 25.4");
    EXPECT_EQ(text({Kind::scale, 1000.0}), "Scale 1\u2009000");
    EXPECT_EQ(text({Kind::layers, 300.0}), "300 layers");
    EXPECT_EQ(text({Kind::best_axis}), "Axis: least lost");
    EXPECT_EQ(text({Kind::core_profile}), "Use the core's profile");
}

}  // namespace
}  // namespace psicarve::session
