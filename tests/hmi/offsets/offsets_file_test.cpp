// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/offsets_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <thread>
#include <vector>

#include "hmi/offsets/offsets_lock.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::offsets {
namespace {

using std::chrono::milliseconds;

Offsets full_offsets() {
    Offsets offsets;
    offsets.kept.systems[0].origin = {10.1, -2.5, 0.0, 0.0, 1.0 / 3.0, 90.0, 1e-12, 0.0, -1e9};
    offsets.kept.systems[8].rotation_deg = 33.0;
    offsets.kept.shift[1] = 4.0;
    offsets.kept.is_shifted = true;
    offsets.kept.references[1] = gcode::Position{0.0, 5.0};
    offsets.pending = Pending{{"/psi", "0-1", 4'000'000'000U, 77, 3}, {}};
    offsets.pending->offsets.systems[3].origin[0] = 7.0;
    offsets.profile = ProfileMark{"worn", 0xfedc'ba98'7654'3210U};
    return offsets;
}

GcodeProfile turning() {
    GcodeProfile letters;
    letters.letters = AxisNames::turning;
    return letters;
}

std::string why_not(const std::string& text) {
    const auto read = offsets_from(text, {});
    return read ? "read" : read.error().message;
}

class OffsetsFiles : public testing::Test {
protected:
    OffsetsPlace place(const std::string& name = "m.offsets") const { return {folder_.path(name), 0640}; }
    void write(const std::string& text) const { std::ofstream{place().path} << text; }

    test::TemporaryFolder folder_;
};

TEST(OffsetsText, IsReadAsItWasWritten) {
    EXPECT_EQ(*offsets_from(text_of(full_offsets(), {}), {}), full_offsets());
    EXPECT_EQ(*offsets_from(text_of({}, turning()), turning()), Offsets{});
}

TEST(OffsetsText, IsRefusedWithARemedyWhereItIsBrokenOrNewer) {
    const std::string right = text_of(full_offsets(), {});
    for (std::size_t bytes = 0; bytes + 2 < right.size(); ++bytes)
        EXPECT_NE(why_not(right.substr(0, bytes)), "read") << bytes;
    const auto with = [&](const std::string& was, const std::string& is) {
        std::string text = right;
        text.replace(text.find(was), was.size(), is);
        return why_not(text);
    };
    EXPECT_NE(with("offsets\": 1", "offsets\": 2").find("newer"), std::string::npos);
    EXPECT_NE(with("offsets\": 1", "offsets\": 0").find("mend it"), std::string::npos);
    for (const std::string missing :
         {"\"X\": 10.1,", "\"W\": -1000000000.0,", "\"program\": 3,", "\"core_pid\": 4000000000,"})
        EXPECT_NE(with(missing, ""), "read") << missing;
    std::string unsure = right;
    for (const std::string word : {",\n    \"in_force\": true", ",\n      \"R\": 33.0"}) {
        ASSERT_NE(unsure.find(word), std::string::npos) << unsure;
        EXPECT_NE(with(word, "").find("lacks"), std::string::npos) << word;
    }
    EXPECT_NE(with("-2.5", "1e10").find("G54 Y"), std::string::npos);
    EXPECT_NE(with("-2.5", "\"2\"").find("G54 Y"), std::string::npos);
    EXPECT_NE(with("G59.3", "G59.4").find("G59.4"), std::string::npos);
    EXPECT_NE(with("\"R\"", "\"Q\"").find("has no Q"), std::string::npos);
    EXPECT_NE(with("in_force", "in_Force").find("in_Force"), std::string::npos);
    EXPECT_NE(with("\"g30\"", "\"g31\"").find("g31"), std::string::npos);
    EXPECT_NE(with("\"in_force\": true", "\"in_force\": 1").find("in_force"), std::string::npos);
    for (const std::string& text :
         {with("offsets\": 1", "offsets\": 2"), with("-2.5", "1e10"), why_not("[]")}) {
        EXPECT_NE(text.find("psicarve gcode offsets clear all"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

TEST(OffsetsText, IsRefusedWhereLettersMeanOtherAxes) {
    const auto read = offsets_from(text_of(full_offsets(), {}), turning());
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("turning"), std::string::npos);
    GcodeProfile follows;
    follows.second_head = SecondHead::follow;
    EXPECT_FALSE(offsets_from(text_of(full_offsets(), {}), follows));
}

TEST_F(OffsetsFiles, SayNothingWhereThereAreNone) {
    EXPECT_EQ(*read_offsets(place(), {}), Offsets{});
    EXPECT_EQ(*read_offsets({}, {}), Offsets{});
}

TEST_F(OffsetsFiles, HaveTheRightsOfTheirPlaceAndNameThemselvesInErrors) {
    ASSERT_TRUE(write_offsets(place(), full_offsets(), {}));
    EXPECT_EQ(*read_offsets(place(), {}), full_offsets());
    struct stat facts {};
    ASSERT_EQ(stat(place().path.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0640U);
    write("junk");
    const auto read = read_offsets(place(), {});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message.find(place().path + ": "), 0U);
}

TEST_F(OffsetsFiles, LoseNoChangeOfTwoThatWriteAtOnce) {
    const OffsetsPlace at = place("a/b/m.offsets");
    std::vector<std::thread> writers;
    for (int writer = 0; writer < 2; ++writer) {
        writers.emplace_back([&at] {
            for (int n = 0; n < 100; ++n) {
                const auto lock = OffsetsLock::take(at, milliseconds{60'000});
                ASSERT_TRUE(lock);
                Offsets offsets = *read_offsets(at, {});
                offsets.kept.systems[0].origin[0] += 1.0;
                ASSERT_TRUE(write_offsets(at, offsets, {}));
            }
        });
    }
    for (std::thread& writer : writers) writer.join();
    EXPECT_EQ(read_offsets(at, {})->kept.systems[0].origin[0], 200.0);
}

TEST_F(OffsetsFiles, AreOneProcessesAtATime) {
    {
        const auto first = OffsetsLock::take(place(), milliseconds{0});
        ASSERT_TRUE(first);
        const auto second = OffsetsLock::take(place(), milliseconds{20});
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().code, ErrorCode::machine_refused);
    }
    EXPECT_TRUE(OffsetsLock::take(place(), milliseconds{0}));
}

TEST_F(OffsetsFiles, AreNotWrittenWhereTheyWouldNotBeRead) {
    Offsets offsets = full_offsets();
    ASSERT_TRUE(write_offsets(place(), offsets, {}));
    offsets.kept.shift[3] = 1.1e9;
    EXPECT_FALSE(write_offsets(place(), offsets, {}));
    offsets.kept.shift[3] = std::nan("");
    EXPECT_FALSE(write_offsets(place(), offsets, {}));
    EXPECT_EQ(*read_offsets(place(), {}), full_offsets());
}

}  // namespace
}  // namespace psicarve::offsets
