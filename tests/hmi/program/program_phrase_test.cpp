// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/program_phrase.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <span>
#include <string>

#include "hmi/offsets/offsets_lock.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "tests/hmi/gcode/made_records.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::program {
namespace {

std::string in_the_window(const std::string& message) {
    const session::Phrase shown = session::error_phrase(message);
    EXPECT_STRNE(shown.english, "%1") << "has no words of the window's own: " << message;
    return in_english(shown);
}

// What the readers say, as they say it.
TEST(ProgramPhrase, KnowsWhyAFileIsNoProgram) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(in_the_window(gcode::state_of_program(folder.path("")).error().message),
              folder.path("") + ": is a folder; choose a program");
    const std::string pipe = folder.path("pipe.ngc");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(in_the_window(gcode::state_of_program(pipe).error().message),
              pipe + ": is no regular file, and is read twice");
    (void)in_the_window(gcode::state_of_program(folder.path("none.ngc")).error().message);

    const std::string path = folder.path("part.ngc");
    std::ofstream{path} << "G0 X1\nM2\n";
    const auto before = gcode::state_of_program(path);
    ASSERT_TRUE(before);
    auto opened = gcode::open_unchanged_program(path, *before);
    ASSERT_TRUE(opened);
    std::ofstream{path, std::ios::app} << "more\n";
    std::string room(64, '\0');
    const auto read = opened->read(room);
    ASSERT_FALSE(read);
    (void)in_the_window(read.error().message);

    // The endless bytes of a device.
    gcode::LineSource endless{gcode::ProgramBytes{[](std::span<char> bytes) -> Result<std::size_t> {
                                                      std::ranges::fill(bytes, 'x');
                                                      return bytes.size();
                                                  },
                                                  {}}};
    std::string_view line;
    const auto got = endless.next(line);
    ASSERT_FALSE(got);
    EXPECT_EQ(in_the_window(got.error().message),
              "line 1 has more than 64 MiB: this is no program in G-code");
}

TEST(ProgramPhrase, KnowsWhyARunEndsBeforeItsProgram) {
    gcode::RunOptions how;
    how.from_line = 12;
    (void)in_the_window(gcode::made_records("G0 X1\nM2\n", how).failure);
    const std::string unknown =
        gcode::made_records("G21 G91 F300\nG1 X1\nM2\n", {}, Profile{}, false).failure;
    EXPECT_EQ(in_the_window(unknown), "line 2: it is not known where X begins");
}

TEST(ProgramPhrase, KnowsWhoHasTheWorkOffsets) {
    const test::TemporaryFolder folder;
    offsets::OffsetsPlace place;
    place.path = folder.path("offsets.json");
    const auto first = offsets::OffsetsLock::take(place, std::chrono::milliseconds{0});
    ASSERT_TRUE(first);
    const auto second = offsets::OffsetsLock::take(place, std::chrono::milliseconds{0});
    ASSERT_FALSE(second);
    (void)in_the_window(second.error().message);
}

}  // namespace
}  // namespace psicarve::program
