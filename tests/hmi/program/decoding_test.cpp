// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/decoding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "hmi/offsets/offsets_file.hpp"
#include "hmi/offsets/offsets_lock.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::program {
namespace {

class Decoding : public ::testing::Test {
protected:
    std::string file(const std::string& text) {
        const std::string path = folder_.path("program.ngc");
        std::ofstream{path} << text;
        return path;
    }
    DecodedPointer decoded(const std::string& text, std::uint32_t from_line = 1) {
        DecodeRequest request;
        request.path = file(text);
        request.from_line = from_line;
        DecodeProgress progress;
        const auto read = decode(request, progress);
        EXPECT_TRUE(read);
        return read ? *read : nullptr;
    }
    test::TemporaryFolder folder_;
};

TEST_F(Decoding, TellsErrorsLinesAndPathOfAProgram) {
    const auto sut = decoded("G21 G90\nG0 X30 Z30\nG1 Y5\nG1 F600 Y10 C90\nM2\nbehind its end\n");
    ASSERT_EQ(sut->problems.error_count(), 1U);
    EXPECT_EQ(sut->problems.errors()[0].line, 3U);
    EXPECT_EQ(sut->problems.errors()[0].code, gcode::ProblemCode::feed_missing);
    EXPECT_FALSE(sut->is_right());
    EXPECT_EQ(sut->facts.line_count, 5U);
    EXPECT_EQ(sut->lines.line_count(), 6U) << "what stands behind its end is shown, too";
    EXPECT_FALSE(sut->path.empty());
}

TEST_F(Decoding, TellsWhatARunFromALineDoesFirst) {
    const char* const text = "M3\nG0 X30 Z31\nY12\nC400\nG1 F600 Y14\nM5\nG1 Y15\nM2\n";
    const auto first = decoded(text, 1);
    EXPECT_FALSE(first->approach.is_needed());
    const auto fifth = decoded(text, 5);
    EXPECT_TRUE(fifth->approach.is_spindle_on);
    EXPECT_EQ(fifth->approach.placed, 0xFU);
    EXPECT_DOUBLE_EQ(fifth->approach.place[index_of(Axis::r1)], 30.0);
    EXPECT_DOUBLE_EQ(fifth->approach.place[index_of(Axis::r2)], 31.0);
    EXPECT_DOUBLE_EQ(fifth->approach.place[index_of(Axis::y)], 12.0);
    EXPECT_DOUBLE_EQ(fifth->approach.place[index_of(Axis::psi)], 400.0);
    const auto seventh = decoded(text, 7);
    EXPECT_FALSE(seventh->approach.is_spindle_on);
    EXPECT_DOUBLE_EQ(seventh->approach.place[index_of(Axis::y)], 14.0);
}

TEST_F(Decoding, ApproachesNoSubroutineBehindTheLine) {
    const auto sut = decoded("G91\nG0 Y1\no1 call\nG0 Y2\nM2\no1 sub\nG0 Y4\no1 endsub\n", 4);
    EXPECT_DOUBLE_EQ(sut->approach.place[index_of(Axis::y)], 5.0);
}

TEST_F(Decoding, NotesEachLineOnceOfALoopThatIsReadAgain) {
    std::string text = "G91\no1 repeat [3]\nG0 Y1\n";
    while (text.size() < 200'000) text += "(" + std::string(90, 'x') + ")\n";
    text += "G0 Y-1\no1 endrepeat\nM2\nbehind\n";
    const auto sut = decoded(text);
    EXPECT_TRUE(sut->is_right());
    EXPECT_EQ(sut->facts.motion_count, 6U);
    const auto count = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
    EXPECT_EQ(sut->lines.line_count(), count);
    EXPECT_EQ(sut->facts.line_count, count - 1);
    EXPECT_EQ(sut->lines.byte_count(), text.size());
    const auto shown = read_lines(sut->request.path, sut->state, sut->lines, count - 3, 4);
    ASSERT_TRUE(shown);
    EXPECT_EQ(*shown, (std::vector<std::string>{"G0 Y-1", "o1 endrepeat", "M2", "behind"}));
}

TEST_F(Decoding, BeginsWhereTheMachineStands) {
    DecodeRequest request;
    request.path = file("G91 G0 Y5\nM2\n");
    request.start = {40.0, 41.0, 90.0, 7.0};
    DecodeProgress progress;
    const auto read = decode(request, progress);
    ASSERT_TRUE(read);
    EXPECT_DOUBLE_EQ((*read)->path.back().place[index_of(Axis::y)], 12.0);
    EXPECT_DOUBLE_EQ((*read)->path.back().place[index_of(Axis::r2)], 41.0);
    EXPECT_EQ(progress.bytes_done.load(), 13U);
}

TEST_F(Decoding, BeginsWithTheOffsetsOfItsMachine) {
    setenv("PSICARVE_STATE", folder_.path("state").c_str(), 1);
    DecodeRequest request;
    request.path = file("G0 Y5\nM2\n");
    request.segment_name = "/psicarve-decoded";
    const auto place = offsets::OffsetsPlace::of(request.segment_name, false);
    ASSERT_TRUE(offsets::OffsetsLock::take(place, std::chrono::milliseconds{0}));
    offsets::Offsets kept;
    kept.kept.systems[0].origin[1] = 3.0;
    ASSERT_TRUE(offsets::write_offsets(place, kept, {}));
    const auto y_mm = [&request] {
        DecodeProgress progress;
        const auto read = decode(request, progress);
        EXPECT_TRUE(read);
        return read ? (*read)->path.back().place[index_of(Axis::y)] : -1.0;
    };
    EXPECT_DOUBLE_EQ(y_mm(), 8.0);
    EXPECT_EQ(*offsets_for(request), kept.kept);
    request.is_simulator = true;
    EXPECT_DOUBLE_EQ(y_mm(), 5.0);
    request.is_simulator = false;
    std::ofstream{place.path} << "junk";
    DecodeProgress progress;
    EXPECT_FALSE(decode(request, progress));
    setenv("PSICARVE_STATE", "", 1);
}

TEST_F(Decoding, EndsWhenItIsCancelledAndSaysSo) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += "G0 Y" + std::to_string(i % 50) + "\n";
    DecodeRequest request;
    request.path = file(text + "M2\n");
    DecodeProgress progress;
    progress.is_cancelled.store(true);
    const auto read = decode(request, progress);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::cancelled);
    EXPECT_EQ(progress.bytes_done.load(), 0U);
}

TEST_F(Decoding, OfADeskWaitsForNobodyAndGivesUpWhatIsCancelled) {
    std::atomic<bool> has_begun{false};
    std::atomic<bool> was_cancelled{false};
    Decoder sut{[&](const DecodeRequest&, DecodeProgress& progress) -> Result<DecodedPointer> {
        has_begun.store(true);
        progress.bytes_total.store(8);
        progress.bytes_done.store(2);
        while (!progress.is_cancelled.load()) std::this_thread::yield();
        was_cancelled.store(true);
        return Error{ErrorCode::cancelled, "cancelled"};
    }};
    sut.begin({});
    while (!has_begun.load()) std::this_thread::yield();
    EXPECT_TRUE(sut.is_under_way());
    EXPECT_FALSE(sut.take());
    sut.cancel();
    std::optional<Result<DecodedPointer>> outcome;
    while (!(outcome = sut.take())) std::this_thread::yield();
    EXPECT_TRUE(was_cancelled.load());
    EXPECT_FALSE(sut.is_under_way());
}

TEST_F(Decoding, OfAFileThatIsNotThereSaysSo) {
    DecodeProgress progress;
    DecodeRequest request;
    request.path = folder_.path("none.ngc");
    const auto read = decode(request, progress);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("none.ngc"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::program
