// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/run_request.hpp"

#include <gtest/gtest.h>

#include "hmi/program/program_process.hpp"

namespace psicarve::program {
namespace {

using Words = std::vector<std::string>;

TEST(RunRequest, NamesFileAndMachineAlone) {
    EXPECT_EQ(arguments_of("/bin/psicarve", {"/a b.ngc", {}, "psicarve", {}, {}}),
              (Words{"/bin/psicarve", "gcode", "run", "/a b.ngc", "--segment", "psicarve"}));
}

TEST(RunRequest, HasEverySwitchUnderItsOwnName) {
    RunRequest request{"/a.ngc", {}, "mill", "cnc", "/p.toml"};
    const Words common{"psicarve", "gcode",   "run", "/a.ngc",    "--segment",
                       "mill",     "--group", "cnc", "--profile", "/p.toml"};
    const auto with = [&common](Words more) {
        Words all = common;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const auto made = [&request](RunSwitches switches) {
        request.switches = switches;
        return arguments_of("psicarve", request);
    };
    RunSwitches one;
    one.is_single = true;
    EXPECT_EQ(made(one), with({"--single"}));
    one = {};
    one.stops_at_optional = true;
    EXPECT_EQ(made(one), with({"--optional-stop"}));
    one = {};
    one.skips_deleted = true;
    EXPECT_EQ(made(one), with({"--block-delete"}));
    one = {};
    one.is_dry = true;
    EXPECT_EQ(made(one), with({"--dry-run"}));
    request.is_typed = true;
    EXPECT_EQ(made({}), with({"--mdi"}));
    request.is_typed = false;
    EXPECT_EQ(made({true, true, true, true, 120}), with({"--from-line", "120", "--unattended", "--single",
                                                         "--optional-stop", "--block-delete", "--dry-run"}));
}

TEST(RunRequest, TellsTheLastOfWhatItsProcessSaid) {
    const std::string said = "psicarve: warning: one\n\npsicarve: a.ngc:3: r1 is outside its travel\n";
    EXPECT_EQ(last_said(said), "a.ngc:3: r1 is outside its travel");
    EXPECT_EQ(last_lines(said, 2), "psicarve: warning: one\npsicarve: a.ngc:3: r1 is outside its travel");
    EXPECT_EQ(last_lines(said, 1), "psicarve: a.ngc:3: r1 is outside its travel");
    EXPECT_EQ(last_said(""), "");
}

}  // namespace
}  // namespace psicarve::program
