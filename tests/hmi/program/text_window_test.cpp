// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/text_window.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::program {
namespace {

class ProgramText : public ::testing::Test {
protected:
    void open(int lines) {
        std::ofstream out{path_};
        for (int i = 1; i < lines; ++i) out << "(" << i << ")\n";
        out << "M2\n";
        out.close();
        DecodeProgress progress;
        DecodeRequest request;
        request.path = path_;
        const auto read = decode(request, progress);
        ASSERT_TRUE(read);
        sut.show(*read);
    }
    void await() {
        while (!sut.poll()) std::this_thread::yield();
    }
    test::TemporaryFolder folder_;
    std::string path_ = folder_.path("a.ngc");
    TextWindow sut;
};

TEST_F(ProgramText, ReadsTheLinesThatAreLookedAt) {
    open(20'000);
    sut.want(1, 30);
    EXPECT_EQ(sut.line(1), nullptr) << "nobody waits for a disk";
    await();
    ASSERT_NE(sut.line(30), nullptr);
    EXPECT_EQ(*sut.line(30), "(30)");
    EXPECT_EQ(sut.line(15'000), nullptr);
    sut.want(15'000, 30);
    await();
    EXPECT_EQ(*sut.line(15'000), "(15000)");
    EXPECT_EQ(sut.line(1), nullptr) << "and keeps no others";
    sut.want(19'990, 30);
    await();
    EXPECT_EQ(*sut.line(20'000), "M2");
    EXPECT_EQ(sut.line(20'001), nullptr);
    sut.want(19'980, 30);
    EXPECT_FALSE(sut.poll()) << "it has these";
}

TEST_F(ProgramText, SaysThatTheFileIsAnother) {
    open(2000);
    std::ofstream{path_} << "M2\n";
    sut.want(1000, 10);
    await();
    EXPECT_TRUE(sut.failure().has_value());
    EXPECT_EQ(sut.line(1000), nullptr);
}

}  // namespace
}  // namespace psicarve::program
