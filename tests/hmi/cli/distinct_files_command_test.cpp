// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

/// What would be lost is still there, to the last byte.
class DistinctFilesOfACommand : public CliTest {
protected:
    DistinctFilesOfACommand() {
        std::filesystem::copy_file(example("small.stl"), file("m.stl"));
        const Outcome made =
            run({"slice", file("m.stl"), "-o", file("j.job"), "--layers", "4", "--points", "8"});
        EXPECT_EQ(made.exit_code, 0) << made.error;
        write("p.toml", psicarve({"profile", "show"}).out);
        write("t.vcd", "$end\n");
        write("b.png", "no picture yet");
        std::filesystem::create_symlink("m.stl", file("link"));
        std::filesystem::create_hard_link(file("m.stl"), file("hard"));
    }
    std::map<std::string, std::string> texts() const {
        std::map<std::string, std::string> all;
        for (const std::string& name : files_in_folder()) all[name] = text_of(file(name));
        return all;
    }
    void expect_refused(const std::vector<std::string>& arguments, const std::string& one,
                        const std::string& other) const {
        const auto before = texts();
        const Outcome outcome = run(arguments);
        const std::string all = testing::PrintToString(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << all << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_EQ(outcome.out, "") << all;
        EXPECT_NE(outcome.error.find(one + " /"), std::string::npos) << outcome.error;
        EXPECT_NE(outcome.error.find(" and " + other + " /"), std::string::npos) << outcome.error;
        EXPECT_NE(outcome.error.find("are one file"), std::string::npos) << outcome.error;
        EXPECT_TRUE(texts() == before) << all << " has changed a file";
    }
};

TEST_F(DistinctFilesOfACommand, AreHeldToBySlice) {
    for (const char* name : {"m.stl", "./m.stl", "link", "hard"})
        expect_refused({"slice", file("m.stl"), "-o", file(name)}, "--output", "MODEL");
    expect_refused({"slice", file("link"), "-o", file("m.stl")}, "--output", "MODEL");
    expect_refused({"slice", file("m.stl"), "-o", file("p.toml"), "--profile", file("p.toml")}, "--output",
                   "--profile");
    expect_refused({"--profile", file("p.toml"), "slice", file("m.stl"), "-o", file("p.toml")}, "--output",
                   "--profile");
    expect_refused({"slice", file("m.stl"), "-o", file("n.png"), "--preview", file("n.png")}, "--output",
                   "--preview");
}

TEST_F(DistinctFilesOfACommand, AreHeldToByAllThatWriteOfAJob) {
    expect_refused({"replay", file("j.job"), "--trace", file("j.job")}, "--trace", "JOB|TRACE");
    expect_refused({"replay", file("j.job"), "--program", file("m.stl"), "--trace", file("m.stl")}, "--trace",
                   "--program");
    expect_refused({"carve", file("m.stl"), "--trace", file("m.stl")}, "--trace", "MODEL|JOB");
    expect_refused({"gcode", "run", file("m.stl"), "--trace", file("m.stl")}, "--trace", "FILE");
    std::filesystem::copy_file(file("m.stl"), file("m.offsets"));
    expect_refused({"gcode", "run", file("m.offsets"), "--trace", file("m")}, "--trace (its offsets)",
                   "FILE");
    expect_refused({"carve", file("m.stl"), "--piece", file("hard")}, "--piece", "MODEL|JOB");
    expect_refused({"carve", file("j.job"), "--model", file("m.stl"), "--piece", file("m.stl")}, "--piece",
                   "--model");
    expect_refused({"carve", file("m.stl"), "--trace", file("b.png"), "--picture", file("b.png")},
                   "--picture", "--trace");
    expect_refused({"carve", file("m.stl"), "--trace", file("n.png"), "--picture", file("./n.png")},
                   "--picture", "--trace");
    expect_refused({"replay", file("j.job"), "--trace", file("n.png"), "--picture", file("n.png")}, "--trace",
                   "--picture");
    expect_refused({"verify", file("j.job"), file("t.vcd"), "--piece", file("t.vcd")}, "--piece", "TRACE");
    expect_refused({"verify", file("j.job"), file("t.vcd"), "--picture", file("n.png"), "--deviation",
                    file("n.png"), "--model", file("m.stl")},
                   "--picture", "--deviation");
    std::filesystem::copy_file(file("m.stl"), file("m.png"));
    expect_refused({"inspect", file("m.png"), "--preview", file("m.png")}, "--preview", "MODEL");
}

TEST_F(DistinctFilesOfACommand, AreHeldToByAllThatKeepWhatTheMachineSays) {
    expect_refused({"snapshot", "save", file("p.toml"), "--profile", file("p.toml")}, "FILE", "--profile");
    expect_refused({"latency", "--csv", file("p.toml"), "--profile", file("p.toml")}, "--csv", "--profile");
}

TEST_F(DistinctFilesOfACommand, MayBeReadTwiceAndThrownAway) {
    EXPECT_EQ(run({"snapshot", "diff", file("j.job"), file("j.job")}).exit_code, 0);
    EXPECT_EQ(run({"replay", file("j.job"), "--profile", file("j.job"), "--trace", "/dev/null"}).exit_code,
              0);
}

TEST_F(DistinctFilesOfACommand, AreNotStandardOutputWhereThatTakesNone) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"replay", file("j.job"), "--trace", "-"},
             {"carve", file("j.job"), "--trace", "-"},
             {"carve", file("j.job"), "--picture", "-"},
             {"carve", file("m.stl"), "--deviation", "-"},
             {"verify", file("j.job"), file("t.vcd"), "--piece", "-"},
             {"inspect", file("m.stl"), "--preview", "-"},
             {"slice", file("m.stl"), "-o", file("n.job"), "--preview", "-"},
             {"latency", "--csv", "-", "--seconds", "1"},
             {"profile", "diff", file("p.toml"), "-"},
             {"profile", "show", "-"},
             {"profile", "check", "-"},
             {"status", "--profile", "-"},
             {"--profile", "-", "status"},
             {"carve", file("j.job"), "--model", "-"}}) {
        const auto before = texts();
        const Outcome outcome = run(arguments);
        const std::string all = testing::PrintToString(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << all << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << all << outcome.error;
        const bool is_named = outcome.error.find(" -: ") != std::string::npos ||
                              outcome.error.find(": '-': ") != std::string::npos;
        EXPECT_TRUE(is_named) << all << outcome.error;
        EXPECT_EQ(outcome.out, "") << all;
        EXPECT_TRUE(texts() == before) << all << " has changed a file";
    }
    EXPECT_FALSE(std::filesystem::exists("-"));
}

// Told before the work, as of any file that cannot be written.
TEST_F(DistinctFilesOfACommand, AreRefusedBeforeSlicingWhereAJobCannotStand) {
    write("broken.stl", "no mesh");
    ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
    for (const std::string& output : {std::string{"/dev/null"}, file("pipe")}) {
        const Outcome outcome = run({"slice", file("broken.stl"), "-o", output});
        EXPECT_EQ(outcome.exit_code, 3) << outcome.error;
        EXPECT_NE(outcome.error.find(output + ": is no regular file"), std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.error.find("broken.stl"), std::string::npos) << outcome.error;
    }
}

// An option for a file that the check does not know would be left out of it without a word.
TEST_F(DistinctFilesOfACommand, AreOfNoOptionThatIsNotKnown) {
    const std::set<std::string> known{"--profile", "--output",    "--trace", "--picture", "--preview",
                                      "--piece",   "--deviation", "--csv",   "--model",   "MODEL",
                                      "MODEL|JOB", "JOB|TRACE",   "JOB_A",   "JOB_B",     "FILE",
                                      "A",         "B",           "TRACE",   "--program", "--offsets"};
    const std::set<std::string> no_files{"SIGNAL", "SHELL", "--state"};
    const std::regex positional{"^  ([A-Z][A-Z_|]*)(?: REQUIRED)?(?: .*)?$"};
    const std::regex option{
        "^  (?:-[a-z],)?(--[a-z-]+) (?:[A-Za-z.]*\\.[a-z]+|FILE|JOB|MODEL|DIR|FOLDER|PATH)(?: .*)?$"};
    std::set<std::string> seen;
    for (const char* command :
         {"carve",         "slice",         "inspect",         "estimate",      "publish",
          "snapshot save", "snapshot info", "snapshot export", "snapshot diff", "replay",
          "verify",        "calibrate",     "latency",         "profile check", "profile show",
          "profile diff",  "profile set",   "profile path",    "status",        "pins",
          "completion",    "gcode check",   "gcode run",       "gcode estimate"}) {
        auto arguments = words_of(command);
        arguments.emplace_back("--help");
        std::istringstream help{run(arguments).out};
        for (std::string line; std::getline(help, line);) {
            std::smatch found;
            if (!std::regex_match(line, found, positional) && !std::regex_match(line, found, option))
                continue;
            if (no_files.contains(found[1])) continue;
            seen.insert(found[1]);
            EXPECT_TRUE(known.contains(found[1])) << command << ": " << line;
        }
    }
    EXPECT_EQ(seen, known);
}

}  // namespace
}  // namespace psicarve::test
