// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/signal.hpp"

#include <gtest/gtest.h>

#include "shared/base/result.hpp"
#include "shared/machine/command.hpp"

namespace psicarve {
namespace {

TEST(Signal, NamesLeadBackToTheirSignals) {
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        EXPECT_EQ(signal_from_name(name_of(signal)), signal);
    }
    EXPECT_EQ(name_of(Signal::psi_index), "psi_index");
    EXPECT_EQ(name_of(Signal::estop), "estop");
    EXPECT_FALSE(signal_from_name("psi_limit"));
    EXPECT_FALSE(signal_from_name(""));
}

TEST(Signal, ThoseOfAnAxisBearItsName) {
    for (const Axis axis : kAllAxes) {
        const std::string name(name_of(axis));
        EXPECT_EQ(name_of(step_of(axis)), name + "_step");
        EXPECT_EQ(name_of(dir_of(axis)), name + "_dir");
        EXPECT_EQ(name_of(enable_of(axis)), name + "_enable");
        EXPECT_EQ(name_of(sensor_of(axis)), name + (axis == Axis::psi ? "_index" : "_limit"));
        EXPECT_EQ(axis_from_name(name), axis);
    }
    EXPECT_FALSE(axis_from_name("x"));
}

TEST(Signal, MasksPartTheWord) {
    SignalWord outputs = 0;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        if (is_output(signal)) outputs |= bit_of(signal);
    }
    EXPECT_EQ(outputs, kOutputMask);
    EXPECT_EQ(kOutputMask & kInputMask, 0U);
    EXPECT_EQ(kOutputMask | kInputMask, (SignalWord{1} << kSignalCount) - 1);
    EXPECT_EQ(kStepMask | kDirMask | kEnableMask | bit_of(Signal::spindle) | kSwitchedMask, kOutputMask);
}

TEST(CommandKind, NamesAreThoseOfTheCommandLine) {
    EXPECT_EQ(name_of(CommandKind::home), "home");
    EXPECT_EQ(name_of(CommandKind::start), "start");
    EXPECT_EQ(name_of(CommandKind::start_interpolation), "start-interpolation");
    EXPECT_EQ(name_of(CommandKind::hold), "hold");
    EXPECT_EQ(name_of(CommandKind::resume), "resume");
    EXPECT_EQ(name_of(CommandKind::reset_alarm), "reset-alarm");
    EXPECT_EQ(name_of(CommandKind::back_off), "back-off");
    EXPECT_EQ(name_of(CommandKind::reset_height), "reset-height");
    EXPECT_EQ(name_of(CommandKind::override), "override");
    EXPECT_EQ(name_of(CommandKind::rapid_override), "override of rapids");
    EXPECT_EQ(name_of(CommandKind::single), "single");
    EXPECT_EQ(name_of(CommandKind::optional_stop), "optional-stop");
    EXPECT_EQ(name_of(CommandKind::program), "program");
    EXPECT_EQ(name_of(static_cast<CommandKind>(0xFFFFFFFF)), "unknown");
}

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> good = 5;
    EXPECT_TRUE(good);
    EXPECT_EQ(*good, 5);
    const Result<int> bad = bad_input("no");
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.error().code, ErrorCode::bad_input);
    EXPECT_EQ(bad.error().message, "no");
    EXPECT_TRUE(Result<void>{});
    EXPECT_FALSE(Result<void>(bad_input("no")));
}

}  // namespace
}  // namespace psicarve
