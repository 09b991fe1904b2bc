// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/cli/program_run.hpp"
#include "tests/parameter_name.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

using ::testing::TestWithParam;

const std::vector<std::string> kCommands{"carve",
                                         "slice",
                                         "inspect",
                                         "estimate",
                                         "publish",
                                         "status",
                                         "log",
                                         "home",
                                         "start",
                                         "start-interpolation",
                                         "hold",
                                         "resume",
                                         "override",
                                         "stop",
                                         "estop",
                                         "reset-alarm",
                                         "back-off",
                                         "reset-height",
                                         "jog",
                                         "move",
                                         "single",
                                         "optional-stop",
                                         "spindle",
                                         "drives-off",
                                         "forget",
                                         "pins",
                                         "snapshot save",
                                         "snapshot info",
                                         "snapshot export",
                                         "snapshot diff",
                                         "gcode check",
                                         "gcode run",
                                         "gcode estimate",
                                         "gcode offsets",
                                         "replay",
                                         "verify",
                                         "calibrate",
                                         "doctor",
                                         "latency",
                                         "profile check",
                                         "profile show",
                                         "profile path",
                                         "profile diff",
                                         "profile set",
                                         "completion"};

class EachCommand : public TestWithParam<std::string> {};

TEST_P(EachCommand, ExplainsItselfWithAnExample) {
    auto arguments = words_of(GetParam());
    arguments.push_back("--help");
    const Outcome help = psicarve(arguments);
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.error, "");
    EXPECT_NE(help.out.find("Example:\n  psicarve " + GetParam()), std::string::npos) << help.out;
    EXPECT_NE(help.out.find("--segment"), std::string::npos);
    EXPECT_NE(help.out.find("--profile"), std::string::npos);
}

TEST_P(EachCommand, RefusesAnUnknownOptionAndSuggestsTheNearest) {
    auto arguments = words_of(GetParam());
    arguments.push_back("--segmnet=/x");
    const Outcome outcome = psicarve(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    EXPECT_NE(outcome.error.find("'--segmnet'; did you mean '--segment'?"), std::string::npos)
        << outcome.error;
}

TEST_P(EachCommand, StandsInTheDocumentationWithAnExample) {
    std::ifstream stream{in_source("docs/commands.md")};
    const std::string page{std::istreambuf_iterator<char>{stream}, {}};
    EXPECT_NE(page.find("\npsicarve " + GetParam()), std::string::npos);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(), [](char letter) { return letter == ' ' || letter == '-'; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Usage, EachCommand, ::testing::ValuesIn(kCommands), test_name);

TEST(Commands, AreExactlyThoseOfTheList) {
    const auto listed = [](const std::vector<std::string>& arguments) {
        const std::string help = psicarve(arguments).out;
        std::vector<std::string> names;
        std::istringstream lines{help.substr(std::min(help.size(), help.find("Subcommands:")))};
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line) && line.starts_with("  ")) {
            if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
        return names;
    };
    std::vector<std::string> expected;
    for (const std::string& command : kCommands) {
        const std::string first = words_of(command)[0];
        if (std::find(expected.begin(), expected.end(), first) == expected.end()) expected.push_back(first);
    }
    EXPECT_EQ(listed({"--help"}), expected);
    EXPECT_EQ(listed({"snapshot", "--help"}), (std::vector<std::string>{"save", "info", "export", "diff"}));
    EXPECT_EQ(listed({"gcode", "--help"}), (std::vector<std::string>{"check", "run", "estimate", "offsets"}));
    EXPECT_EQ(listed({"profile", "--help"}),
              (std::vector<std::string>{"check", "show", "path", "diff", "set"}));
}

struct WrongUsage {
    const char* arguments;
    const char* said;
};
class WrongUsages : public TestWithParam<WrongUsage> {};

TEST_P(WrongUsages, EndWithExitCodeTwoAndOneLine) {
    const Outcome outcome = psicarve(words_of(GetParam().arguments));
    EXPECT_EQ(outcome.exit_code, 2) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    EXPECT_NE(outcome.error.find(GetParam().said), std::string::npos) << outcome.error;
}

INSTANTIATE_TEST_SUITE_P(
    Usage, WrongUsages,
    ::testing::Values(
        WrongUsage{"", "subcommand is required"}, WrongUsage{"slcie m.stl", "did you mean 'slice'?"},
        WrongUsage{"snapshot infoo f", "did you mean 'info'?"}, WrongUsage{"snapshot", "required"},
        WrongUsage{"slice m.stl --outptu j", "did you mean '--output'?"},
        WrongUsage{"slice m.stl", "--output is required"}, WrongUsage{"slice", "required"},
        WrongUsage{"slice m.stl -o j --up q", "--up"}, WrongUsage{"slice m.stl -o j --layers 0", "--layers"},
        WrongUsage{"slice m.stl -o j --layers many", "--layers"},
        WrongUsage{"slice m.stl -o j --points 1", "--points"},
        WrongUsage{"slice m.stl -o j --height 10 --scale 2", "--scale"},
        WrongUsage{"slice m.stl -o j --height -3", "--height: '-3' is not a number greater than 0 (see"},
        WrongUsage{"slice m.stl -o j --scale 0", "--scale: '0' is not a number greater than 0 (see"},
        WrongUsage{"slice m.stl -o j --scale nan", "--scale: 'nan' is not a number greater than 0 (see"},
        WrongUsage{"carve m.stl --picture p.jpg", "--picture: 'p.jpg': a picture is a PNG file"},
        WrongUsage{"replay j --picture png", "--picture: 'png': a picture is a PNG file"},
        WrongUsage{"verify j t --picture p.png.jpg", "its name ends in .png"},
        WrongUsage{"slice m.stl -o j --tool drill:3", "--tool: 'drill:3' is none of point, ball:MM"},
        WrongUsage{"slice m.stl -o j --tool ball", "--tool"},
        WrongUsage{"slice m.stl -o j --tool ball:0", "--tool"},
        WrongUsage{"slice m.stl -o j --tool ball:1001", "0.001 to 1000 mm across"},
        WrongUsage{"slice m.stl -o j --tool ball:nan", "--tool"},
        WrongUsage{"slice m.stl -o j --tool vee:3", "--tool"},
        WrongUsage{"slice m.stl -o j --tool ball:3:60", "--tool"},
        WrongUsage{"slice m.stl -o j --flute 4", "--flute is of a tool that has a size"},
        WrongUsage{"slice m.stl -o j --tool ball:3 --flute 1001", "--flute must be 0 to 1000 mm"},
        WrongUsage{"slice m.stl -o j --tool ball:3 --flute -1", "--flute"},
        WrongUsage{"slice m.stl -o j --blank 30", "--blank: '30' is not RADIUSxHEIGHT"},
        WrongUsage{"slice m.stl -o j --blank 0x10", "--blank"},
        WrongUsage{"slice m.stl -o j --axis-at middle", "--axis-at"},
        WrongUsage{"slice m.stl -o j --axis-at 1,2,3", "--axis-at"},
        WrongUsage{"slice m.stl -o j --joining snake", "--joining"}, WrongUsage{"back-off", "AXIS"},
        WrongUsage{"back-off z", "z"}, WrongUsage{"jog r1", "DISTANCE"}, WrongUsage{"jog z 1", "z"},
        WrongUsage{"jog r1 far", "'far' is not a number"}, WrongUsage{"jog r1 1mm", "'1mm' is not a number"},
        WrongUsage{"jog r1 inf", "'inf' is not a number"}, WrongUsage{"jog r1 1 --speed 0", "--speed"},
        WrongUsage{"move", "AXIS=POSITION"}, WrongUsage{"move r1", "'r1' is not AXIS=POSITION"},
        WrongUsage{"move z=1", "'z=1' is not AXIS=POSITION"}, WrongUsage{"move r1=", "'' is not a number"},
        WrongUsage{"move r1=1 y=2 r1=3", "r1 is given twice"},
        WrongUsage{"move r1=1 y=2 --centre r1=1", "--centre takes the axes that are moved"},
        WrongUsage{"move r1=1 y=2 --clockwise", "--clockwise is of an arc: give its --centre, too"},
        WrongUsage{"move r1=1 y=2 --centre 5,6", "'5' is not AXIS=POSITION"}, WrongUsage{"spindle", "STATE"},
        WrongUsage{"spindle fast", "fast"}, WrongUsage{"status --segment psicarve", "--segment"},
        WrongUsage{"status now", "unexpected argument 'now'"},
        WrongUsage{"slice m.stl -o j --layers 3 --layer-height 1", "excludes"},
        WrongUsage{"slice m.stl -o j --layer-height 0", "'0' is not a number greater than 0"},
        WrongUsage{"snapshot export f --format xml", "--format"}, WrongUsage{"snapshot diff f", "B"}),
    [](const auto& named) { return parameter_name(named.param.arguments, named.index); });

TEST(Usage, AnEmptyNameIsWrong) {
    const std::vector<std::vector<std::string>> commands{{"slice", "", "-o", "j"},
                                                         {"slice", "m.stl", "-o", ""},
                                                         {"slice", "m.stl", "-o", "j", "--profile", ""},
                                                         {"carve", "m.stl", "--trace", ""},
                                                         {"carve", "m.stl", "--picture", ""},
                                                         {"replay", ""},
                                                         {"verify", "j", ""},
                                                         {"snapshot", "save", ""},
                                                         {"profile", "check", ""},
                                                         {"profile", "diff", ""},
                                                         {"status", "--segment", ""},
                                                         {"status", "--group", ""}};
    for (const auto& command : commands) {
        const Outcome outcome = psicarve(command);
        EXPECT_EQ(outcome.exit_code, 2) << command[0] << ": " << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    }
}

TEST(Usage, AnErrorIsAnObjectForProgramsThatRead) {
    const Outcome outcome = psicarve({"status", "--json", "--wtch"});
    EXPECT_EQ(outcome.exit_code, 2);
    ASSERT_TRUE(outcome.json().is_object()) << outcome.out;
    EXPECT_EQ(outcome.json()["error"]["code"], "bad_usage");
    EXPECT_EQ(outcome.json()["error"]["exit_code"], 2);
    for (const char* both : {"slice m.stl -o - --json", "snapshot save - --json"}) {
        const auto error = psicarve(words_of(both)).json()["error"];
        EXPECT_EQ(error["exit_code"], 2);
        EXPECT_EQ(error["message"],
                  "- and --json: standard output takes one of them, the file or the report");
    }
}

TEST(Usage, CommonOptionsMayStandBeforeTheCommand) {
    const Outcome outcome = psicarve({"--segment", "/psicarve-no-such-segment", "status"});
    EXPECT_EQ(outcome.exit_code, 5);
    EXPECT_NE(outcome.error.find("/psicarve-no-such-segment"), std::string::npos) << outcome.error;
}

/// What a program prints ends on a full disk.
class FullDisk : public TestWithParam<std::string> {};

TEST_P(FullDisk, BehindStandardOutputIsAnError) {
    const std::string line = in_build("bin/" + GetParam()) + " 2>&1 >/dev/full";
    std::FILE* const pipe = popen(line.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string error;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) error += static_cast<char>(c);
    const int status = pclose(pipe);
    EXPECT_EQ(WEXITSTATUS(status), 3);
    EXPECT_NE(error.find(": standard output: No space left on device\n"), std::string::npos) << error;
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
}

INSTANTIATE_TEST_SUITE_P(Usage, FullDisk,
                         ::testing::Values("psicarve profile show", "psicarve --help", "psicarve --version",
                                           "psicarve snapshot --help", "psicarve slice --help",
                                           "psicarve-rtcore --help", "psicarve-rtcore --version"),
                         [](const auto& named) { return parameter_name(named.param, named.index); });

TEST(Usage, AnOverrideIsAWholeNumberFromTenToTwoHundred) {
    for (const std::string percent : {"9", "201", "-50", "50.5", "fast", "50%"}) {
        const Outcome outcome = psicarve({"override", percent});
        EXPECT_EQ(outcome.exit_code, 2) << percent;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    }
}

TEST(Usage, AnOverrideOfRapidsIsAWholeNumberFromTenToAHundred) {
    for (const std::string percent : {"5", "101", "200"}) {
        const Outcome outcome = psicarve({"override", percent, "--rapids"});
        EXPECT_EQ(outcome.exit_code, 2) << percent;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_NE(outcome.error.find("10 to 100"), std::string::npos) << outcome.error;
    }
    EXPECT_NE(psicarve({"override", "5"}).error.find("10 to 200"), std::string::npos);
}

struct CoreUsage {
    const char* arguments;
    const char* said;
};
class CoreUsages : public TestWithParam<CoreUsage> {};

TEST_P(CoreUsages, OfTheCoreEndAsThoseOfPsicarve) {
    const Outcome outcome = RunningProgram{"psicarve-rtcore", words_of(GetParam().arguments)}.outcome();
    EXPECT_EQ(outcome.exit_code, 2) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    EXPECT_NE(outcome.error.find(GetParam().said), std::string::npos) << outcome.error;
    EXPECT_TRUE(outcome.error.starts_with("psicarve-rtcore: ")) << outcome.error;
    EXPECT_TRUE(outcome.error.ends_with(" (see: psicarve-rtcore --help)\n")) << outcome.error;
}

INSTANTIATE_TEST_SUITE_P(
    Usage, CoreUsages,
    ::testing::Values(CoreUsage{"--prot sim", "unknown option '--prot'; did you mean '--port'?"},
                      CoreUsage{"--clok=virtual", "unknown option '--clok'; did you mean '--clock'?"},
                      CoreUsage{"--xyzzy", "unknown option '--xyzzy' (see"},
                      CoreUsage{"now", "unexpected argument 'now'"}, CoreUsage{"--clock fast", "--clock"},
                      CoreUsage{"--priority 100", "--priority"},
                      CoreUsage{"--cpu 1000", "--cpu: this computer has no such processor"},
                      CoreUsage{"--cpu all", "'all' is not the number of a processor, nor any"},
                      CoreUsage{"--capacity 3", "--capacity: '3' is not LAYERSxPOINTS"}),
    [](const auto& named) { return parameter_name(named.param.arguments, named.index); });

/// Every command that needs the machine says that there is none.
class WithoutSegment : public TestWithParam<std::string> {};

TEST_P(WithoutSegment, EndsWithExitCodeFiveAndOneLine) {
    auto arguments = words_of(GetParam());
    arguments.insert(arguments.end(), {"--segment", "/psicarve-no-such-segment", "--json"});
    const Outcome outcome = psicarve(arguments);
    EXPECT_EQ(outcome.exit_code, 5) << outcome.error;
    EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    EXPECT_EQ(outcome.json()["error"]["code"], "no_core") << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(Usage, WithoutSegment,
                         ::testing::Values("status", "home", "start", "start --carve", "start-interpolation",
                                           "hold", "resume", "stop", "estop", "reset-alarm", "back-off r1",
                                           "reset-height", "override 50", "override 50 --rapids",
                                           "single off", "optional-stop on", "jog r1 -1", "jog psi +",
                                           "move r1=30", "spindle on", "home y", "drives-off", "pins",
                                           "pins spindle", "snapshot save /dev/null", "status --watch"),
                         [](const auto& named) { return parameter_name(named.param, named.index); });

}  // namespace
}  // namespace psicarve::test
