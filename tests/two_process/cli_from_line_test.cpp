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
    /// Begins `gcode run --from-line 4` at a terminal of its own, until it asks.
    void begin_at_terminal() {
        person_ = posix_openpt(O_RDWR | O_NOCTTY);
        ASSERT_GE(person_, 0);
        ASSERT_EQ(grantpt(person_) + unlockpt(person_), 0);
        const std::string terminal = ptsname(person_);
        const std::string command = "( " + in_build("bin/psicarve") + " gcode run " + file("p.ngc") +
                                    " --from-line 4 --segment " + segment_ + " < " + terminal + " 2> " +
                                    terminal + " > " + file("out") + "; echo $? > " + file("code.part") +
                                    "; mv " + file("code.part") + " " + file("code") + " ) &";
        std::filesystem::remove(file("code"));
        said_.clear();
        ASSERT_EQ(std::system(command.c_str()), 0);
        ASSERT_TRUE(eventually([&] { return says("yes or no: "); })) << said_;
    }
    /// Its exit code once this was typed.
    int answered(const std::string& typed) {
        EXPECT_EQ(::write(person_, typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
        const bool has_ended = eventually([&] {
            says("");
            return std::filesystem::exists(file("code"));
        });
        EXPECT_TRUE(has_ended) << said_;
        says("");
        close(person_);
        return std::atoi(text_of(file("code")).c_str());
    }
    /// What the terminal shows by now.
    bool says(const std::string& words) {
        pollfd shown{person_, POLLIN, 0};
        char part[512];
        while (poll(&shown, 1, 0) > 0 && (shown.revents & POLLIN) != 0) {
            const ssize_t count = read(person_, part, sizeof part);
            if (count <= 0) break;
            said_.append(part, static_cast<std::size_t>(count));
        }
        return said_.find(words) != std::string::npos;
    }

    int person_ = -1;
    std::string said_;
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
        ASSERT_NO_FATAL_FAILURE(begin_at_terminal());
        EXPECT_EQ(answered(answer), 4) << answer << said_;
        EXPECT_TRUE(says("nothing has moved")) << said_;
        EXPECT_EQ(r1_pulses(), before) << answer;
    }
    ASSERT_NO_FATAL_FAILURE(begin_at_terminal());
    EXPECT_EQ(answered("yes\n"), 0) << said_;
    EXPECT_TRUE(says("the spindle goes on")) << said_;
    EXPECT_EQ(r1_pulses(), 39 * 400);
}

// What the machine would do is not told for a line that is never reached, and nobody is asked.
TEST_F(FromLine, IsRefusedBehindTheProgramsEndBeforeAnybodyIsAsked) {
    start_homed();
    const Outcome refused = run({"gcode", "run", file("p.ngc"), "--from-line", "6", "--unattended"});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("the program ends before line 6"), std::string::npos) << refused.error;
    EXPECT_EQ(refused.error_lines(), 1U) << refused.error;
    EXPECT_EQ(run({"gcode", "run", file("p.ngc"), "--from-line", "5", "--unattended"}).exit_code, 0);
    write("old.vcd", "an older trace");
    const Outcome simulated = psicarve(
        {"gcode", "run", file("p.ngc"), "--from-line", "6", "--simulate", "--trace", file("old.vcd")});
    EXPECT_EQ(simulated.exit_code, 3);
    EXPECT_EQ(simulated.error_lines(), 1U) << simulated.error;
    EXPECT_TRUE(text_of(file("old.vcd")) == "an older trace");
}

TEST_F(FromLine, IsNotBegunWhereTheMachineWasChangedWhileItAsked) {
    start_homed();
    for (const std::vector<std::string>& change :
         {std::vector<std::string>{"spindle", "on"}, {"jog", "r1", "-1"}, {"drives-off"}}) {
        ASSERT_NO_FATAL_FAILURE(begin_at_terminal());
        ASSERT_EQ(run(change).exit_code, 0) << change.front();
        const std::int64_t before = r1_pulses();
        EXPECT_EQ(answered("yes\n"), 4) << change.front() << said_;
        EXPECT_EQ(r1_pulses(), before) << change.front();
    }
}

}  // namespace
}  // namespace psicarve::test
