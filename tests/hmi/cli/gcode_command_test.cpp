// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

class GcodeCommand : public CliTest {
protected:
    std::string program(const std::string& text) const {
        write("a.ngc", text);
        return file("a.ngc");
    }
};

TEST_F(GcodeCommand, SaysThatAProgramIsRight) {
    const std::string path = program("G0 X20\nG1 X18 F100\nM2\n");
    const Outcome outcome = psicarve({"gcode", "check", path});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.out, path + ": OK, 3 lines, 2 motions\n");
}

TEST_F(GcodeCommand, TellsEveryErrorByItsPlace) {
    const std::string path = program("G0 X61\nG1 Y5\nG0 A5\nM2\n");
    const Outcome outcome = psicarve({"gcode", "check", path});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error_lines(), 3U) << outcome.error;
    EXPECT_NE(outcome.error.find("psicarve: " + path + ":1:4: outside_travel: r1 comes to 61.0000 mm"),
              std::string::npos)
        << outcome.error;
    EXPECT_NE(outcome.error.find(path + ":2:4: feed_missing: "), std::string::npos);
    EXPECT_NE(outcome.error.find(path + ":3:4: axis_missing: "), std::string::npos);
    EXPECT_NE(psicarve({"gcode", "check", path, "--no-machine"}).error.find(":2:4: feed_missing"),
              std::string::npos);
}

TEST_F(GcodeCommand, JudgesByTheProfileThatIsNamed) {
    write("m.toml", "[axis.r1]\ntravel_mm = [0.0, 70.0]\nhome_position_mm = 70.0\n");
    const std::string path = program("G0 X65\nM2\n");
    EXPECT_EQ(psicarve({"gcode", "check", path}).exit_code, 3);
    EXPECT_EQ(psicarve({"gcode", "check", path, "--profile", file("m.toml")}).exit_code, 0);
}

TEST_F(GcodeCommand, GivesDataToPrograms) {
    const std::string path = program("G0 X20 S5\nG1 X18\nM2\n");
    const Outcome outcome = psicarve({"gcode", "check", path, "--json"});
    EXPECT_EQ(outcome.exit_code, 3);
    const auto json = outcome.json();
    EXPECT_EQ(json["file"], path);
    EXPECT_EQ(json["ok"], false);
    EXPECT_EQ(json["error_count"], 1);
    EXPECT_EQ(json["errors"][0]["line"], 2);
    EXPECT_EQ(json["errors"][0]["column"], 4);
    EXPECT_EQ(json["errors"][0]["code"], "feed_missing");
    EXPECT_EQ(json["warnings"][0]["code"], "speed_unused");
    EXPECT_EQ(json["error"]["exit_code"], 3);
}

TEST_F(GcodeCommand, PrintsCanonicalMotionAndNothingElse) {
    const std::string path = program("G20\nG0 X1 A5\n/G0 X2\nM2\n");
    EXPECT_EQ(psicarve({"gcode", "check", path, "--canon", "--no-machine", "--block-delete"}).out,
              "{\"k\":\"rapid\",\"line\":2,\"end\":[25.4,0,0,5,0,0]}\n{\"k\":\"end\",\"line\":4}\n");
    EXPECT_EQ(psicarve({"gcode", "check", path, "--canon", "--json"}).exit_code, 2);
}

TEST_F(GcodeCommand, SaysHowManyErrorsItDoesNotTell) {
    std::string text;
    for (int i = 0; i < 120; ++i) text += "G123\n";
    const Outcome outcome = psicarve({"gcode", "check", program(text + "M2\n")});
    EXPECT_EQ(outcome.error_lines(), 101U);
    EXPECT_NE(outcome.error.find("and 20 errors more"), std::string::npos) << outcome.error;
}

TEST_F(GcodeCommand, NamesAFileThatCannotBeRead) {
    const Outcome outcome = psicarve({"gcode", "check", file("none.ngc")});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.error.find("none.ngc: cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::test
