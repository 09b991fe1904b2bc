// SPDX-License-Identifier: GPL-3.0-or-later
// The records that record_fuzz begins with are those of real programs; when the record changes they are made
// anew by
//   PSICARVE_WRITE_SEEDS=1 build/dev/tests/gcode_test --gtest_filter='RecordSeeds.*'
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "shared/file/atomic_file.hpp"
#include "tests/fuzz/record_input.hpp"
#include "tests/hmi/gcode/made_records.hpp"
#include "tests/places.hpp"

namespace psicarve::gcode {
namespace {

struct RecordSeed {
    const char* name;
    std::uint8_t how;
    std::uint8_t pace;
    std::uint8_t passes;
    std::string program;
    bool is_stepwise = false;
};

/// Short ways round and round, on which nothing asks for a rest.
std::string dense_seed() {
    std::ostringstream text;
    text << "F600 G64 P0.02\nG0 X30.0 Z30 Y16 C0\n";
    for (int i = 0; i < 120; ++i) {
        text << "G1 X" << 28.0 + 2.0 * std::cos(0.0524 * i) << " Y" << 16.0 + 2.0 * std::sin(0.0524 * i)
             << " C" << 0.3 * i << "\n";
    }
    return text.str() + "M2\n";
}

std::vector<RecordSeed> record_seeds() {
    return {
        {"dense", 0, 3, 10, dense_seed()},
        {"dense_held", fuzz::kIsHeld, 250, 10, dense_seed()},
        {"arcs", fuzz::kHasBacklash, 15, 0,
         "F900 G64 P0.05\nG0 X30 Z30 Y20\nM3\nG17 G2 X30 Y20 I-1 J0\nG3 X29 Y21 I0 J1\nG1 X29.5 C10\n"
         "G19 G2 Z30.5 Y21.5 K0.5 J0\nM5\nM2\n"},
        {"corners", fuzz::kIsSingle, 7, 2,
         "F1200 G61\nG0 X29 Z31 Y18 C5\nG1 X28.5\nY18.5\nG64 P.1\nX29 C8\nX28.5 C2\nG61.1 Z30\nG4 P.01\nM0\n"
         "G1 C-20\nM30\n"},
        {"drill", fuzz::kIsTwoTimer, 31, 0,
         "F300 G0 X31 Y22\nG81 X30 Y21 Z29 R30\nY22\nG83 Z28.5 R30 Q.5\nG80\nM2\n"},
        {"stops", fuzz::kLiftsOnHold | fuzz::kIsHeld, 64, 0,
         "F500 M3\nG1 X29 Z30 C30\nM0\nT1 M6\nG1 X30 Y15\nG93 G1 X29 F30\nM5\nG4 P2\nG0 X31\nM2\n"},
        {"steps", fuzz::kHasBacklash | fuzz::kIsHeld, 9, 1,
         "F900\nG0 X30 Z30 Y20\nM3\nG1 X29.5 Y20.3\nG17 G3 X29 Y20.8 I-.5 J0\nG2 J-.4 P2\nG1 X29.2 C5\n"
         "G19 G2 Z30.5 Y21.3 K0.5 J0\nG1 Z30\nM5\nM2\n",
         true},
        {"loop", 0, 90, 0,
         "F3000 G64 P.02\nG0 X30 Y15\no1 repeat [20]\nG91 G1 X-.05 C1\nY.05\nX.05\nG90\no1 endrepeat\nM2\n"},
    };
}

TEST(RecordSeeds, AreRecordsOfRealPrograms) {
    for (const RecordSeed& seed : record_seeds()) {
        Profile profile;
        profile.gcode.is_stepwise = seed.is_stepwise;
        const MadeRecords made = made_records(seed.program, {}, profile);
        ASSERT_EQ(made.faults, Faults{}) << seed.name;
        ASSERT_EQ(made.failure, "") << seed.name;
        const auto wanted = fuzz::bytes_of_input(seed.how, seed.pace, seed.passes, made.records);
        const std::string path = in_source(std::string{"tests/fuzz/corpus/record/"} + seed.name);
        if (std::getenv("PSICARVE_WRITE_SEEDS") != nullptr) {
            ASSERT_TRUE(write_file_atomically(path, wanted).has_value());
        }
        const auto kept = read_whole_file(path);
        ASSERT_TRUE(kept.has_value()) << kept.error().message;
        EXPECT_TRUE(*kept == wanted) << seed.name << ": the records have changed: make them anew, see above";
    }
}

}  // namespace
}  // namespace psicarve::gcode
