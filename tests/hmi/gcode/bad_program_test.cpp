// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <sstream>

#include "tests/hmi/gcode/read_program.hpp"
#include "tests/places.hpp"

namespace psicarve::gcode {
namespace {

struct BadProgram {
    std::string name;
    std::uint64_t line = 0;
    std::uint32_t column = 0;
    std::string code;
    bool is_of_machine = false;
};

std::vector<BadProgram> bad_programs() {
    std::vector<BadProgram> programs;
    std::istringstream lines{file_text(in_source("tests/data/gcode/bad/expected.txt"))};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        BadProgram program;
        std::string machine;
        words >> program.name >> program.line >> program.column >> program.code >> machine;
        program.is_of_machine = machine == "machine";
        programs.push_back(program);
    }
    return programs;
}

class BadPrograms : public ::testing::TestWithParam<BadProgram> {};

TEST_P(BadPrograms, AreToldByTheirPlaceAndCodeAlone) {
    const BadProgram& bad = GetParam();
    Profile profile;
    profile.head_clearance_mm = 4.0;
    const auto read = read_program(file_text(in_source("tests/data/gcode/bad/" + bad.name + ".ngc")), {},
                                   bad.is_of_machine ? &profile : nullptr);
    EXPECT_EQ(read->faults(),
              Faults{std::to_string(bad.line) + ":" + std::to_string(bad.column) + " " + bad.code});
    ASSERT_FALSE(read->problems.errors().empty());
    EXPECT_FALSE(what_text(read->problems.errors().front()).empty());
}

INSTANTIATE_TEST_SUITE_P(Gcode, BadPrograms, ::testing::ValuesIn(bad_programs()),
                         [](const auto& program) { return program.param.name; });

TEST(ProblemCodes, HaveEachABadProgram) {
    std::set<std::string> shown;
    for (const BadProgram& program : bad_programs()) shown.insert(program.code);
    // Those that are too long to be files: flow_test.cpp, parameters_test.cpp.
    for (const char* code : {"parameter_many", "too_many_blocks", "text_too_long"}) shown.insert(code);
    for (std::size_t i = 0; i < kProblemCodeCount; ++i) {
        const auto code = static_cast<ProblemCode>(i);
        EXPECT_EQ(shown.contains(std::string{name_of(code)}), !is_warning(code)) << name_of(code);
    }
}

TEST(ProblemCodes, StandInTheDocumentation) {
    const std::string page = file_text(in_source("docs/gcode.md"));
    for (std::size_t i = 0; i < kProblemCodeCount; ++i) {
        const std::string name{name_of(static_cast<ProblemCode>(i))};
        EXPECT_NE(page.find("| `" + name + "` |"), std::string::npos) << name;
    }
}

TEST(Problems, AreOneLineWithPlaceCodeAndRemedy) {
    EXPECT_EQ(problem_text({3, 7, ProblemCode::feed_missing, phrase("no feed")}, "a.ngc"),
              "a.ngc:3:7: feed_missing: no feed; give F before the first move that cuts");
}

// JSON has them as they are, a terminal and a window only what does not steer them.
TEST(Problems, KeepTheBytesOfTheirFile) {
    const auto read = read_program("G0 X1 \x01\nM2\n");
    ASSERT_EQ(read->problems.errors().size(), 1U);
    const Problem& problem = read->problems.errors().front();
    EXPECT_EQ(what_text(problem), "'\x01' begins no word");
    EXPECT_EQ(in_english(problem.what), "'\\u0001' begins no word");
    EXPECT_EQ(problem.what.arguments, std::vector<std::string>{"\x01"});
    EXPECT_EQ(problem_text(problem, "a.ngc"),
              "a.ngc:1:7: bad_character: '\x01' begins no word; a block holds words, comments, / and %");
}

TEST(Problems, SayHowOftenWhatIsToldOnce) {
    const Problem problem{3, 7, ProblemCode::not_stepped, phrase("a way %1", "x"), 12};
    EXPECT_EQ(
        problem_text(problem, "a.ngc"),
        "a.ngc:3:7: not_stepped: a way x (12 times, here first); docs/gcode.md says which ways run step "
        "by step");
    EXPECT_EQ(what_text(problem), "a way x");
}

// No number is cut, however small a feed makes it.
TEST(Problems, HaveAllDigitsOfTheirNumbers) {
    EXPECT_EQ(number_as("%.0f", 1e300).size(), 301U);
    EXPECT_EQ(mm_text(-1.25), "-1.2500");
}

TEST(Problems, AreAllCountedAndAHundredKept) {
    std::string text;
    for (int i = 0; i < 250; ++i) text += "G123\n";
    const auto read = read_program(text + "M2\n");
    EXPECT_EQ(read->problems.error_count(), 250U);
    EXPECT_EQ(read->problems.errors().size(), 100U);
}

TEST(Problems, AreNotToldAgainOfWhatDependsOnThem) {
    // Without the first line there is no feed, no motion, and no place where the arc begins.
    EXPECT_EQ(read_program("G1 X5 Y5 F1OO\nX6\nG2 X8 I1\nM2\n")->faults(), Faults{"1:12 o_word_beside"});
    EXPECT_EQ(read_program("F100 G0 X5 &\nG2 X8 Y0 I1\nG0 X0 Y0\nG2 X9 I1\nM2\n")->faults(),
              (Faults{"1:12 bad_character", "4:4 arc_radius_differs"}));
}

TEST(Problems, AreNotToldOfAnEndThatStandsInAWrongBlock) {
    for (const std::string end : {"M2", "m02", "M 3 0", "X1 M2 (last)"}) {
        EXPECT_EQ(read_program("G0 X1\n" + end + " &\n")->problems.error_count(), 1U) << end;
        EXPECT_EQ(read_program("G0 X1\nG0 G1 " + end + "\n???\n")->problems.error_count(), 1U) << end;
        EXPECT_EQ(read_program("G0 X1\n& " + end + "\n")->problems.error_count(), 1U) << end;
    }
    for (const std::string other : {"M3", "M20", "M200", "M300", "N2", "G2"})
        EXPECT_EQ(read_program("G0 X1\n& " + other + "\n")->problems.error_count(), 2U) << other;
    // It may as well be none.
    EXPECT_EQ(read_program("G0 X1 (then M2\n???\nM2\n")->problems.error_count(), 2U);
}

TEST(Problems, AreNotToldOfUnitsAndDistancesThatAWrongBlockTold) {
    const Profile profile;
    const auto faults = [&](const std::string& text) { return read_program(text, {}, &profile)->faults(); };
    EXPECT_EQ(faults("G91 &\nG0 Y-5\nM2\n"), Faults{"1:5 bad_character"});
    EXPECT_EQ(faults("G91 G123\nG0 Y-5\nM2\n"), Faults{"1:5 unknown_g"});
    EXPECT_EQ(faults("G20\nG21 G123\nG0 X50\nM2\n"), Faults{"2:5 unknown_g"});
    EXPECT_EQ(faults("F9 G91 &\nG81 X1 Z-1 R-3\nM2\n"), Faults{"1:8 bad_character"});
    EXPECT_EQ(faults("F9 G0 X20 Y20 G91 &\nG2 X21 I1\nG90 G0 X20 Y20\nG2 X29 I1\nM2\n"),
              (Faults{"1:19 bad_character", "4:4 arc_radius_differs"}));
    // What holds anyhow is not in doubt.
    EXPECT_EQ(faults("G21 G90 &\nG0 Y-5\nM2\n"), (Faults{"1:9 bad_character", "2:4 outside_travel"}));
    EXPECT_EQ(faults("G91 &\nG90 G0 Y-5\nM2\n"), (Faults{"1:5 bad_character", "2:8 outside_travel"}));
}

}  // namespace
}  // namespace psicarve::gcode
