// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_desk.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

class FileDeskOnOpenFiles : public ::testing::Test {
protected:
    FileDeskOnOpenFiles() {
        std::ofstream(folder_.path("m.stl")) << "model";
        std::filesystem::create_symlink("m.stl", folder_.path("link"));
        std::filesystem::create_hard_link(folder_.path("m.stl"), folder_.path("hard"));
    }
    /// What is told of saving under this name.
    std::string saved_as(const std::string& name) {
        MessageLog log;
        {
            FileDesk sut{"/none", "", log};
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

TEST_F(FileDeskOnOpenFiles, SavesOverNoneOfThem) {
    for (const char* name : {"m.stl", "./m.stl", "link", "hard"}) {
        EXPECT_EQ(saved_as(name), "Not saved: " + folder_.path(name) +
                                      " is open here, and would be lost; choose another name");
        EXPECT_EQ(text_of("m.stl"), "model") << name;
    }
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.path("link")));
}

TEST_F(FileDeskOnOpenFiles, SavesBesideThem) {
    EXPECT_EQ(saved_as("report"), "Saved: " + folder_.path("report"));
    EXPECT_EQ(text_of("report"), "report");
}

TEST_F(FileDeskOnOpenFiles, TellsOfNamesThatSteerATerminalInLettersAlone) {
    EXPECT_EQ(saved_as("\033[2Jx"), "Saved: " + folder_.path("\\u001b[2Jx"));
}

}  // namespace
}  // namespace psicarve::session
