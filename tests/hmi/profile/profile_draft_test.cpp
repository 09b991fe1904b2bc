// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/profile_draft.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/hmi/profile/key_named.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::profile {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

constexpr const char* kMachine =
    "# bought in 2012\n"
    "name = \"old one\"\n"
    "[axis.r1]\n"
    "speed_mm_s = 8   # the left screw is worn\n"
    "start_stop_mm_s = 0.9\n";

class ProfileFile : public testing::Test {
protected:
    ProfileFile() { write(path, kMachine); }

    static void write(const std::string& to, const std::string& text) { std::ofstream(to) << text; }
    static std::string read(const std::string& from) {
        std::ifstream file(from);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    ProfileDraft opened() const {
        auto draft = ProfileDraft::open(path);
        EXPECT_TRUE(draft.has_value()) << (draft ? "" : draft.error().message);
        return draft ? std::move(*draft) : ProfileDraft();
    }

    TemporaryFolder folder;
    const std::string path = folder.path("machine.toml");
    const std::size_t speed = key_named("axis.r1.speed_mm_s");
    const std::size_t start_stop = key_named("axis.r1.start_stop_mm_s");
};

TEST(ProfileDraft, OfTheBuiltInProfileHasNothingToSay) {
    const ProfileDraft sut;
    EXPECT_EQ(sut.changed_count(), 0U);
    EXPECT_EQ(sut.problem_count(), 0U);
    EXPECT_EQ(sut.profile().value(), Profile{});
    for (std::size_t i = 0; i < profile_keys().size(); ++i) EXPECT_FALSE(sut.differs_from_built_in(i));
}

TEST_F(ProfileFile, ShowsWhatItSays) {
    const ProfileDraft sut = opened();
    EXPECT_EQ(sut.typed(speed), "8.0");
    EXPECT_TRUE(sut.differs_from_built_in(speed));
    EXPECT_FALSE(sut.is_changed(speed));
    EXPECT_FALSE(sut.differs_from_built_in(key_named("axis.r2.speed_mm_s")));
    EXPECT_EQ(sut.profile()->r1.speed_mm_s, 8.0);
}

TEST_F(ProfileFile, ChecksEachValueAtOnce) {
    ProfileDraft sut = opened();
    sut.type(speed, "fast");
    EXPECT_THAT(sut.problem(speed), HasSubstr("no number"));
    sut.type(start_stop, "-3");
    EXPECT_THAT(sut.problem(start_stop), HasSubstr("impossible"));
    EXPECT_EQ(sut.problem_count(), 2U);
    EXPECT_FALSE(sut.profile());
    EXPECT_FALSE(sut.save());
    EXPECT_EQ(read(path), kMachine);
    sut.type(speed, "7,5");
    EXPECT_EQ(sut.problem(speed), "");
    sut.type(start_stop, "7.6");
    EXPECT_NE(sut.problem(start_stop), "") << "above the speed";
    sut.type(start_stop, "0.9");
    EXPECT_EQ(sut.problem_count(), 0U);
    EXPECT_EQ(sut.changed_count(), 1U);
    sut.undo(speed);
    EXPECT_EQ(sut.changed_count(), 0U);
}

TEST_F(ProfileFile, KeepsCommentsAndABackup) {
    ProfileDraft sut = opened();
    sut.type(speed, "9");
    sut.type(key_named("tick.period_us"), "40");
    ASSERT_TRUE(sut.save());
    EXPECT_EQ(read(path),
              "# bought in 2012\nname = \"old one\"\n[axis.r1]\nspeed_mm_s = 9.0   # the left screw is worn\n"
              "start_stop_mm_s = 0.9\n\n[tick]\nperiod_us = 40.0\n");
    EXPECT_EQ(read(ProfileDraft::backup_path(path)), kMachine);
    EXPECT_EQ(sut.changed_count(), 0U);
    EXPECT_EQ(load_profile(path).value(), sut.profile().value());
    ASSERT_TRUE(sut.take_backup(ProfileDraft::backup_path(path)));
    EXPECT_EQ(sut.typed(speed), "8.0");
    EXPECT_EQ(sut.changed_count(), 2U);
    EXPECT_EQ(sut.saved(speed), "9.0");
}

TEST_F(ProfileFile, KeepsItsLastBackups) {
    ProfileDraft sut = opened();
    for (const char* speed_mm_s : {"11", "12", "13", "14", "15", "16", "17"}) {
        sut.type(speed, speed_mm_s);
        ASSERT_TRUE(sut.save());
    }
    const auto speed_in = [](const std::string& file) { return load_profile(file).value().r1.speed_mm_s; };
    EXPECT_EQ(speed_in(path), 17.0);
    EXPECT_EQ(speed_in(ProfileDraft::backup_path(path)), 16.0);
    EXPECT_EQ(speed_in(ProfileDraft::older_backup_path(path, 1)), 15.0);
    EXPECT_EQ(speed_in(ProfileDraft::older_backup_path(path, ProfileDraft::kOlderBackups)), 12.0);
    EXPECT_FALSE(load_profile(ProfileDraft::older_backup_path(path, ProfileDraft::kOlderBackups + 1)));
}

TEST_F(ProfileFile, KeepsItsWayOfWriting) {
    write(path, "axis = { r1 = { speed_mm_s = 8 } }  # all in one line\r\n# the end");
    ProfileDraft sut = opened();
    EXPECT_EQ(sut.typed(speed), "8.0");
    sut.type(speed, "9");
    ASSERT_TRUE(sut.save());
    EXPECT_EQ(read(path), "axis = { r1 = { speed_mm_s = 9.0 } }  # all in one line\r\n# the end");
    EXPECT_EQ(load_profile(path)->r1.speed_mm_s, 9.0);
}

TEST_F(ProfileFile, TakesKeysOfATableThatItWroteWithinBraces) {
    write(path, "axis = { r1 = { speed_mm_s = 8 } }\n");
    ProfileDraft sut = opened();
    sut.type(key_named("axis.r2.speed_mm_s"), "7");
    sut.type(key_named("axis.r2.start_stop_mm_s"), "0.5");
    const auto saved = sut.save();
    ASSERT_TRUE(saved) << saved.error().message;
    EXPECT_EQ(load_profile(path)->r2.speed_mm_s, 7.0);
    EXPECT_EQ(load_profile(path)->r2.start_stop_mm_s, 0.5);
}

// One wrong value must not change how the others are read.
TEST_F(ProfileFile, ShowsWhatItSaysHoweverThatIsWrittenBesideAWrongValue) {
    write(path,
          "name = \"\"\"\nC:\\u005cnew\"\"\"\n[axis.r1]\ntravel_mm = [\n  0, # in, and\n  20,\n]\nspeed_mm_s "
          "= -8\n");
    ProfileDraft sut = opened();
    EXPECT_EQ(sut.problem_count(), 1U);
    EXPECT_EQ(sut.typed(key_named("name")), "C:\\new");
    EXPECT_EQ(sut.typed(key_named("axis.r1.travel_mm")), "0.0 ... 20.0");
    EXPECT_EQ(sut.typed(speed), "-8");
    EXPECT_EQ(sut.changed_count(), 0U);
}

TEST_F(ProfileFile, ThatIsALinkStaysOne) {
    const std::string link = path + ".link";
    std::filesystem::create_symlink(path, link);
    auto sut = ProfileDraft::open(link);
    ASSERT_TRUE(sut);
    sut->type(key_named("name"), "new one");
    ASSERT_TRUE(sut->save());
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_THAT(read(path), HasSubstr("new one")) << "its own file is the one that is written";
}

TEST_F(ProfileFile, ThatSomebodyElseChangedIsNotOverwritten) {
    ProfileDraft sut = opened();
    sut.type(speed, "9");
    write(path, "name = \"new one\"\n");
    const auto saved = sut.save();
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().message, HasSubstr("somebody has changed this file"));
    EXPECT_EQ(read(path), "name = \"new one\"\n");
    ASSERT_TRUE(sut.save_as(folder.path("other.toml")));
    EXPECT_EQ(sut.path(), folder.path("other.toml"));
    EXPECT_EQ(load_profile(sut.path())->r1.speed_mm_s, 9.0);
}

TEST_F(ProfileFile, WithWrongValuesOpensAndShowsThem) {
    write(path, "[axis.r1]\nspeed_mm_s = -8\nhome = \"left\"\n");
    ProfileDraft sut = opened();
    EXPECT_EQ(sut.problem_count(), 2U);
    EXPECT_EQ(sut.typed(speed), "-8");
    EXPECT_EQ(sut.typed(key_named("axis.r1.home")), "left");
    sut.type(speed, "8");
    sut.type(key_named("axis.r1.home"), "min");
    sut.type(key_named("axis.r1.home_position_mm"), "0");
    EXPECT_EQ(sut.problem_count(), 0U);
    ASSERT_TRUE(sut.save());
    EXPECT_EQ(load_profile(path)->r1.home, HomeSensor::min);
}

TEST_F(ProfileFile, ThatIsNoProfileIsRefused) {
    for (const char* text : {"speed = \n", "[axis.r1]\nzebra = 1\n", "\x7f\x45\x4c\x46",
                             "[axis.r1.home]\nx = 1\n", "[[axis.r1.speed_mm_s]]\n", "axis = 3\n"}) {
        write(path, text);
        const auto draft = ProfileDraft::open(path);
        ASSERT_FALSE(draft) << text;
        EXPECT_THAT(draft.error().message, HasSubstr("machine.toml:"));
    }
    EXPECT_FALSE(ProfileDraft::open(folder.path("none.toml")));
}

TEST(ProfileDraft, TheBuiltInProfileIsSavedUnderAName) {
    const TemporaryFolder folder;
    ProfileDraft sut;
    EXPECT_FALSE(sut.save());
    ASSERT_TRUE(sut.save_as(folder.path("new.toml")));
    EXPECT_EQ(load_profile(folder.path("new.toml")).value(), Profile{});
    EXPECT_FALSE(sut.save_as(folder.path("no/such/folder.toml")));
    EXPECT_EQ(sut.path(), folder.path("new.toml"));
}

}  // namespace
}  // namespace psicarve::profile
