// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

/// A profile that cannot be read is no reason to leave a machine running, or to show nothing of it.
class ForgivenProfile : public CliTest {
protected:
    ForgivenProfile() {
        (void)in_build("");
        write("bad.toml", "speed = 3\n");
    }
    ~ForgivenProfile() override { setenv("PSICARVE_PROFILE", "", 1); }

    void start_core() {
        core_ = std::make_unique<RunningProgram>(
            "psicarve-rtcore", std::vector<std::string>{"--segment", segment_, "--clock", "virtual"});
        ASSERT_TRUE(eventually([&] { return run({"status"}).exit_code == 0 || core_->has_ended(); }));
        ASSERT_FALSE(core_->has_ended());
    }
    static bool warns(const Outcome& outcome) {
        return outcome.error.find("psicarve: warning: ") != std::string::npos &&
               outcome.error.find("bad.toml:1: speed: unknown key") != std::string::npos;
    }
    std::unique_ptr<RunningProgram> core_;
};

TEST_F(ForgivenProfile, NeverKeepsTheMachineFromBeingStopped) {
    for (const char* command : {"estop", "stop", "hold"}) {
        const Outcome outcome = run({"--profile", file("bad.toml"), command});
        EXPECT_EQ(outcome.exit_code, 5) << command << ": no core is there: " << outcome.error;
        EXPECT_TRUE(warns(outcome)) << outcome.error;
    }
    start_core();
    const Outcome stopped = run({"estop", "--profile", file("bad.toml"), "--json"});
    EXPECT_EQ(stopped.exit_code, 0) << stopped.error;
    EXPECT_TRUE(warns(stopped)) << stopped.error;
    EXPECT_EQ(run({"status", "--json"}).json()["state"], "alarm");
    EXPECT_EQ(run({"reset-alarm", "--profile", file("bad.toml")}).exit_code, 3) << "no stop, no need";
}

TEST_F(ForgivenProfile, OfTheDefaultPlaceLeavesTheMachineToBeLookedAt) {
    start_core();
    setenv("PSICARVE_PROFILE", file("bad.toml").c_str(), 1);
    const Outcome status = run({"status", "--json"});
    EXPECT_EQ(status.exit_code, 0) << status.error;
    EXPECT_TRUE(warns(status)) << status.error;
    EXPECT_EQ(status.json()["position"]["r1_mm"], 0.0) << "by the core's own profile, the built-in one";
    const Outcome pins = run({"pins", "--json"});
    EXPECT_EQ(pins.exit_code, 0) << pins.error;
    EXPECT_TRUE(warns(pins)) << pins.error;
    EXPECT_EQ(pins.json()["signals"]["r1_step"]["pin"], 5);
    const Outcome tested = run({"pins", "spindle_", "--json"});
    EXPECT_EQ(tested.exit_code, 2) << "a signal's name is what is wrong: " << tested.error;
    for (const char* command : {"status", "pins"})
        EXPECT_EQ(run({command, "--profile", file("bad.toml")}).exit_code, 3) << "named, and so meant";
}

TEST_F(ForgivenProfile, IsMendedByProfileSet) {
    for (const char* broken : {"[axis.y]\nspeed_mm_s = -1\n", "[axis.y]\nspeed_mm_s = \"fast\"\n"}) {
        for (const bool is_option : {false, true}) {
            write("m.toml", broken);
            std::vector<std::string> command{"profile", "set", "axis.y.speed_mm_s=8"};
            if (is_option) command.emplace_back("--profile");
            command.push_back(file("m.toml"));
            const Outcome set = psicarve(command);
            EXPECT_EQ(set.exit_code, 0) << set.error;
            EXPECT_EQ(text_of(file("m.toml")), "[axis.y]\nspeed_mm_s = 8.0\n") << is_option;
            EXPECT_NE(set.out.find("the old one is " + file("m.toml.bak")), std::string::npos) << set.out;
        }
    }
}

TEST_F(ForgivenProfile, ThatWasEmptyHasNoBackupAndNoneIsTold) {
    write("new.toml", "");
    const Outcome said = psicarve({"profile", "set", "axis.y.speed_mm_s=8", file("new.toml")});
    EXPECT_EQ(said.exit_code, 0) << said.error;
    EXPECT_EQ(said.out.find(".bak"), std::string::npos) << said.out;
    write("json.toml", "");
    const Outcome json = psicarve({"profile", "set", "axis.y.speed_mm_s=8", file("json.toml"), "--json"});
    EXPECT_EQ(json.json()["backup"], nullptr) << json.out;
    EXPECT_EQ(files_in_folder(), (std::vector<std::string>{"bad.toml", "json.toml", "new.toml"}));
    const Outcome again = psicarve({"profile", "set", "axis.y.speed_mm_s=9", file("new.toml"), "--json"});
    EXPECT_EQ(again.json()["backup"], file("new.toml.bak")) << again.out;
}

}  // namespace
}  // namespace psicarve::test
