// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/parameters.hpp"

#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

/// X of the ends of all moves.
std::vector<double> x_ends(const ReadProgram& read) {
    std::vector<double> ends;
    for (const CanonRecord& record : read.records)
        if (record.kind == CanonKind::rapid || record.kind == CanonKind::feed) ends.push_back(record.end[0]);
    return ends;
}

std::vector<double> x_of(const std::string& text, const InterpreterOptions& options = {}) {
    const auto read = read_program(text + "M2\n", options);
    EXPECT_EQ(read->faults(), Faults{}) << text;
    return x_ends(*read);
}

using Ends = std::vector<double>;

TEST(ProgramParameters, CountBehindTheirBlock) {
    EXPECT_EQ(x_of("#1=5 G0 X#1\nX#1\n#1=1 #1=[#1+1] X#1\nX#1\n"), (Ends{0, 5, 5, 6}));
}

TEST(ProgramParameters, OfABlockThatIsLeftOutAreNotSet) {
    InterpreterOptions options;
    EXPECT_EQ(x_of("/#1=5\nG0 X[#1+1]\n", options), Ends{6});
    options.skips_deleted = true;
    EXPECT_EQ(x_of("/#1=5\n/G0 X#<nothing> &\nG0 X[#1+1]\n", options), Ends{1});
}

TEST(ProgramParameters, TellOffsetsInMillimetresAndPlacesInTheProgramsUnits) {
    const std::string setting = "G20 G0 X1\nG28.1\nG92 X2\nG10 L2 P2 X3 R10\nG21\n";
    EXPECT_DOUBLE_EQ(x_of(setting + "G0 X#5161\n").back(), 0.0 + 25.4 - 25.4);
    EXPECT_DOUBLE_EQ(x_of("G20\nG10 L2 P2 X3 R10\nG21\nG0 X#5241\n").back(), 76.2);
    EXPECT_DOUBLE_EQ(x_of("G20\nG10 L2 P2 X3 R10\nG21\nG0 X#5250\n").back(), 10.0);
    EXPECT_DOUBLE_EQ(x_of("G20 G0 X1\nX[#5420 + #<_x>]\nG21\nX#<_abs_x>\n").back(), 50.8);
}

TEST(ProgramParameters, AreThoseOfOffsetsThatAreInForce) {
    EXPECT_EQ(x_of("G0 X3\nG92 X1\nG53 G0 X[#5211]\n").back(), 2.0);
    EXPECT_EQ(x_of("G0 X3\nG92 X1\nG53 G0 X[#5210]\n").back(), 1.0);
    EXPECT_EQ(x_of("G0 X3\nG92 X1\nG92.2\nG53 G0 X[#5210 + 10 * #5211]\n").back(), 20.0);
    EXPECT_EQ(x_of("G0 X3\nG92 X1\nG92.1\nG53 G0 X[#5210 + 10 * #5211]\n").back(), 0.0);
    EXPECT_EQ(x_of("G59.3\nG53 G0 X#5220\n").back(), 9.0);
    EXPECT_EQ(x_of("G59.3\nG53 G0 X#<_coord_system>\n").back(), 593.0);
    EXPECT_EQ(x_of("G10 L20 P3 X-4\nG53 G0 X#5261\n").back(), 4.0);
}

TEST(ProgramParameters, ThatTheMachineSetsCannotBeSet) {
    for (const std::string name : {"5161", "5189", "5210", "5211", "5220", "5221", "5230", "5400", "5428",
                                   "<_x>", "<_feed>", "<_value>", "<_line>", "5061", "<_task>"})
        EXPECT_EQ(read_program("#" + name + " = 1\nM2\n")->faults(), Faults{"1:1 parameter_kept"}) << name;
    for (const std::string name : {"1", "30", "31", "5000", "5060", "5231", "5420.00001", "<x>", "<_mine>"}) {
        const bool is_kept = name == "5420.00001";
        EXPECT_EQ(read_program("#" + name + " = 1\nM2\n")->problems.error_count(), is_kept ? 1U : 0U) << name;
    }
}

TEST(ProgramParameters, OfWhatIsNotThereAreNeverNought) {
    for (const std::string name : {"#5061", "#5070", "#5399", "#5401", "#5413", "#5600", "#<_ccomp>",
                                   "#<_feed_override>", "#<_vmajor>", "#<_ini[a]b>"})
        EXPECT_EQ(read_program("G0 X" + name + "\nM2\n")->faults(), Faults{"1:5 not_read"}) << name;
}

TEST(ProgramParameters, HaveBoundedMemory) {
    std::string text;
    for (int i = 0; i < 10'000; ++i) text += "#<n" + std::to_string(i) + "> = 1\n";
    EXPECT_EQ(read_program(text + "#<n5> = 2\nM2\n")->faults(), Faults{});
    EXPECT_EQ(read_program(text + "#<more> = 2\nM2\n")->faults(), Faults{"10001:1 parameter_many"});
    // Those of a call are given back.
    const std::string in_calls =
        "o1 sub\n#<a> = 1 #<b> = 2\no1 endsub\no2 repeat [20000]\no1 call\nG4 P1\no2 endrepeat\nM2\n";
    EXPECT_EQ(read_program(in_calls)->faults(), Faults{});
}

TEST(ProgramParameters, DoNotTellAgainOfWhatFollowsFromAFault) {
    EXPECT_EQ(read_program("#<a> = [1/0]\nG0 X#<a>\nX[1/#<a>]\nM2\n")->faults(),
              Faults{"1:10 value_impossible"});
    EXPECT_EQ(read_program("#<a> = [1/0]\nG0 X[1\nM2\n")->faults(),
              (Faults{"1:10 value_impossible", "2:5 bracket_missing"}));
}

TEST(ProgramParameters, OfAPlaceThatIsNotKnownJudgeNoTravel) {
    const Profile profile;
    // Where the machine stands is anyone's guess, so X is not known to be beyond its end.
    EXPECT_EQ(read_program("G0 X[#5420 - 500]\nM2\n", {}, &profile)->faults(), Faults{});
    EXPECT_EQ(read_program("#1 = #<_x>\nG0 X[#1 - 500]\nG0 X900\nM2\n", {}, &profile)->faults(),
              Faults{"3:4 outside_travel"});
    EXPECT_EQ(read_program("G0 X30\nX[#5420 - 500]\nM2\n", {}, &profile)->faults(),
              Faults{"2:1 outside_travel"});
}

}  // namespace
}  // namespace psicarve::gcode
