// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_saver.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

class FileSaverOnOpenFiles : public ::testing::Test {
protected:
    FileSaverOnOpenFiles() {
        std::ofstream(folder_.path("m.stl")) << "model";
        std::filesystem::create_symlink("m.stl", folder_.path("link"));
        std::filesystem::create_hard_link(folder_.path("m.stl"), folder_.path("hard"));
    }
    /// What is told of saving under this name.
    std::string saved_as(const std::string& name) {
        MessageLog log;
        {
            FileSaver sut{"/none", "", log};
            sut.set_files_in_use([this] { return std::vector<std::string>{folder_.path("m.stl"), ""}; });
            sut.save_text(folder_.path(name), "report");
        }
        return log.messages().empty() ? "" : in_english(log.messages().back().what);
    }
    std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(folder_.path(name)).rdbuf();
        return text.str();
    }
    test::TemporaryFolder folder_;
};

TEST_F(FileSaverOnOpenFiles, SavesOverNoneOfThem) {
    for (const char* name : {"m.stl", "./m.stl", "link", "hard"}) {
        EXPECT_EQ(saved_as(name), "Not saved: " + folder_.path(name) +
                                      " is open here, and would be lost; choose another name");
        EXPECT_EQ(text_of("m.stl"), "model") << name;
    }
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.path("link")));
}

TEST_F(FileSaverOnOpenFiles, SavesBesideThem) {
    EXPECT_EQ(saved_as("report"), "Saved: " + folder_.path("report"));
    EXPECT_EQ(text_of("report"), "report");
}

TEST_F(FileSaverOnOpenFiles, TellsOfNamesThatSteerATerminalInLettersAlone) {
    EXPECT_EQ(saved_as("\033[2Jx"), "Saved: " + folder_.path("\\u001b[2Jx"));
}

std::shared_ptr<const cam::PreparedJob> one_layer() {
    const Profile profile;
    JobTable table;
    table.layer_count = 1;
    table.point_count = 5;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = Joining::continuous;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    table.layer_height_pulses = {400};
    table.r_left_pulses.assign(5, 4000);
    table.r_right_pulses.assign(5, 8000);
    auto job = cam::prepare_blob(job_blob_from_table(table), profile, "one layer");
    EXPECT_TRUE(job);
    return std::make_shared<const cam::PreparedJob>(std::move(*job));
}

class FileSaverOnTables : public ::testing::Test {
protected:
    std::string saved_as(const std::string& name) {
        MessageLog log;
        {
            FileSaver sut{"/none", "", log};
            sut.save_tables(folder_.path(name), one_layer());
        }
        return log.messages().empty() ? "" : in_english(log.messages().back().what);
    }
    std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(folder_.path(name)).rdbuf();
        return text.str();
    }
    test::TemporaryFolder folder_;
};

TEST_F(FileSaverOnTables, ReplacesAFileKeepsItsModeAndTouchesNoOther) {
    std::ofstream(folder_.path("t.csv")) << "old";
    ASSERT_EQ(::chmod(folder_.path("t.csv").c_str(), 0604), 0);
    std::ofstream(folder_.path("t.csv.part")) << "the user's own";

    EXPECT_EQ(saved_as("t.csv"), "Saved: " + folder_.path("t.csv"));

    EXPECT_EQ(text_of("t.csv").substr(0, 12), "layer,point,");
    EXPECT_EQ(text_of("t.csv.part"), "the user's own");
    EXPECT_EQ(folder_.file_count(), 2U);
    struct stat facts {};
    ASSERT_EQ(::stat(folder_.path("t.csv").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0604U);
    EXPECT_EQ(saved_as("t.json"), "Saved: " + folder_.path("t.json"));
    EXPECT_EQ(text_of("t.json").front(), '{');
}

TEST_F(FileSaverOnTables, ReplacesNoPipeDeviceOrFolder) {
    ASSERT_EQ(::mkfifo(folder_.path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(saved_as("pipe"),
              "Not saved: " + folder_.path("pipe") + ": is no regular file: choose a file name");
    EXPECT_TRUE(std::filesystem::is_fifo(folder_.path("pipe")));
    std::filesystem::create_directory(folder_.path("folder"));
    EXPECT_EQ(saved_as("folder"), "Not saved: " + folder_.path("folder") + ": is a folder, not a file");
    EXPECT_EQ(folder_.file_count(), 2U);
}

}  // namespace
}  // namespace psicarve::session
