// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of which user may use a segment, and which may not.
#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <string>

#include "shared/segment/segment.hpp"
#include "shared/segment/segment_object.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;

class SegmentRights : public testing::Test {
protected:
    Segment make() {
        auto made = Segment::create_or_attach(name_.options());
        EXPECT_TRUE(made.has_value()) << made.error().message;
        return std::move(made).value();
    }
    std::string path() const { return "/dev/shm" + name_.get(); }
    struct stat facts() const {
        struct stat facts {};
        EXPECT_EQ(::stat(path().c_str(), &facts), 0);
        return facts;
    }
    std::string refusal() {
        const auto attached = Segment::attach(name_.get());
        const auto created = Segment::create_or_attach(name_.options());
        EXPECT_FALSE(attached.has_value());
        EXPECT_FALSE(created.has_value());
        if (attached || created) return "was not refused";
        EXPECT_EQ(attached.error().message, created.error().message);
        EXPECT_THAT(attached.error().message, HasSubstr(name_.get()));
        EXPECT_THAT(attached.error().message, HasSubstr("--segment"));
        return attached.error().message;
    }
    /// Makes the object another user's. Only root can: false when we are not.
    bool give_away_to(uid_t user, gid_t group = static_cast<gid_t>(-1)) {
        return ::chown(path().c_str(), user, group) == 0;
    }
    /// What the rule that attaching asks says of our object, were it another user's; empty: it may be used.
    std::string rule_for_owner(uid_t user, const std::string& group, gid_t owner_group = 0) {
        struct stat changed = facts();
        changed.st_uid = user;
        changed.st_gid = owner_group;
        const auto judged = check_segment_owner(name_.get(), changed, group);
        return judged ? "" : judged.error().message;
    }
    test::SegmentName name_;
};

TEST_F(SegmentRights, AnotherUsersIsRefused) {
    { const Segment segment = make(); }
    if (!give_away_to(12345)) {
        EXPECT_THAT(rule_for_owner(12345, ""), HasSubstr("uid 12345"));
        return;
    }
    EXPECT_THAT(refusal(), HasSubstr("uid 12345"));
}

TEST_F(SegmentRights, OneThatEverybodyMayWriteIsRefused) {
    { const Segment segment = make(); }
    ASSERT_EQ(::chmod(path().c_str(), 0666), 0);

    EXPECT_THAT(refusal(), HasSubstr("every user may read or write it"));
}

/// A group that we may give a file to: for root one that is not its own.
const ::group& group_of_ours() {
    std::array<gid_t, 64> ours{::getegid()};
    const int count = ::geteuid() == 0 ? 0 : ::getgroups(static_cast<int>(ours.size()), ours.data());
    const gid_t another =
        ::geteuid() == 0 ? gid_t{1} : ours[count > 0 ? static_cast<std::size_t>(count) - 1 : 0];
    return *::getgrgid(another);
}

TEST_F(SegmentRights, GroupGetsItWithReadAndWrite) {
    const ::group group = group_of_ours();
    SegmentOptions options = name_.options();
    options.group = group.gr_name;
    ASSERT_TRUE(Segment::create_or_attach(options).has_value());

    EXPECT_EQ(facts().st_mode & 0777U, 0660U);
    EXPECT_EQ(facts().st_gid, group.gr_gid);
}

TEST_F(SegmentRights, AGroupsServiceUserIsTrustedByThoseWhoNameTheGroup) {
    // Group and user of this name exist on every Debian, both with the number 1.
    constexpr uid_t kDaemon = 1;
    { const Segment segment = make(); }
    ASSERT_EQ(::chmod(path().c_str(), 0660), 0);
    if (!give_away_to(kDaemon, kDaemon)) {
        EXPECT_EQ(rule_for_owner(kDaemon, "daemon", kDaemon), "");
        EXPECT_THAT(rule_for_owner(kDaemon, "daemon", kDaemon + 1),
                    HasSubstr("and is not of group daemon: choose another name"));
        EXPECT_THAT(rule_for_owner(kDaemon, ""), HasSubstr("uid 1"));
        EXPECT_THAT(rule_for_owner(kDaemon, "bin"), HasSubstr("uid 1"));
        return;
    }
    EXPECT_TRUE(Segment::attach(name_.get(), "daemon").has_value());
    EXPECT_FALSE(Segment::attach(name_.get()).has_value());
    EXPECT_FALSE(Segment::attach(name_.get(), "bin").has_value());
}

TEST_F(SegmentRights, OneThatAMemberOfTheGroupMadeFirstIsUsed) {
    const passwd* const nobody = ::getpwnam("nobody");
    ASSERT_NE(nobody, nullptr);
    const std::string group = ::getgrgid(nobody->pw_gid)->gr_name;
    struct stat found {};
    found.st_mode = S_IFREG | 0660;
    found.st_uid = nobody->pw_uid;
    found.st_gid = nobody->pw_gid;
    const auto rule = [&](const std::string& named) {
        const auto judged = check_segment_owner("/x", found, named);
        return judged ? std::string{} : judged.error().message;
    };
    EXPECT_EQ(rule(group), "");
    EXPECT_THAT(rule(""), HasSubstr("belongs to user nobody"));
    EXPECT_THAT(rule("daemon"), HasSubstr("is not of group daemon"));
    found.st_mode = S_IFREG | 0640;
    EXPECT_THAT(rule(group), HasSubstr("mode 0640, not 0660"));
    found.st_mode = S_IFREG | 0666;
    EXPECT_THAT(rule(group), HasSubstr("every user"));
    found.st_mode = S_IFREG | 0660;
    found.st_uid = 54321;
    EXPECT_THAT(rule(group), HasSubstr("no member of group")) << "anybody could give it to a group";
}

TEST_F(SegmentRights, ACoreGivesWhatItFindsTheRightsThatItWasStartedWith) {
    const ::group group = group_of_ours();
    const std::string group_name = group.gr_name;
    Segment segment = make();
    const auto mode = [&] { return facts().st_mode & 0777U; };
    ASSERT_TRUE(segment.fit_rights(group_name));
    EXPECT_EQ(mode(), 0660U);
    EXPECT_EQ(facts().st_gid, group.gr_gid);
    ASSERT_TRUE(segment.fit_rights(""));
    EXPECT_EQ(mode(), 0600U) << "an earlier core's group has nothing to do with it";
    EXPECT_FALSE(segment.fit_rights("no-such-group-here"));
    const auto attached = Segment::attach(name_.get(), "no-such-group-here");
    ASSERT_FALSE(attached);
    EXPECT_EQ(attached.error().code, ErrorCode::bad_usage);
}

TEST_F(SegmentRights, AnOrderToStopGoesToWhatTheSystemLetsUsWrite) {
    { const Segment segment = make(); }
    constexpr uid_t kStranger = 54321;
    const bool is_strange = give_away_to(kStranger);
    EXPECT_EQ(Segment::attach(name_.get()).has_value(), !is_strange);
    EXPECT_TRUE(Segment::attach_to_stop(name_.get()));
}

TEST_F(SegmentRights, ACoreThatIsNotSignedYetIsNotNamedByANumber) {
    Segment first = make();
    Segment second = make();
    ASSERT_TRUE(first.take_core_lock());
    const auto refused = second.take_core_lock();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message.find("pid 0"), std::string::npos) << refused.error().message;
}

TEST_F(SegmentRights, GroupThatDoesNotExistIsWrongUsageAndLeavesNothing) {
    SegmentOptions options = name_.options();
    options.group = "no-such-group-here";

    const auto made = Segment::create_or_attach(options);

    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().code, ErrorCode::bad_usage);
    EXPECT_LT(::shm_open(name_.get().c_str(), O_RDONLY, 0), 0);
}

}  // namespace
}  // namespace psicarve
