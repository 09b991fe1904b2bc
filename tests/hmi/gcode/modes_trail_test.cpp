// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/modes_trail.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

/// Reads a program as `gcode run` does, all of it before the machine takes a step.
class ReadAhead : public CanonSink, public RecordSink {
public:
    explicit ReadAhead(const std::string& text, std::size_t most_ways = 1000,
                       const KeptOffsets& offsets = {}) {
        const Profile profile;
        InterpreterOptions options = machine_options(profile);
        options.start = options.reference;
        options.offsets = offsets;
        trail_.emplace(profile.gcode, options.start, most_ways);
        RecordMaker maker{profile, {}, *this};
        maker_ = &maker;
        ProblemList problems;
        LineSource lines{bytes_of(text)};
        EXPECT_TRUE(interpret_program(lines, options, *this, problems).has_value());
        EXPECT_EQ(problems.error_count(), 0U);
        trail_->begin_way(maker.record_count() + 1);
        EXPECT_TRUE(maker.finish().has_value());
    }

    void take(const CanonRecord& record) override {
        trail_->begin_way(maker_->record_count() + 1);
        held_from.emplace_back(maker_->record_count() + 1, modes_);
        maker_->take(record);
    }
    void end_block() override { maker_->end_block(); }
    void set_modes(const ActiveModes& modes) override {
        trail_->set_modes(modes);
        modes_ = modes;
        ++modes_count;
    }
    bool wants_modes() const noexcept override { return true; }
    Result<void> take(const MotionRecord& record) override {
        trail_->note(record);
        records.push_back(record);
        return {};
    }

    ModesTrail& trail() { return *trail_; }
    const ModesTrail& trail() const { return *trail_; }
    std::vector<MotionRecord> records;
    int modes_count = 0;
    std::vector<std::pair<std::uint64_t, ActiveModes>> held_from;  ///< all of it, never shortened

private:
    ActiveModes modes_;
    std::optional<ModesTrail> trail_;
    RecordMaker* maker_ = nullptr;
};

std::vector<int> codes_of(const ProgramModes& modes) {
    std::vector<int> codes;
    for (const int code : modes.g_codes)
        if (code >= 0) codes.push_back(code);
    for (const int code : modes.m_codes)
        if (code >= 0) codes.push_back(code);
    return codes;
}

bool has_code(const ProgramModes& modes, int tenths) {
    return std::ranges::count(modes.g_codes, tenths) > 0;
}

double zero_of(const ProgramModes& modes, Axis axis) {
    return modes.zero[index_of(axis)];
}

TEST(ModesTrail, TellsInFrontOfAProgramWhatItBeginsWith) {
    ReadAhead sut{"G20 G91 F3\nG0 X-1\nM2\n"};
    const auto told = sut.trail().at(0);
    ASSERT_TRUE(told);
    EXPECT_EQ(codes_of(*told),
              (std::vector<int>{800, 170, 210, 900, 940, 540, 640, 400, 490, 990, 911, 131,  //
                                5, 9, 48}));
    EXPECT_EQ(told->sequence, 0U);
    EXPECT_EQ(told->feed, 0.0);
}

TEST(ModesTrail, TellsOfEachWayWhatHoldsThereThoughAllIsRead) {
    ReadAhead sut{
        "G21 G90 G94 G10 L2 P2 X30 Y4\nG0 X40 Y5\nG55 G61 S900 M3 F250\nG1 X12\nG92 X2\nG91 M7\nM8\n"
        "G1 X1 F0.5 G93\nG54 G92.1 M5\nG90 G0 X41\nM2\n"};
    ASSERT_EQ(sut.records.size(), 7U);
    const auto first = sut.trail().at(1);
    ASSERT_TRUE(first);
    EXPECT_TRUE(has_code(*first, 0) && has_code(*first, 540) && has_code(*first, 900));
    EXPECT_EQ(first->end[index_of(Axis::r1)], 40.0);
    EXPECT_EQ(first->line, 2U);
    const auto second = sut.trail().at(3);
    ASSERT_TRUE(second);
    EXPECT_TRUE(has_code(*second, 10) && has_code(*second, 550) && has_code(*second, 610));
    EXPECT_EQ(zero_of(*second, Axis::r1), 30.0);
    EXPECT_EQ(zero_of(*second, Axis::y), 4.0);
    EXPECT_EQ(second->end[index_of(Axis::r1)], 42.0);
    EXPECT_EQ(second->end[index_of(Axis::y)], 5.0) << "that does not move";
    EXPECT_EQ(second->m_codes[0], 3);
    EXPECT_EQ(second->feed, 250.0);
    EXPECT_EQ(second->speed_rpm, 900.0);
    const auto third = sut.trail().at(4);
    ASSERT_TRUE(third);
    EXPECT_TRUE(has_code(*third, 910) && has_code(*third, 930));
    EXPECT_EQ(zero_of(*third, Axis::r1), 40.0) << "G55 and G92";
    EXPECT_EQ(third->end[index_of(Axis::r1)], 43.0);
    EXPECT_EQ(third->m_codes[1], 7);
    EXPECT_EQ(third->m_codes[2], 8);
    EXPECT_EQ(third->feed, 0.5);
    const auto last = sut.trail().at(6);
    ASSERT_TRUE(last);
    EXPECT_TRUE(has_code(*last, 540) && has_code(*last, 900) && has_code(*last, 0));
    EXPECT_EQ(zero_of(*last, Axis::r1), 0.0);
    EXPECT_EQ(last->m_codes[0], 5);
}

TEST(ModesTrail, KnowsASystemThatIsSetWhileItHolds) {
    ReadAhead sut{"G21 G90\nG0 X40\nG10 L2 P1 X5 R0\nG0 X36\nG10 L2 P1 X0\nG0 X42\nM2\n"};
    EXPECT_EQ(zero_of(sut.trail().at(1).value(), Axis::r1), 0.0);
    EXPECT_EQ(zero_of(sut.trail().at(2).value(), Axis::r1), 5.0);
    EXPECT_EQ(sut.trail().at(2)->end[index_of(Axis::r1)], 41.0);
    EXPECT_EQ(zero_of(sut.trail().at(3).value(), Axis::r1), 0.0);
}

TEST(ModesTrail, HasTheEndOfEachPassOfALoop) {
    ReadAhead sut{"G21 G91 F300\nG0 X-20\no1 repeat [3]\nG1 X-1\no1 endrepeat\nM2\n"};
    ASSERT_EQ(sut.records.size(), 5U);
    const double begin_mm = sut.records[0].target[0];
    for (std::uint64_t pass = 1; pass <= 3; ++pass) {
        const auto told = sut.trail().at(pass + 1);
        ASSERT_TRUE(told);
        EXPECT_EQ(told->sequence, pass + 1);
        EXPECT_EQ(told->line, 4U);
        EXPECT_NEAR(told->end[index_of(Axis::r1)], begin_mm - static_cast<double>(pass), 1e-9);
    }
}

TEST(ModesTrail, HoldsAnArcForOneWay) {
    ReadAhead sut{"G21 G90 F300\nG0 X40 Y5\nG3 X42 Y7 I2 J0\nG0 X45\nM2\n"};
    const std::uint64_t arc_end = sut.records.size() - 2;
    ASSERT_GT(arc_end, 10U) << "of many chords";
    for (const std::uint64_t sequence : {std::uint64_t{2}, arc_end / 2, arc_end}) {
        const auto told = sut.trail().at(sequence);
        ASSERT_TRUE(told);
        EXPECT_EQ(told->sequence, arc_end);
        EXPECT_TRUE(has_code(*told, 30));
        EXPECT_EQ(told->end[index_of(Axis::r1)], 42.0);
        EXPECT_EQ(told->end[index_of(Axis::y)], 7.0);
    }
}

TEST(ModesTrail, NamesACycleInItsMoves) {
    ReadAhead sut{"G21 G90 G17 F300\nG0 X50 Z50 Y5\nG81 X49 Z40 R45\nG80\nG0 X50\nM2\n"};
    const auto told = sut.trail().at(3);
    ASSERT_TRUE(told);
    EXPECT_TRUE(has_code(*told, 810));
    EXPECT_TRUE(has_code(sut.trail().at(sut.records.size() - 1).value(), 0));
}

TEST(ModesTrail, TellsTheInterpretersModesOnlyWhenTheyChange) {
    std::string text = "G21 G90 F300\nG0 X40\n";
    for (int i = 0; i < 100; ++i) text += "G1 X" + std::to_string(40 + i % 2) + " F300\n";
    const ReadAhead sut{text + "M2\n"};
    EXPECT_LE(sut.modes_count, 4);
}

// Codes, rates and zeros change one by one and together, and more sets of codes come in turn than are kept.
TEST(ModesTrail, TellsOfEachRecordWhatHeldWhenItWasRead) {
    std::mt19937 random(17);
    const auto one_of = [&random](int count) { return static_cast<int>(random() % unsigned(count)); };
    std::string text = "G21 G90 G94 F100\nG0 X40 Y5\n";
    for (int i = 0; i < 2000; ++i) {
        if (one_of(3) == 0) text += "G" + std::to_string(54 + one_of(6)) + "\n";
        if (one_of(9) == 0)
            text += "G10 L2 P" + std::to_string(1 + one_of(6)) + " Y" + std::to_string(one_of(5)) + "\n";
        if (one_of(9) == 0) text += "G92 Y" + std::to_string(one_of(7)) + "\n";
        if (one_of(5) == 0) text += one_of(2) == 0 ? "M3\n" : "M5\n";
        if (one_of(5) == 0)
            text += "M" + std::to_string(7 + one_of(3)) + " T" + std::to_string(one_of(9)) + "\n";
        text += "G53 G" + std::to_string(one_of(2)) + " X" + std::to_string(40 + i % 2);
        if (one_of(2) == 0) text += " F" + std::to_string(100 + one_of(9));
        if (one_of(4) == 0) text += " S" + std::to_string(500 + one_of(9));
        text += "\n";
    }
    ReadAhead sut{text + "M2\n", 100'000};
    const AxisLetters letters{Profile{}.gcode};
    auto held = sut.held_from.begin();
    ASSERT_GT(sut.records.size(), 2000U);
    for (std::uint64_t sequence = 1; sequence < sut.records.size(); ++sequence) {
        while (std::next(held) != sut.held_from.end() && std::next(held)->first <= sequence) ++held;
        const ActiveModes& wanted = held->second;
        const auto told = sut.trail().at(sequence);
        ASSERT_TRUE(told) << sequence;
        EXPECT_EQ(told->line, sut.records[sequence - 1].line);
        EXPECT_EQ(told->g_codes, wanted.g_codes) << sequence;
        EXPECT_EQ(told->m_codes, wanted.m_codes) << sequence;
        EXPECT_EQ(told->tool, wanted.tool) << sequence;
        EXPECT_EQ(told->feed, wanted.feed) << sequence;
        EXPECT_EQ(told->speed_rpm, wanted.speed_rpm) << sequence;
        EXPECT_EQ(told->rotation_deg, wanted.rotation_deg) << sequence;
        for (const Axis axis : kAllAxes)
            EXPECT_EQ(zero_of(*told, axis), wanted.zero[letters.letter_of(axis)]) << sequence;
    }
}

TEST(ModesTrail, ForgetsTheOldestWhereItMayKeepNoMore) {
    std::string text = "G21 G90\n";
    for (int i = 0; i < 50; ++i)
        text += "G1 X" + std::to_string(40 + i % 2) + " F" + std::to_string(100 + i) + "\n";
    ReadAhead sut{text + "M2\n", 10};
    EXPECT_LE(sut.trail().way_count(), 10U);
    EXPECT_FALSE(sut.trail().at(0));
    EXPECT_FALSE(sut.trail().at(30)) << "not known is better than wrong";
    const auto told = sut.trail().at(45);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->feed, 144.0);
}

// Lines shorter than a pulse: the core is further behind than there are ways to keep.
TEST(ModesTrail, KnowsWhatHoldsForWaysThatItHasForgotten) {
    std::string text = "G21 G90 F100\n";
    for (int i = 0; i < 50; ++i) {
        if (i == 20) text += "G55 F200\n";
        text += "G1 X" + std::to_string(40 + i % 2) + "\n";
    }
    ReadAhead sut{text + "M2\n", 10};
    EXPECT_LE(sut.trail().way_count(), 10U);
    const auto told = sut.trail().at(5);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->feed, 100.0);
    EXPECT_TRUE(has_code(*told, 540));
    EXPECT_EQ(told->sequence, 20U) << "as far as that holds";
    EXPECT_EQ(told->line, 0U);
    for (const double end : told->end) EXPECT_TRUE(std::isnan(end));
    const auto second = sut.trail().at(25);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->feed, 200.0);
    EXPECT_TRUE(has_code(*second, 550));
    EXPECT_GE(second->sequence, 25U);
    const auto kept = sut.trail().at(second->sequence + 1);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->feed, 200.0);
    EXPECT_FALSE(std::isnan(kept->end[0])) << "of the first way that is kept";
}

TEST(ModesTrail, KeepsNothingBehindTheMachine) {
    std::string text = "G21 G90 F300\n";
    for (int i = 0; i < 50; ++i) text += "G1 X" + std::to_string(40 + i % 2) + "\n";
    ReadAhead sut{text + "M2\n"};
    EXPECT_EQ(sut.trail().way_count(), 52U) << "and the one in front";
    ASSERT_TRUE(sut.trail().at(50));
    EXPECT_EQ(sut.trail().way_count(), 2U);
}

// A ring of 65 536 records and all that the core has taken are some 90 000 ways, and few MB are for them.
TEST(ModesTrail, KeepsFewBytesOfWaysThatChangeAlmostEverything) {
    constexpr int kWays = 2000;
    constexpr std::size_t kMostBytesAWay = 72;
    std::string text = "G21 G90\nG10 L2 P2 X0.1 Y0.3 Z0.7\nG10 L2 P3 X0.3\nG0 X40 Y5 Z50\n";
    for (int i = 0; i < kWays; ++i) {
        text += "G" + std::to_string(i % 2) + " G" + std::to_string(54 + i % 3) + " X40." +
                std::to_string(i) + "1 Y5." + std::to_string(i) + "3 F" + std::to_string(100 + i) + "\n";
    }
    const ReadAhead sut{text + "M2\n", 100'000};
    ASSERT_GT(sut.trail().way_count(), std::size_t{kWays});
    EXPECT_LT(sut.trail().kept_bytes(), kMostBytesAWay * sut.trail().way_count());
}

}  // namespace
}  // namespace psicarve::gcode
