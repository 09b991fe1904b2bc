// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

class StandardInput : public CliTest {
protected:
    /// The program on what the shell puts before and behind it; what it says goes to "err".
    int shell(const std::string& before, const std::string& arguments, const std::string& behind) const {
        const std::string line = before + in_build("bin/psicarve") + " " + arguments + " " + behind + " 2>" +
                                 file("err") + " >" + file("out");
        return WEXITSTATUS(std::system(line.c_str()));
    }
    std::string said() const { return text_of(file("err")); }
    std::ptrdiff_t lines() const {
        const std::string text = said();
        return std::count(text.begin(), text.end(), '\n');
    }
};

TEST_F(StandardInput, IsNotReadWithoutEnd) {
    // Twice of what is taken, so that a program without an end is killed instead of filling the memory.
    EXPECT_EQ(shell("ulimit -f 4194304; ", "inspect -", "</dev/zero"), 3);
    EXPECT_EQ(lines(), 1) << said();
    EXPECT_NE(said().find("psicarve: standard input: more than 1 GiB"), std::string::npos) << said();
}

TEST_F(StandardInput, IsNotReadBeforeTheRestIsKnownToBeRight) {
    // What keeps the pipe open ends with it: a program that waits for it is found by what it leaves there.
    write("left.txt", "first\nsecond\n");
    for (const char* arguments : {"slice - --help", "slice - --no-such-option", "snapshot info - --help"}) {
        const int code = shell("{ ", arguments, "; cat >" + file("rest.txt") + "; } <" + file("left.txt"));
        EXPECT_EQ(code, 0) << said();
        EXPECT_EQ(text_of(file("rest.txt")), "first\nsecond\n") << arguments << " has read";
    }
}

TEST_F(StandardInput, IsNotLostToWhatIsWritten) {
    const std::string model = box_stl("m.stl");
    const std::string text = text_of(model);
    std::filesystem::create_symlink("m.stl", file("link.stl"));
    for (const char* name : {"m.stl", "link.stl"}) {
        EXPECT_EQ(shell("", "slice - --layers 3 --points 5 -o " + file(name), "<" + model), 2) << name;
        EXPECT_EQ(lines(), 1) << said();
        EXPECT_NE(said().find("MODEL standard input are one file"), std::string::npos) << said();
        EXPECT_TRUE(text_of(model) == text) << name;
    }
    EXPECT_EQ(shell("cat " + model + " | ", "slice - --layers 3 --points 5 -o " + file("m.job"), ""), 0)
        << said();
    EXPECT_EQ(shell("", "slice - --layers 3 --points 5 -o " + file("n.job"), "<" + model), 0) << said();
}

TEST_F(StandardInput, MayBeATableWithItsHead) {
    ASSERT_EQ(psicarve({"slice", box_stl("m.stl"), "--layers", "3", "--points", "6", "-o", file("m.job")})
                  .exit_code,
              0);
    ASSERT_EQ(shell("", "snapshot export " + file("m.job") + " --format csv", ""), 0) << said();
    const std::string table = text_of(file("out"));
    write("m.csv", table);
    EXPECT_EQ(shell("cat " + file("m.csv") + " | ", "slice - -o " + file("table.job"), ""), 0) << said();
    ASSERT_EQ(shell("", "snapshot export " + file("table.job") + " --format csv", ""), 0) << said();
    EXPECT_EQ(text_of(file("out")), table);
}

}  // namespace
}  // namespace psicarve::test
