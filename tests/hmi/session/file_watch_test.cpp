// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_watch.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

class Watch : public ::testing::Test {
protected:
    void write(const std::string& content) const { std::ofstream{path_} << content; }
    /// A look that is over.
    void look() {
        now_ += std::chrono::seconds{2};
        sut_.poll(now_);
        for (int i = 0; i < 1000; ++i) {
            sut_.poll(now_);
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
            if (sut_.has_changed() || i > 50) return;
        }
    }

    const psicarve::test::TemporaryFolder folder_;
    const std::string path_ = folder_.path("model.stl");
    FileWatch sut_;
    FileWatch::Clock::time_point now_{};
};

TEST_F(Watch, NoticesAFileThatWasWrittenSinceItWasOpened) {
    write("solid");
    sut_.watch(path_, FileWatch::stamp_of(path_));
    look();
    EXPECT_FALSE(sut_.has_changed());
    write("solid and more");
    look();
    EXPECT_TRUE(sut_.has_changed());
    sut_.watch(path_, FileWatch::stamp_of(path_));
    EXPECT_FALSE(sut_.has_changed());
    look();
    EXPECT_FALSE(sut_.has_changed()) << "opened anew";
}

TEST_F(Watch, LeavesAFileAloneThatIsGone) {
    write("solid");
    sut_.watch(path_, FileWatch::stamp_of(path_));
    std::filesystem::remove(path_);
    look();
    EXPECT_FALSE(sut_.has_changed());
    EXPECT_FALSE(FileWatch::stamp_of(path_));
    sut_.watch(path_, std::nullopt);
    write("another");
    look();
    EXPECT_FALSE(sut_.has_changed()) << "nothing is watched";
}

}  // namespace
}  // namespace psicarve::session
