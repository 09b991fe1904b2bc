// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/snapshot_compare.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "hmi/report/snapshot_differences.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

std::string english(const std::string& what) {
    return in_english(difference_phrase(what));
}

template <typename Condition>
void wait_for(SnapshotCompare& sut, Condition condition) {
    while (!condition()) {
        sut.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
}

TEST(SnapshotCompare, NamesADifferenceInWordsThatCanBeTranslated) {
    EXPECT_EQ(english("layers"), "layers");
    EXPECT_EQ(english("source"), "model");
    EXPECT_EQ(english("profile axis.r1.speed_mm_s"), "profile: axis.r1.speed_mm_s");
    EXPECT_EQ(english("status job_generation"), "status: job_generation");
    EXPECT_EQ(english("r_left_pulses (12 points differ, the first of layer 3, point 45)"),
              "radii of R1: 12 points differ, the first in layer 3, point 45, counted from 0");
    EXPECT_EQ(english("y_pulses (1 layers differ, the first of layer 7)"),
              "heights: 1 layers differ, the first is layer 7, counted from 0");
    EXPECT_EQ(english("something new"), "something new");
}

TEST(SnapshotCompare, HoldsTwoFilesAgainstEachOther) {
    const psicarve::test::TemporaryFolder folder;
    Snapshot a;
    a.status = CoreStatus{};
    Snapshot b;
    b.status = CoreStatus{};
    b.status->override_percent = 90;
    ASSERT_TRUE(save_snapshot(a, folder.path("a.snap")));
    ASSERT_TRUE(save_snapshot(b, folder.path("b.snap")));
    MessageLog log;
    SnapshotCompare sut{log};
    sut.compare(folder.path("a.snap"), folder.path("b.snap"));
    EXPECT_TRUE(sut.is_comparing());
    wait_for(sut, [&] { return !sut.is_comparing(); });
    const auto found = sut.take();
    ASSERT_TRUE(found);
    ASSERT_EQ(found->rows.size(), 1U);
    EXPECT_EQ(in_english(found->rows[0].what), "status: override_percent");
    EXPECT_EQ(in_english(found->rows[0].a), "0");
    EXPECT_EQ(in_english(found->rows[0].b), "90");
    EXPECT_FALSE(sut.take()) << "once";
    sut.compare(folder.path("a.snap"), folder.path("a.snap"));
    wait_for(sut, [&] { return !sut.is_comparing(); });
    EXPECT_TRUE(sut.take()->rows.empty());
}

TEST(SnapshotCompare, SaysWhyAFileCannotBeCompared) {
    const psicarve::test::TemporaryFolder folder;
    MessageLog log;
    SnapshotCompare sut{log};
    sut.compare(folder.path("none.snap"), folder.path("none.snap"));
    wait_for(sut, [&] { return !sut.is_comparing(); });
    EXPECT_FALSE(sut.take());
    EXPECT_TRUE(in_english(log.messages().back().what).starts_with("Compare: "));
}

}  // namespace
}  // namespace psicarve::session
