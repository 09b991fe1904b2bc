// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "tests/places.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

/// What a machine does before a program's line is confirmed by a person.
class FromLine : public Machine {
protected:
    void start_homed() {
        start_core();
        ASSERT_EQ(run({"home"}).exit_code, 0);
        write("p.ngc", "G21 G90 F300\nG0 X40 Y3\nM3\nG1 X39\nM2\n");
    }
    std::int64_t r1_pulses() {
        return run({"status", "--json"}).json()["position_pulses"]["r1"].get<std::int64_t>();
    }
    /// What `gcode run --from-line 4` comes to at a terminal where this is typed: exit code and words.
    std::pair<int, std::string> answered(const std::string& typed) {
        const int person = posix_openpt(O_RDWR | O_NOCTTY);
        EXPECT_GE(person, 0);
        EXPECT_EQ(grantpt(person) + unlockpt(person), 0);
        const std::string command = "( " + in_build("bin/psicarve") + " gcode run " + file("p.ngc") +
                                    " --from-line 4 --segment " + segment_ + " < " + ptsname(person) + " > " +
                                    file("said") + " 2>&1; echo $? > " + file("code.part") + "; mv " +
                                    file("code.part") + " " + file("code") + " ) &";
        std::filesystem::remove(file("said"));
        std::filesystem::remove(file("code"));
        EXPECT_EQ(std::system(command.c_str()), 0);
        EXPECT_TRUE(eventually([&] {
            return std::filesystem::exists(file("said")) && text_of(file("said")).ends_with("yes or no: ");
        })) << text_of(file("said"));
        EXPECT_EQ(write_all(person, typed), typed.size());
        EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file("code")); }))
            << text_of(file("said"));
        close(person);
        return {std::atoi(text_of(file("code")).c_str()), text_of(file("said"))};
    }

private:
    static std::size_t write_all(int descriptor, const std::string& text) {
        return static_cast<std::size_t>(::write(descriptor, text.data(), text.size()));
    }
};

TEST_F(FromLine, MovesNothingWhereNobodyCanConfirmIt) {
    start_homed();
    const std::int64_t before = r1_pulses();
    const Outcome refused = run({"gcode", "run", file("p.ngc"), "--from-line", "4"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.error.find("--unattended"), std::string::npos) << refused.error;
    EXPECT_EQ(r1_pulses(), before);
    EXPECT_EQ(run({"gcode", "run", file("p.ngc"), "--unattended"}).exit_code, 2) << "nothing to be asked";
    const Outcome done = run({"gcode", "run", file("p.ngc"), "--from-line", "4", "--unattended"});
    EXPECT_EQ(done.exit_code, 0) << done.error;
    EXPECT_NE(done.error.find("psicarve: before line 4 the machine does this:"), std::string::npos)
        << done.error;
    EXPECT_EQ(r1_pulses(), 39 * 400);
}

TEST_F(FromLine, IsBegunByAYesAlone) {
    start_homed();
    const std::int64_t before = r1_pulses();
    for (const char* answer : {"no\n", "\n", "yesterday\n"}) {
        const auto [code, said] = answered(answer);
        EXPECT_EQ(code, 4) << answer << said;
        EXPECT_NE(said.find("nothing has moved"), std::string::npos) << said;
        EXPECT_EQ(r1_pulses(), before) << answer;
    }
    const auto [code, said] = answered("yes\n");
    EXPECT_EQ(code, 0) << said;
    EXPECT_NE(said.find("the spindle goes on"), std::string::npos) << said;
    EXPECT_EQ(r1_pulses(), 39 * 400);
}

}  // namespace
}  // namespace psicarve::test
