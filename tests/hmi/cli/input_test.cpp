// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <functional>

#include "tests/hmi/cli/refusal.hpp"
#include "tests/hmi/model/three_mf_files.hpp"

namespace psicarve::test {
namespace {

struct BrokenFile {
    const char* name;
    std::function<std::string()> bytes;
};

/// A binary STL that promises `count` facets and holds `held`, all of them the same but for a shift.
std::string binary_stl(std::uint32_t count, std::uint32_t held, float first = 0.0F) {
    std::string bytes(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    for (std::uint32_t i = 0; i < held; ++i) {
        std::array<float, 12> facet{0, 0, 0, first, 0, 0, 1, 0, float(i), 0, 1, 0};
        bytes.append(reinterpret_cast<const char*>(facet.data()), sizeof facet);
        bytes.append(2, '\0');
    }
    return bytes;
}

const std::vector<BrokenFile>& broken_models() {
    static const std::vector<BrokenFile> files{
        {"empty.stl", [] { return std::string{}; }},
        {"words.stl", [] { return std::string{"this is a letter to my aunt, not a mesh\n"}; }},
        {"truncated.stl", [] { return binary_stl(1000, 10); }},
        {"nan.stl", [] { return binary_stl(50, 50, std::numeric_limits<float>::quiet_NaN()); }},
        {"infinite.stl", [] { return binary_stl(50, 50, std::numeric_limits<float>::infinity()); }},
        {"no_facets.stl", [] { return std::string{"solid nothing\nendsolid nothing\n"}; }},
        {"flat.stl", [] { return binary_stl(1, 1); }},
        {"garbage.obj", [] { return std::string{"\x01\x02\x03 v v v f f f\n"}; }},
        {"unknown.xyz", [] { return std::string{"1 2 3\n4 5 6\n"}; }},
        {"picture.gif", [] { return std::string{"GIF89a and more"}; }},
        {"no_zip.3mf", [] { return std::string{"no archive at all\n"}; }},
        {"no_model.3mf", [] { return mesh_files::three_mf_surroundings().bytes(); }},
        {"cut.3mf", [] { return mesh_files::three_mf_archive("<model><build>").bytes(); }},
        {"entities.3mf",
         [] {
             return mesh_files::three_mf_archive(
                        "<!DOCTYPE m [<!ENTITY a \"bb\"><!ENTITY b \"&a;&a;\">]><m>&b;</m>")
                 .bytes();
         }},
    };
    return files;
}

class BrokenInput : public RefusalTest {
protected:
    std::vector<std::vector<std::string>> commands_that_read(const std::string& path) const {
        return {{"slice", path, "-o", file("out.job")},
                {"carve", path, "--segment", segment_},
                {"publish", path, "--segment", segment_},
                {"replay", path},
                {"verify", path, path},
                {"snapshot", "info", path},
                {"snapshot", "export", path},
                {"snapshot", "diff", path, path},
                {"profile", "check", path},
                {"profile", "show", path},
                {"status", "--segment", segment_, "--profile", path}};
    }
};

TEST_F(BrokenInput, ModelsAreRefusedBySlice) {
    for (const BrokenFile& model : broken_models()) {
        write(model.name, model.bytes());
        expect_refused({"slice", file(model.name), "-o", file("out.job")}, model.name);
    }
}

TEST_F(BrokenInput, WhatIsNotReadIsSaidBeforeWhatItsOptionsAreFor) {
    write("a.gif", "GIF89a and more");
    write("a.foo", "what is this");
    for (const std::string option : {"--diameter 20", "--relief", "--engrave 1", "--full-turn"}) {
        for (const std::string name : {"a.gif", "a.foo"}) {
            std::vector<std::string> arguments{"slice", file(name), "-o", file("out.job")};
            for (const std::string& word : words_of(option)) arguments.push_back(word);
            const Outcome outcome = psicarve(arguments);
            EXPECT_EQ(outcome.exit_code, 3) << option;
            EXPECT_NE(outcome.error.find(name == "a.gif" ? "a GIF picture, which is not read; save it as PNG"
                                                         : "nothing that can be read here: a mesh"),
                      std::string::npos)
                << outcome.error;
        }
    }
    // A mesh is still told what they are for.
    const Outcome mesh = psicarve({"slice", box_stl("box.stl"), "-o", file("out.job"), "--relief"});
    EXPECT_EQ(mesh.exit_code, 2);
    EXPECT_NE(mesh.error.find("are for pictures"), std::string::npos) << mesh.error;
}

TEST_F(BrokenInput, ModelsAreRefusedByCarveAndPublishBeforeAnythingIsMade) {
    for (const BrokenFile& model : broken_models()) {
        write(model.name, model.bytes());
        expect_refused({"carve", file(model.name), "--segment", segment_, "--picture", file("out.png"),
                        "--trace", file("out.vcd")},
                       model.name);
        expect_refused({"publish", file(model.name), "--segment", segment_}, model.name);
    }
    EXPECT_FALSE(Segment::attach(segment_).has_value());
}

TEST_F(BrokenInput, MissingFilesAreRefusedByEveryCommandThatReads) {
    for (const auto& command : commands_that_read(file("gone"))) expect_refused(command, "gone");
}

// Opening a pipe waits for a writer: a wrong name must not make a command hang.
TEST_F(BrokenInput, PipesAndFoldersAreRefusedByEveryCommandThatReads) {
    ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
    std::filesystem::create_directory(file("folder"));
    for (const std::string name : {"pipe", "folder"}) {
        for (const auto& command : commands_that_read(file(name))) expect_refused(command, name);
        const Outcome core =
            RunningProgram{"psicarve-rtcore", {"--segment", segment_, "--profile", file(name)}}.outcome();
        EXPECT_EQ(core.exit_code, 3) << core.error;
        EXPECT_NE(core.error.find(name), std::string::npos) << core.error;
    }
}

TEST_F(BrokenInput, AModelThatIsTooTallNamesTheAxis) {
    const Outcome outcome = psicarve({"slice", box_stl("tall.stl", 400.0), "-o", file("out.job")});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.error.find("axis y"), std::string::npos) << outcome.error;
    EXPECT_EQ(files_in_folder(), std::vector<std::string>{"tall.stl"});
}

TEST_F(BrokenInput, DamagedJobsAreRefusedByName) {
    const std::string job = file("box.job");
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", job, "--layers", "3", "--points", "5"}).exit_code,
              0);
    const std::string whole = text_of(job);
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
    std::string other_version = whole;
    other_version[8] = static_cast<char>(other_version[8] + 1);
    const std::vector<std::pair<const char*, std::string>> damaged{
        {"cut.job", whole.substr(0, whole.size() - 1)},
        {"head.job", whole.substr(0, 100)},
        {"longer.job", whole + "x"},
        {"flipped.job", flipped},
        {"version.job", other_version}};
    for (const auto& [name, bytes] : damaged) {
        write(name, bytes);
        expect_refused({"snapshot", "info", file(name)}, name);
        expect_refused({"snapshot", "export", file(name)}, name);
        expect_refused({"publish", file(name), "--segment", segment_}, name);
        expect_refused({"replay", file(name), "--trace", file("out.vcd")}, name);
        expect_refused({"carve", file(name), "--segment", segment_, "--picture", file("out.png")}, name);
    }
}

TEST_F(BrokenInput, TracesThatAreNoneAreRefused) {
    const std::string job = file("box.job");
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", job, "--layers", "3", "--points", "5"}).exit_code,
              0);
    write("words.vcd", "this is no trace\n");
    write("cut.bin", "PSCATRC1");
    expect_refused({"verify", job, file("words.vcd")}, "words.vcd");
    expect_refused({"verify", job, file("cut.bin")}, "cut.bin");
}

TEST_F(BrokenInput, ASegmentOfGarbageIsRefusedByName) {
    const std::string path = "/dev/shm" + segment_;
    std::ofstream{path} << std::string(100'000, 'x');
    std::filesystem::permissions(path, std::filesystem::perms{0600});
    for (const std::string command : {"status", "home", "stop", "publish", "carve"}) {
        std::vector<std::string> arguments{command, "--segment", segment_};
        if (command == "publish" || command == "carve") arguments.push_back(box_stl("box.stl"));
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 3) << command << ": " << outcome.error;
        EXPECT_NE(outcome.error.find(segment_), std::string::npos) << outcome.error;
    }
}

TEST_F(BrokenInput, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork) {
    const std::string model = box_stl("box.stl");
    const std::string nowhere = file("no/such/folder/out");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"slice", model, "-o", nowhere},
          {"carve", model, "--segment", segment_, "--picture", nowhere + ".png"},
          {"carve", model, "--segment", segment_, "--trace", nowhere}}) {
        expect_refused(arguments, nowhere);
    }
    EXPECT_FALSE(Segment::attach(segment_).has_value());
}

TEST_F(BrokenInput, OptionsForModelsDoNotGoWithJobs) {
    const std::string job = file("box.job");
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", job, "--layers", "3", "--points", "5"}).exit_code,
              0);
    EXPECT_EQ(psicarve({"carve", job, "--layers", "5", "--segment", segment_}).exit_code, 2);
    EXPECT_EQ(psicarve({"slice", job, "-o", file("again.job")}).exit_code, 3);
}

}  // namespace
}  // namespace psicarve::test
