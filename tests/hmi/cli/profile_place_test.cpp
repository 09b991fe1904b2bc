// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>

#include "shared/profile/profile.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

/// Programs that are started look for a profile below the test's folder, and nowhere else of the user's.
class ProfilePlace : public CliTest {
protected:
    ProfilePlace() {
        (void)in_build("");
        unsetenv("PSICARVE_PROFILE");
        setenv("XDG_CONFIG_HOME", file("config").c_str(), 1);
        std::filesystem::create_directories(file("config/psicarve"));
    }
    ~ProfilePlace() override {
        unsetenv("XDG_CONFIG_HOME");
        setenv("PSICARVE_PROFILE", "", 1);
    }
    std::string place() const { return file("config/psicarve/machine.toml"); }
    void put_profile() const {
        write("config/psicarve/machine.toml", "name = \"mine\"\n[axis.y]\nspeed_mm_s = 7.5\n");
    }
};

TEST_F(ProfilePlace, IsTakenWithoutBeingNamed) {
    put_profile();
    EXPECT_EQ(psicarve({"profile", "path"}).out, place() + "\n");
    EXPECT_EQ(psicarve({"profile", "path", "--json"}).json()["places"][1], "/etc/psicarve/machine.toml");
    EXPECT_NE(psicarve({"profile", "show"}).out.find("name = \"mine\""), std::string::npos);
    EXPECT_EQ(psicarve({"profile", "show", "--built-in"}).out, profile_to_toml(Profile{}));
    EXPECT_NE(psicarve({"profile", "check"}).out.find("profile 'mine'"), std::string::npos);
    const Outcome sliced =
        psicarve({"slice", box_stl("box.stl"), "-o", file("a.job"), "--layers", "3", "--points", "5"});
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    EXPECT_NE(sliced.error.find("profile " + place()), std::string::npos) << sliced.error;
    EXPECT_EQ(psicarve({"snapshot", "info", file("a.job"), "--json"}).json()["job"]["profile_name"], "mine");
}

TEST_F(ProfilePlace, GivesWayToANamedOneAndLeavesAJobItsOwn) {
    write("other.toml", "name = \"other\"\n");
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", file("a.job"), "--layers", "3", "--points", "5",
                        "--profile", file("other.toml")})
                  .exit_code,
              0);
    put_profile();
    EXPECT_EQ(psicarve({"profile", "path", "--profile", file("other.toml")}).out, file("other.toml") + "\n");
    const Outcome replay = psicarve({"replay", file("a.job"), "--json"});
    EXPECT_EQ(replay.exit_code, 0) << replay.error
                                   << "a job is not judged by the profile in the default place";
    setenv("PSICARVE_PROFILE", file("other.toml").c_str(), 1);
    EXPECT_EQ(psicarve({"profile", "path"}).out, file("other.toml") + "\n");
    setenv("PSICARVE_PROFILE", "", 1);
    EXPECT_EQ(psicarve({"profile", "path"}).out, "built-in\n");
}

TEST_F(ProfilePlace, IsTakenByTheCoreToo) {
    put_profile();
    RunningProgram core{"psicarve-rtcore", {"--segment", segment_, "--clock", "virtual"}};
    ASSERT_TRUE(eventually([&] { return run({"status"}).exit_code == 0 || core.has_ended(); }));
    EXPECT_NE(run({"status", "--json"}).json()["position"], nullptr) << "both have the same profile";
    setenv("PSICARVE_PROFILE", "", 1);
    EXPECT_EQ(run({"status", "--json"}).json()["position"], nullptr)
        << "the core does not have the built-in one";
    core.send(SIGTERM);
    const Outcome ended = core.outcome();
    EXPECT_NE(ended.error.find("psicarve-rtcore: profile " + place()), std::string::npos) << ended.error;
}

TEST_F(ProfilePlace, AWrongOneIsNeverPassedOver) {
    write("config/psicarve/machine.toml", "speed = 3\n");
    const std::vector<std::vector<std::string>> commands{
        {"profile", "path"},
        {"profile", "check"},
        {"profile", "show"},
        {"slice", box_stl("box.stl"), "-o", file("a.job"), "--layers", "3", "--points", "5"}};
    for (const auto& command : commands) {
        const Outcome outcome = psicarve(command);
        EXPECT_EQ(outcome.exit_code, 3) << command[1];
        EXPECT_NE(outcome.error.find("machine.toml:1: speed: unknown key"), std::string::npos)
            << outcome.error;
    }
    setenv("PSICARVE_PROFILE", file("gone.toml").c_str(), 1);
    EXPECT_EQ(psicarve({"profile", "path"}).exit_code, 3) << "named, but not there";
}

TEST_F(ProfilePlace, IsKeptAsAnInputIs) {
    put_profile();
    const std::string kept = text_of(place());
    std::filesystem::create_symlink(place(), file("link"));
    const auto is_refused = [&](const Outcome& outcome, const std::string& option, const std::string& path) {
        EXPECT_EQ(outcome.exit_code, 2) << outcome.error;
        const std::string said = option + " " + path + " and profile " + place() + " are one file";
        EXPECT_NE(outcome.error.find(said), std::string::npos) << outcome.error;
        EXPECT_EQ(text_of(place()), kept);
    };
    for (const std::string& path : {place(), file("link")}) {
        is_refused(psicarve({"slice", box_stl("box.stl"), "-o", path, "--layers", "3", "--points", "5"}),
                   "--output", path);
        for (const char* option : {"--trace", "--piece", "--layer-times"}) {
            RunningProgram core{
                "psicarve-rtcore",
                {"--segment", segment_, "--clock", "virtual", "--capacity", "1x1", option, path}};
            ASSERT_TRUE(eventually([&] { return core.has_ended() || run({"status"}).exit_code == 0; }));
            core.send(SIGTERM);
            is_refused(core.outcome(), option, path);
        }
    }
    EXPECT_TRUE(std::filesystem::is_symlink(file("link")));
}

TEST_F(ProfilePlace, ThatCannotBeLookedAtIsNotPassedOver) {
    std::filesystem::remove(file("config/psicarve"));
    std::filesystem::create_symlink("psicarve", file("config/psicarve"));  // a circle: also root sees nothing
    const Outcome outcome = psicarve({"profile", "path"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.out;
    EXPECT_NE(outcome.error.find(place() + ": cannot be read: "), std::string::npos) << outcome.error;
    std::filesystem::remove(file("config/psicarve"));
    write("config/psicarve", "no folder");
    EXPECT_EQ(psicarve({"profile", "path"}).exit_code, 0) << "nothing can be there";
}

TEST_F(ProfilePlace, IsToldByTheCoreInLettersAlone) {
    const std::string folder = file("\033[2Jconfig");
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
    std::filesystem::create_directories(folder + "/psicarve");
    write("\033[2Jconfig/psicarve/machine.toml", "name = \"mine\"\n");
    RunningProgram core{"psicarve-rtcore", {"--segment", segment_, "--clock", "virtual"}};
    ASSERT_TRUE(eventually([&] { return run({"status"}).exit_code == 0 || core.has_ended(); }));
    core.send(SIGTERM);
    const Outcome ended = core.outcome();
    EXPECT_NE(ended.error.find("\\u001b[2Jconfig/psicarve/machine.toml"), std::string::npos) << ended.error;
    EXPECT_EQ(ended.error.find('\033'), std::string::npos);
}

class ProfileDiff : public CliTest {};

TEST_F(ProfileDiff, NamesKeysWithBothValuesAndTheirUnit) {
    write("a.toml", "[axis.y]\nspeed_mm_s = 7.5\n[job]\nfeed_mm_s = 12\n");
    write("b.toml", "[axis.y]\nspeed_mm_s = 8\n[job]\nfeed_mm_s = 12\n");
    const Outcome one = psicarve({"profile", "diff", file("a.toml")});
    EXPECT_EQ(one.exit_code, 6);
    EXPECT_NE(one.out.find("* axis.y.speed_mm_s: 7.5 -> 10.0 mm/s\n"), std::string::npos) << one.out;
    EXPECT_NE(one.out.find("  job.feed_mm_s: 12.0 -> 20.0 mm/s\n"), std::string::npos) << one.out;
    const auto both = psicarve({"profile", "diff", file("a.toml"), file("b.toml"), "--json"}).json();
    ASSERT_EQ(both["differences"].size(), 1U) << both;
    EXPECT_EQ(both["differences"]["axis.y.speed_mm_s"],
              nlohmann::json::parse(R"({"a":"7.5","b":"8.0","unit":"mm/s","matters_to_motion":true})"));
    const Outcome same = psicarve({"profile", "diff", file("a.toml"), file("a.toml")});
    EXPECT_EQ(same.exit_code, 0);
    EXPECT_EQ(same.out, "no differences\n");
}

class ProfileSet : public CliTest {
protected:
    const std::string text_ = "# mine\nname = \"mine\"   # ours\r\n\n[axis.y]\nspeed_mm_s = 7.5 # slow\n";
};

TEST_F(ProfileSet, ChangesTheValuesAndNoOtherByte) {
    write("m.toml", text_);
    const Outcome set =
        psicarve({"profile", "set", "axis.y.speed_mm_s=8", "axis.r1.travel_mm=[0,50]",
                  "axis.r1.home_position_mm=50", "tool.shape=ball", "name=\"ours\"", file("m.toml")});
    ASSERT_EQ(set.exit_code, 0) << set.error;
    const std::string text = text_of(file("m.toml"));
    EXPECT_TRUE(text.starts_with("# mine\nname = \"ours\"   # ours\r\n\n[axis.y]\nspeed_mm_s = 8.0 # slow\n"))
        << text;
    EXPECT_EQ(text_of(file("m.toml.bak")), text_);
    const auto profile = parse_profile(text, "m.toml");
    ASSERT_TRUE(profile.has_value()) << profile.error().message;
    EXPECT_EQ(profile->r1.travel_mm[1], 50.0);
    EXPECT_EQ(profile->tool.shape, ToolShape::ball);
    EXPECT_NE(set.out.find("axis.y.speed_mm_s: 7.5 -> 8\n"), std::string::npos) << set.out;
}

TEST_F(ProfileSet, WritesNothingWhenAnythingIsWrong) {
    write("m.toml", text_);
    const auto refused = [&](const std::vector<std::string>& changes, int exit_code,
                             const std::string& said) {
        std::vector<std::string> command{"profile", "set"};
        command.insert(command.end(), changes.begin(), changes.end());
        command.push_back(file("m.toml"));
        const Outcome outcome = psicarve(command);
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_NE(outcome.error.find(said), std::string::npos) << outcome.error;
        EXPECT_EQ(text_of(file("m.toml")), text_);
        EXPECT_EQ(files_in_folder(), std::vector<std::string>{"m.toml"});
    };
    refused({"axis.y.speed_mms=8"}, 2, "axis.y.speed_mms: unknown key; did you mean axis.y.speed_mm_s?");
    refused({"tool.radius_mm=8"}, 2, "tool.radius_mm: unknown key; see profile show for all keys");
    refused({"axis.y.speed_mm_s=fast"}, 3, "axis.y.speed_mm_s = fast: ");
    refused({"axis.y.speed_mm_s=9", "axis.y.home_speed_mm_s=9.5"}, 3, "axis.y.home_speed_mm_s = ");
    refused({}, 2, "KEY=VALUE");
    refused({"axis.y.speed_mm_s"}, 2, "KEY=VALUE");
}

TEST_F(ProfileSet, ThatChangesNothingWritesNothing) {
    write("m.toml", text_);
    const Outcome same = psicarve({"profile", "set", "axis.y.speed_mm_s=7.5", file("m.toml")});
    EXPECT_EQ(same.exit_code, 0) << same.error;
    EXPECT_NE(same.out.find("nothing changed"), std::string::npos);
    EXPECT_EQ(files_in_folder(), std::vector<std::string>{"m.toml"});
    EXPECT_EQ(psicarve({"profile", "set", "name=x"}).exit_code, 2) << "no profile applies that has a file";
}

}  // namespace
}  // namespace psicarve::test
