// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/judged_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

/// A stream that is judged, made and written down as it comes, and how much of it was held at most.
class JudgedStream : public CanonSink {
public:
    explicit JudgedStream(const std::string& text, const Profile& profile = {}) : profile_(profile) {
        InterpreterOptions options = machine_options(profile_);
        options.start = options.reference;
        options.ends_with_input = true;
        LineSource lines{bytes_of(text)};
        EXPECT_TRUE(interpret_program(lines, options, *this, problems).has_value());
        motion_.end_block();
        EXPECT_TRUE(maker_.finish().has_value());
    }

    void take(const CanonRecord& record) override {
        motion_.take(record);
        ++taken_;
        const std::uint64_t made = maker_.record_count();
        if (taken_ > made) most_held = std::max(most_held, taken_ - made);
    }
    void begin_line(const ReachedLine& line) override { motion_.begin_line(line); }
    void end_block() override { motion_.end_block(); }
    void set_offsets(const KeptOffsets& kept) override { motion_.set_offsets(kept); }
    void set_modes(const ActiveModes& modes) override { motion_.set_modes(modes); }
    bool wants_modes() const noexcept override { return motion_.wants_modes(); }
    bool wants_more() const noexcept override { return motion_.wants_more(); }
    CanonSink* rehearsal() override { return motion_.rehearsal(); }

    RecordList list;
    ProblemList problems;
    std::uint64_t most_held = 0;  ///< canonical records

private:
    Profile profile_;
    RecordMaker maker_{profile_, {}, list};
    KeptOffsets offsets_;
    ModesTrail trail_{profile_.gcode, machine_options(profile_).reference, 1000};
    JudgedMotion motion_{profile_, problems, maker_, offsets_, trail_};
    std::uint64_t taken_ = 0;
};

constexpr const char* kJudgedBegin = "G21 G90 F300\nG0 X50 Z50 Y20\n";

bool are_same(const MotionRecord& first, const MotionRecord& second) {
    return std::memcmp(&first, &second, sizeof first) == 0;
}

// Long cycles are judged before they are carried out, and not once more.
TEST(JudgedMotion, TellsOfEachWayOnceHoweverLongItsBlock) {
    Profile profile;
    profile.gcode.is_stepwise = true;
    profile.gcode.second_head = SecondHead::follow;
    // Both heads drill: no such way is stepped.
    const JudgedStream stream{"G21 G90 F300\nG0 X50 Y20\nG19 G83 Y30 X40 R45 Q1\n", profile};
    EXPECT_EQ(stream.problems.error_count(), 0U);
    ASSERT_EQ(stream.problems.warnings().size(), 1U);
    EXPECT_EQ(stream.problems.warnings()[0].code, ProblemCode::not_stepped);
    EXPECT_EQ(stream.problems.warnings()[0].times, 5U);
}

TEST(JudgedMotion, GivesNothingOfABlockThatIsWrong) {
    const std::vector<std::string> blocks{"G81 X40 Y30 Z-5 R45",
                                          "G82 X40 Y30 Z-5 R45 P.1",
                                          "G83 X40 Y30 Z-5 R45 Q9",
                                          "G91 G81 X-.01 Z-.5 R0 L9000",
                                          "G28 X40 Z99",
                                          "G30 X40 M98",
                                          "M3 G0 X99",
                                          "G4 P1 G0 X99",
                                          "G0 X40 M98",
                                          "G81 X40 Y30 Z40 R45 L2 M98",
                                          "G0 X40 Z99",
                                          "G83 X40 Y30 Z-5 R45 Q.001",
                                          "G2 X50 Y20 I-1 J0 P3 Z-5 M98",
                                          "M3 G81 X40 Y30 Z-5 R45"};
    for (const std::string& block : blocks) {
        const JudgedStream right{kJudgedBegin};
        const JudgedStream wrong{kJudgedBegin + block + "\nG0 X41\n"};
        EXPECT_GE(wrong.problems.error_count(), 1U) << block;
        EXPECT_EQ(wrong.problems.errors().front().line, 3U) << block;
        ASSERT_EQ(right.list.records.size(), 2U);
        // The way there, and the end.
        ASSERT_EQ(wrong.list.records.size(), 2U) << block;
        EXPECT_TRUE(are_same(wrong.list.records[0], right.list.records[0])) << block;
        EXPECT_EQ(wrong.list.records[1].kind, MotionKind::end) << block;
    }
}

// A rehearsed block changes nothing that the next one sees.
TEST(JudgedMotion, GivesTheRecordsOfAFile) {
    const std::string text =
        std::string{kJudgedBegin} +
        "M3 S100 G83 X40 Y30 Z30 R45 Q.4\nY31\nG91 G81 X-.5 Z-2 R-1 L4\nG90 G82 X42 Y30 Z30 R45 P.1 L2\n"
        "G80 G28 X40 Z45\nG0 X50 Z50\nG92 X0\nG0 X1 Z50\nG99 G83 X2 Z40 R45 Q1 L3\nG1 X3 F200\n"
        "o1 repeat [3]\nG91 G83 X.2 Z-3 R-1 Q1\no1 endrepeat\nG90 G0 X2 M5\n#1 = 2\nG81 X#1 Z40 R45 L2\nM2\n";
    const JudgedStream stream{text};
    EXPECT_EQ(stream.problems.error_count(), 0U);
    const MadeRecords made = made_records(text);
    EXPECT_EQ(made.faults, Faults{});
    ASSERT_EQ(stream.list.records.size(), made.records.size());
    EXPECT_GT(made.records.size(), 150U);
    for (std::size_t n = 0; n < made.records.size(); ++n)
        EXPECT_TRUE(are_same(stream.list.records[n], made.records[n])) << n;
}

TEST(JudgedMotion, HoldsLittleOfALongBlock) {
    const JudgedStream stream{std::string{kJudgedBegin} + "G83 X40 Y30 Z10 R45 Q.0005\n"};
    EXPECT_EQ(stream.problems.error_count(), 0U);
    EXPECT_GT(stream.list.records.size(), 200'000U);
    EXPECT_LT(stream.most_held, 10U);
}

// What is told of a long block that is wrong is told once.
TEST(JudgedMotion, TellsTheFirstFaultOfALongBlock) {
    const JudgedStream stream{std::string{kJudgedBegin} + "G91 G81 X-.01 Z-.5 R0 L9000\n"};
    EXPECT_EQ(stream.problems.error_count(), 1U);
}

}  // namespace
}  // namespace psicarve::gcode
