// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/flow_control.hpp"

#include <sstream>

#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

/// The same text as a file, in pieces of a few bytes so that lines lie across them.
ProgramBytes file_of(const std::string& text) {
    const auto at = std::make_shared<std::size_t>(0);
    ByteSource read = [text, at](std::span<char> room) -> Result<std::size_t> {
        const std::size_t count = std::min({std::size_t{7}, room.size(), text.size() - *at});
        std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(*at), count, room.begin());
        *at += count;
        return count;
    };
    return {std::move(read), [at](std::uint64_t offset) -> Result<void> {
                *at = offset;
                return {};
            }};
}

std::unique_ptr<ReadProgram> read_file(const std::string& text, const InterpreterOptions& options = {}) {
    auto read = std::make_unique<ReadProgram>();
    LineSource lines{file_of(text)};
    const auto facts = interpret_program(lines, options, *read, read->problems);
    EXPECT_TRUE(facts.has_value());
    if (facts) read->facts = *facts;
    return read;
}

/// "LINE:X " of all moves.
std::string moves_of(const ReadProgram& read) {
    std::ostringstream text;
    for (const CanonRecord& record : read.records)
        if (record.kind == CanonKind::rapid) text << record.line << ':' << record.end[0] << ' ';
    return text.str();
}

/// As a file and as a stream alike.
std::string moves_in(const std::string& text) {
    const auto streamed = read_program(text);
    const auto stored = read_file(text);
    EXPECT_EQ(streamed->faults(), Faults{}) << text;
    EXPECT_EQ(moves_of(*streamed), moves_of(*stored)) << text;
    EXPECT_EQ(stored->faults(), Faults{}) << text;
    EXPECT_EQ(streamed->facts.line_count, stored->facts.line_count) << text;
    return moves_of(*stored);
}

Faults faults_in(const std::string& text, const InterpreterOptions& options = {}) {
    const auto streamed = read_program(text, options);
    EXPECT_EQ(streamed->faults(), read_file(text, options)->faults()) << text;
    return streamed->faults();
}

TEST(Flow, KeepsTheNumbersOfLinesThatAreReadAgain) {
    EXPECT_EQ(moves_in("o1 repeat [2]\nG91 G0 X1\nX2\no1 endrepeat\nX4\nM2\n"), "2:1 3:3 2:4 3:6 5:10 ");
}

TEST(Flow, FindsASubroutineBehindItsCallAndTheEnd) {
    EXPECT_EQ(moves_in("o1 call [3]\nM98 P7 L2\nM2\nO7\nG0 X9\nM99\no1 sub\nG0 X#1\no1 endsub\n"),
              "8:3 5:9 5:9 ");
    EXPECT_EQ(moves_in("%\nG0 X1\no1 call [3]\nX4\no1 sub\nG0 X#1\no1 endsub\nX5\n%\nG0 X99\n"),
              "2:1 6:3 4:4 8:5 ");
}

TEST(Flow, CallsWithinLoopsAndLoopsWithinCalls) {
    const std::string text =
        "o<step> sub\no2 while [#2 LT #1]\n#2=[#2+1]\nG0 X[10*#1+#2]\no2 endwhile\no<step> endsub\n"
        "o1 while [#3 LT 2]\n#3=[#3+1]\no<step> call [#3]\nX[#3]\no1 endwhile\nM2\n";
    EXPECT_EQ(moves_in(text), "4:11 10:1 4:21 4:22 10:2 ");
}

TEST(Flow, LeavesLoopsFromWithinOthers) {
    EXPECT_EQ(
        moves_in("o1 while [1]\no2 repeat [3]\nG0 X1\no1 break\no2 endrepeat\nX2\no1 endwhile\nX3\nM2\n"),
        "3:1 8:3 ");
    EXPECT_EQ(
        moves_in("o1 do\n#1=[#1+1]\no2 do\nG0 X#1\no1 continue\no2 while [1]\nX9\no1 while [#1 LT 3]\nM2\n"),
        "4:1 4:2 4:3 ");
    // LinuxCNC takes the break further down for the continue.
    EXPECT_EQ(moves_in("o3 do\n#2=[#2+1]\no4 if [#2 EQ 2]\no3 continue\no4 endif\no5 if [#2 EQ 4]\no3 break\n"
                       "o5 endif\nG0 X#2\no3 while [#2 LT 9]\nM2\n"),
              "9:1 9:3 ");
    EXPECT_EQ(
        moves_in(
            "o1 repeat [3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nG0 X#1\no1 endrepeat\nM2\n"),
        "6:1 6:3 ");
}

TEST(Flow, ReturnsFromWithinLoopsOfTheSubroutine) {
    EXPECT_EQ(
        moves_in("o1 sub\no2 repeat [9]\no3 if [1]\nG0 X1\no1 return\no3 endif\no2 endrepeat\no1 endsub\n"
                 "o4 repeat [2]\no1 call\nX2\no4 endrepeat\nM2\n"),
        "4:1 11:2 4:1 11:2 ");
    EXPECT_EQ(moves_in("M98 P1\nG0 X2\nM2\nO1\no2 while [1]\nG0 X1\nM99\no2 endwhile\nM99\n"), "6:1 2:2 ");
}

TEST(Flow, MayUseANumberAgain) {
    EXPECT_EQ(
        moves_in(
            "o1 repeat [1]\nG0 X1\no1 endrepeat\no1 while [#1 LT 2]\n#1=[#1+1]\nG0 X2\no1 endwhile\nM2\n"),
        "2:1 6:2 6:2 ");
}

TEST(Flow, PassesOverWhatIsNotRunButJudgesHowItIsWritten) {
    EXPECT_EQ(faults_in("o1 if [0]\nG0 X[1/0] Y#<never>\no2 call [1/0]\no3 while [#<never>]\no3 endwhile\no1 "
                        "endif\nM2\n"),
              Faults{});
    EXPECT_EQ(faults_in("o1 if [0]\nG0 X[1\no1 endif\nM2\n"), Faults{"2:5 bracket_missing"});
    EXPECT_EQ(faults_in("o1 sub\nG0 X&\no1 endsub\nM2\n"), Faults{"2:4 number_missing"});
}

TEST(Flow, IsNotFollowedBehindAFault) {
    EXPECT_EQ(faults_in("o1 repeat [5]\nG0 G1 X1\no1 endrepeat\no2 endif\nG0 X[\nM2\n"),
              (Faults{"2:4 group_conflict", "5:6 number_missing"}));
    EXPECT_EQ(faults_in("o1 sub\nG0 G1\no1 endsub\no1 call\nG0 X[\nM2\n"),
              (Faults{"2:4 group_conflict", "5:6 number_missing"}));
    EXPECT_EQ(faults_in("M98 P1\nG0 X[\nM2\nO1\nG0 G1\nM99\nG0 Y&\n"),
              (Faults{"5:4 group_conflict", "7:4 number_missing"}));
    EXPECT_EQ(faults_in("o1 while #1\nG0 X1\no1 endwhile\n"), Faults{"1:10 bracket_missing"});
}

TEST(Flow, LeavesOutDeletedBlocks) {
    InterpreterOptions options;
    options.skips_deleted = true;
    const std::string text = "/o1 if [0]\nG0 X1\n/o1 endif\nM98 P5\nM2\n/O5\n/M2\nO5\nG0 X3\nM99\n";
    EXPECT_EQ(moves_of(*read_program(text, options)), "2:1 9:3 ");
    EXPECT_EQ(moves_of(*read_file(text, options)), "2:1 9:3 ");
}

TEST(Flow, EndsALoopThatMovesNothing) {
    EXPECT_EQ(read_program("o1 while [1]\no1 endwhile\nM2\n")->faults(), Faults{"2:1 endless"});
    InterpreterOptions options;
    options.most_idle_blocks = 1000;
    const auto faults = [&](const std::string& text) { return faults_in(text + "M2\n", options); };
    EXPECT_EQ(faults("o1 do\n#1=[#1+1]\nM3\no1 while [1]\n"), Faults{"3:1 endless"});
    EXPECT_EQ(faults("o1 sub\no2 repeat [10]\no2 endrepeat\no1 endsub\no3 while [1]\no1 call\no3 endwhile\n"),
              Faults{"3:1 endless"});
    EXPECT_EQ(faults("o1 repeat [900]\n#1=[#1+1]\no1 endrepeat\n"), Faults{"2:1 endless"});
    EXPECT_EQ(faults("o1 while [1]\nG0 X5\no1 endwhile\n"), Faults{"3:1 endless"});
    // A dwell lasts, too, and so do a stop and a whole circle.
    EXPECT_EQ(faults("o1 repeat [600]\nG4 P0.1\no1 endrepeat\n"), Faults{});
    EXPECT_EQ(faults("o1 repeat [600]\nM0\no1 endrepeat\n"), Faults{});
    EXPECT_EQ(faults("F100\no1 repeat [600]\nG2 I1\no1 endrepeat\n"), Faults{});
    // What stands behind the loop is no part of it.
    EXPECT_EQ(faults("o1 repeat [2]\no1 endrepeat\n" + std::string(2000, '\n')), Faults{});
}

TEST(Flow, CountsNoLinesThatAreReadFirstBehindAFarCall) {
    InterpreterOptions options;
    options.most_idle_blocks = 1000;
    options.most_repeated_blocks = 1000;
    EXPECT_EQ(faults_in("o1 call\n" + std::string(2000, '\n') + "M2\no1 sub\nG0 X1\no1 endsub\n", options),
              Faults{});
    EXPECT_EQ(faults_in("o1 call\nM2\no1 sub\n" + std::string(2000, '\n') + "o1 endsub\n", options),
              Faults{"1004:1 endless"});
}

TEST(Flow, FindsASubroutineBehindAComment) {
    EXPECT_EQ(moves_in("o1 call\nM98 P7\nM2\n(a) N5 (b) o1 sub\nG0 X1\no1 endsub\n(c) O7\nG0 X2\nM99\n"),
              "5:1 8:2 ");
}

TEST(Flow, EndsALoopThatMovesForEver) {
    InterpreterOptions options;
    options.most_repeated_blocks = 10'000;
    const auto read = read_program("o1 while [1]\nG0 X1\nX2\no1 endwhile\nM2\n", options);
    ASSERT_EQ(read->problems.error_count(), 1U);
    EXPECT_EQ(read->problems.errors().front().code, ProblemCode::too_many_blocks);
}

TEST(Flow, EndsARecursion) {
    EXPECT_EQ(faults_in("o1 sub\nG91 G0 X1\no1 call\no1 endsub\no1 call\nM2\n"), Faults{"3:1 too_deep"});
    EXPECT_EQ(faults_in("M98 P1\nM2\nO1\nM98 P1\nM99\n"), Faults{"4:1 too_deep"});
}

TEST(Flow, WarnsOnceOfWhatALoopRepeats) {
    const Profile profile;
    const auto read = read_program("o1 repeat [50]\nS#1\n#1=[#1+1]\no1 endrepeat\nM2\n", {}, &profile);
    EXPECT_EQ(read->problems.warning_count(), 1U);
}

TEST(Flow, IsNotEndedByAPercentWithinABlock) {
    EXPECT_EQ(faults_in("%\nF100\no1 repeat [10]\nG91 G1 Y1\n%\n"), Faults{"3:1 o_word_open"});
    EXPECT_EQ(faults_in("%\no1 if [1]\nG0 X1\n%\n"), Faults{"2:1 o_word_open"});
    EXPECT_EQ(faults_in("%\nF100\no1 call\nG1 X30\nM2\no1 sub\nG1 X5\n%\n"), Faults{"6:1 o_word_open"});
    EXPECT_EQ(faults_in("%\nM98 P1\nM2\nO1\nG0 X5\n%\n"), Faults{"2:1 o_word_open"});
    EXPECT_EQ(moves_in("%\no1 repeat [2]\nG0 X1\no1 endrepeat\n%\n"), "3:1 3:1 ");
}

TEST(Flow, MayBeEndedWithinABlockThatHasAnEnd) {
    EXPECT_EQ(faults_in("F100\no1 repeat [10]\nG1 Y1\nM2\n"), Faults{"2:1 o_word_open"});
    EXPECT_EQ(faults_in("o1 repeat [10]\no2 if [1]\nG0 Y1\nM2\no2 endif\n"), Faults{"1:1 o_word_open"});
    EXPECT_EQ(faults_in("%\no1 if [1]\nG0 Y1\nM30\n%\no1 endif\n"), Faults{"2:1 o_word_open"});
    EXPECT_EQ(faults_in("o1 if [1]\nG0 Y1\nM2\no2 endif\n"), Faults{"4:1 o_word_unmatched"});
    EXPECT_EQ(moves_in("o1 while [1]\nG0 X1\no2 if [#1 EQ 1]\nM2\no2 else\n#1=1\no2 endif\no1 endwhile\n"
                       "X9 &\n"),
              "2:1 2:1 ");
}

/// A stream that never ends: a loop's begin, and then lines.
std::unique_ptr<ReadProgram> read_endless(const std::string& begin, const std::string& line) {
    auto read = std::make_unique<ReadProgram>();
    const auto has_begun = std::make_shared<bool>(false);
    LineSource lines{ByteSource{[=](std::span<char> room) -> Result<std::size_t> {
        std::size_t at = *has_begun ? 0 : begin.copy(room.data(), room.size());
        *has_begun = true;
        while (at + line.size() <= room.size()) at += line.copy(room.data() + at, line.size());
        return at;
    }}};
    EXPECT_TRUE(interpret_program(lines, {}, *read, read->problems).has_value());
    return read;
}

TEST(Flow, KeepsOnlySoMuchOfAStream) {
    const std::string line = "G4 P1 (" + std::string(900, 'x') + ")\n";
    for (const std::string begin : {"o1 while [1]\n", "o1 sub\n", "o1 call\n", "M98 P1\n"}) {
        const auto read = read_endless(begin, line);
        ASSERT_EQ(read->problems.error_count(), 1U) << begin;
        EXPECT_EQ(read->problems.errors().front().code, ProblemCode::text_too_long) << begin;
    }
}

TEST(Flow, KeepsNothingOfLoopsThatAreOver) {
    std::string text = "o1 sub\nG4 P1\no1 endsub\n";
    const std::string comment(1000, 'x');
    for (int i = 0; i < 70; ++i) {
        text += "o2 repeat [1]\n";
        for (int k = 0; k < 1000; ++k) text += "(" + comment + ")\n";
        text += "o1 call\no2 endrepeat\n";
    }
    const auto read = read_program(text + "M2\n");
    EXPECT_EQ(read->faults(), Faults{});
    EXPECT_EQ(read->of_kind(CanonKind::dwell).size(), 70U);
}

}  // namespace
}  // namespace psicarve::gcode
