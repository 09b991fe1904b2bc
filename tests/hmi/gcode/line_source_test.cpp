// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

std::vector<std::string> lines_in(const std::string& text, std::size_t piece_bytes) {
    LineSource sut{bytes_of(text, piece_bytes)};
    std::vector<std::string> lines;
    std::string_view line;
    for (auto more = sut.next(line); more && *more; more = sut.next(line)) {
        lines.emplace_back(line);
        EXPECT_EQ(sut.number(), lines.size());
    }
    return lines;
}

TEST(LineSource, GivesTheSameLinesHoweverTheBytesCome) {
    const std::string text = "G0 X1\n\n\nG1 X22\r\nM2";
    const std::vector<std::string> expected{"G0 X1", "", "", "G1 X22\r", "M2"};
    for (std::size_t bytes = 1; bytes <= text.size(); ++bytes)
        EXPECT_EQ(lines_in(text, bytes), expected) << bytes;
}

TEST(LineSource, HasNoLineAfterTheLastLineFeed) {
    EXPECT_EQ(lines_in("a\n", 10), std::vector<std::string>{"a"});
    EXPECT_TRUE(lines_in("", 10).empty());
}

TEST(LineSource, CutsALineWithoutEnd) {
    const std::string text = std::string(1'000'000, 'x') + "\nM2\n";
    for (const std::size_t bytes : {std::size_t{777}, std::size_t{1} << 20U}) {
        const auto lines = lines_in(text, bytes);
        ASSERT_EQ(lines.size(), 2U);
        EXPECT_EQ(lines[0].size(), kMostLineBytes + 1);
        EXPECT_EQ(lines[1], "M2");
    }
}

TEST(LineSource, PassesAnErrorOn) {
    LineSource sut{[](std::span<char>) -> Result<std::size_t> { return bad_input("broken"); }};
    std::string_view line;
    EXPECT_EQ(sut.next(line).error().message, "broken");
}

TEST(OpenProgram, RefusesWhatIsNoFile) {
    EXPECT_NE(open_program("/nowhere/a.ngc").error().message.find("/nowhere/a.ngc"), std::string::npos);
    EXPECT_NE(open_program("/").error().message.find("folder"), std::string::npos);
}

TEST(LineSource, GivesUpOnALineWithoutEnd) {
    LineSource lines{ByteSource{[](std::span<char> room) -> Result<std::size_t> {
        std::fill(room.begin(), room.end(), '\0');
        return room.size();
    }}};
    std::string_view line;
    EXPECT_FALSE(lines.next(line).has_value());
}

}  // namespace
}  // namespace psicarve::gcode
