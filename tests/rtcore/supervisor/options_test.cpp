// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/options/options.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace psicarve::supervisor {
namespace {

std::variant<CoreOptions, int> parse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "psicarve-rtcore");
    std::vector<char*> pointers;
    pointers.reserve(arguments.size());
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    return parse_options(static_cast<int>(pointers.size()), pointers.data());
}

int exit_code_of(const std::vector<std::string>& arguments) {
    const auto parsed = parse(arguments);
    const int* code = std::get_if<int>(&parsed);
    return code == nullptr ? -1 : *code;
}

TEST(CoreOptions, DefaultsServeTheUsualSegmentOnTheSimulator) {
    const auto parsed = parse({});
    const auto& sut = std::get<CoreOptions>(parsed);
    EXPECT_EQ(sut.segment_name, "/psicarve");
    EXPECT_TRUE(sut.port.is_simulated());
    EXPECT_EQ(sut.clock, ClockKind::real);
    EXPECT_EQ(sut.capacity_layers, 4000U);
    EXPECT_EQ(sut.capacity_points, 3600U);
    EXPECT_EQ(sut.capacity_records, 8192U);
}

TEST(CoreOptions, TakeEveryOptionAndTwoTraces) {
    const auto parsed = parse({"--segment", "/x", "--clock", "virtual", "--profile", "p.toml", "--trace",
                               "a.vcd", "--trace", "fd:5", "--capacity", "12x34", "--program-ring", "256",
                               "--replay", "j", "--exit-with-parent"});
    const auto& sut = std::get<CoreOptions>(parsed);
    EXPECT_EQ(sut.segment_name, "/x");
    EXPECT_EQ(sut.clock, ClockKind::virtual_time);
    EXPECT_EQ(sut.trace_paths, (std::vector<std::string>{"a.vcd", "fd:5"}));
    EXPECT_EQ(sut.capacity_layers, 12U);
    EXPECT_EQ(sut.capacity_points, 34U);
    EXPECT_EQ(sut.capacity_records, 256U);
    EXPECT_TRUE(sut.exit_with_parent);
}

TEST(CoreOptions, RefuseWrongUsageWithExitCodeTwo) {
    EXPECT_EQ(exit_code_of({"--clock", "sundial"}), 2);
    EXPECT_EQ(exit_code_of({"--port", "usb:1"}), 2);
    EXPECT_EQ(exit_code_of({"--segment", "noslash"}), 2);
    EXPECT_EQ(exit_code_of({"--segment", "/a/b"}), 2);
    EXPECT_EQ(exit_code_of({"--capacity", "0x5"}), 2);
    for (const char* records : {"0", "63", "100", "131072", "-64", "many", "64.5"})
        EXPECT_EQ(exit_code_of({"--program-ring", records}), 2) << records;
    EXPECT_EQ(exit_code_of({"--capacity", "5"}), 2);
    EXPECT_EQ(exit_code_of({"--capacity", "5x5x"}), 2);
    EXPECT_EQ(exit_code_of({"--trace", ""}), 2);
    EXPECT_EQ(exit_code_of({"--profile", ""}), 2);
    EXPECT_EQ(exit_code_of({"--no-such-option"}), 2);
    EXPECT_EQ(exit_code_of({"stray"}), 2);
    EXPECT_EQ(exit_code_of({"--replay", "new.job", "--clock", "virtual", "--trace", "./new.job"}), 2);
    EXPECT_EQ(exit_code_of({"--trace", "new.vcd", "--trace", "./new.vcd"}), 2);
}

std::string error_of(const std::vector<std::string>& arguments) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(exit_code_of(arguments), 2);
    return testing::internal::GetCapturedStderr();
}

TEST(CoreOptions, KeepStateWhereTimeIsRealUnlessTheySayOtherwise) {
    const auto folder = [](std::vector<std::string> arguments) {
        const auto parsed = parse(std::move(arguments));
        const auto* options = std::get_if<CoreOptions>(&parsed);
        return options == nullptr ? "refused" : options->state_folder;
    };
    setenv("PSICARVE_STATE", "/srv", 1);
    EXPECT_EQ(folder({}), "/srv");
    EXPECT_EQ(folder({"--state", "here"}), "here");
    EXPECT_EQ(folder({"--no-state"}), "");
    EXPECT_EQ(folder({"--clock", "virtual"}), "");
    EXPECT_EQ(folder({"--clock", "virtual", "--state", "here"}), "here");
    EXPECT_EQ(folder({"--replay", "a.job"}), "");
    EXPECT_EQ(folder({"--measure-latency"}), "");
    setenv("PSICARVE_STATE", "", 1);
    EXPECT_EQ(folder({}), "");
    EXPECT_EQ(folder({"--state", "here"}), "here");
    EXPECT_EQ(exit_code_of({"--state", "a", "--no-state"}), 2);
    EXPECT_EQ(exit_code_of({"--state", "a", "--replay", "a.job"}), 2);
    EXPECT_EQ(exit_code_of({"--state", ""}), 2);
}

TEST(CoreOptions, SayWhatAClockCanBe) {
    const std::string error = error_of({"--clock", "fast"});
    EXPECT_NE(error.find("fast not in {real,virtual}"), std::string::npos) << error;
}

TEST(CoreOptions, RefuseACapacityThatSharedMemoryHasNoRoomFor) {
    const std::string error = error_of({"--capacity", "1000000x1000000"});
    EXPECT_NE(error.find("--capacity 1000000x1000000: a job of that size takes 8000"), std::string::npos)
        << error;
    EXPECT_NE(error.find("MB free"), std::string::npos) << error;
}

TEST(CoreOptions, HelpIsNoError) {
    EXPECT_EQ(exit_code_of({"--help"}), 0);
}

}  // namespace
}  // namespace psicarve::supervisor
