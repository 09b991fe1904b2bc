// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_of_core.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

Profile named(const std::string& name) {
    Profile profile;
    profile.name = name;
    return profile;
}

TEST(ProfileOfCore, IsTheOfferedOneWithTheCoresHash) {
    ProfileOfCore of_core{{}};
    MachineView view;
    of_core.offer(Profile{});
    of_core.look(profile_hash(named("mill")), std::nullopt, view);
    EXPECT_FALSE(view.profile);
    EXPECT_EQ(view.core_profile_hash, profile_hash(named("mill")));
    of_core.offer(named("mill"));  // is looked at again, though the core is the same
    of_core.look(profile_hash(named("mill")), std::nullopt, view);
    ASSERT_TRUE(view.profile);
    EXPECT_EQ(view.profile->name, "mill");
    of_core.look(0, std::nullopt, view);
    EXPECT_FALSE(view.profile);
    EXPECT_EQ(view.core_profile_hash, 0U);
}

TEST(ProfileOfCore, NamesAChosenProfileThatIsNotTheCores) {
    ProfileOfCore of_core{{}};
    MachineView view;
    of_core.offer(named("lathe"));
    of_core.look(profile_hash(named("mill")), named("lathe"), view);
    EXPECT_EQ(view.unused_profile, "lathe");
    of_core.look(profile_hash(named("lathe")), named("lathe"), view);
    EXPECT_EQ(view.unused_profile, "");
    of_core.look(0, named("lathe"), view);
    EXPECT_EQ(view.unused_profile, "");
}

TEST(ProfileOfCore, KeepsWhatTheJobToldUntilTheCoreIsAnother) {
    ProfileOfCore of_core{{}};
    MachineView view;
    of_core.look(7, std::nullopt, view);
    view.profile = named("of the job");
    view.is_profile_of_job = true;
    of_core.look(7, std::nullopt, view);
    EXPECT_TRUE(view.profile);
    EXPECT_TRUE(view.is_profile_of_job);
    of_core.look(8, std::nullopt, view);
    EXPECT_FALSE(view.profile);
    EXPECT_FALSE(view.is_profile_of_job);
}

TEST(ProfileOfCore, IsSearchedOnceForEachCoreThatIsHeard) {
    std::atomic<int> searches{0};
    ProfileOfCore of_core{[&searches](std::uint32_t, std::uint64_t) -> std::optional<Profile> {
        ++searches;
        return std::nullopt;
    }};
    MachineView view = test::machine_in(MachineState::ready);
    view.profile.reset();
    view.core_profile_hash = 0;
    of_core.search(view);
    view.core_profile_hash = 7;
    view.life = CoreLife::silent;
    of_core.search(view);
    EXPECT_EQ(searches.load(), 0);
    view.life = CoreLife::alive;
    of_core.search(view);
    while (searches.load() == 0) std::this_thread::yield();
    view.core_pid = 43;
    while (searches.load() == 1) {  // begins once the one before is taken
        of_core.poll();
        of_core.search(view);
    }
    for (int round = 0; round < 100; ++round) {
        of_core.poll();
        of_core.search(view);
    }
    EXPECT_EQ(searches.load(), 2);
}

TEST(ProfileOfCore, ThatWasFoundInFilesIsTakenWithTheNextLook) {
    ProfileOfCore of_core{[](std::uint32_t pid, std::uint64_t hash) -> std::optional<Profile> {
        return pid == 42 && hash == profile_hash(named("mill")) ? std::optional{named("mill")} : std::nullopt;
    }};
    MachineView view = test::machine_in(MachineState::ready);
    view.profile.reset();
    while (!view.profile) {
        of_core.poll();
        of_core.look(profile_hash(named("mill")), std::nullopt, view);
        of_core.search(view);
        std::this_thread::yield();
    }
    EXPECT_EQ(view.profile->name, "mill");
}

}  // namespace
}  // namespace psicarve::session
