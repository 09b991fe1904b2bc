// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/pin_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace psicarve::session {
namespace {

TEST(PinRows, HoldEverySignalOnceOutputsFirst) {
    const auto rows = pin_rows(Profile{});
    constexpr std::size_t kRows = kSignalCount - kSwitchedOutputCount;
    ASSERT_EQ(rows.size(), kRows) << "of the outputs that programs switch only those that are wired";
    std::set<std::string> names;
    for (const PinRow& row : rows) names.insert(row.name.english);
    EXPECT_EQ(names.size(), kRows);
    EXPECT_EQ(rows.front().signal, Signal::y_enable);
    EXPECT_EQ(rows.front().pin, 1);
    EXPECT_EQ(rows.front().register_bit, "control 0 inv");
    EXPECT_EQ(rows.back().signal, Signal::estop) << "not wired";
    EXPECT_EQ(rows.back().register_bit, "");
    EXPECT_FALSE(is_output(rows[kFirstInput].signal));
}

TEST(PinRows, KnowTheBusyPinAndActiveLowWiring) {
    Profile profile;
    profile.port.pins[index_of(Signal::r2_limit)] = -11;
    for (const PinRow& row : pin_rows(profile)) {
        if (row.signal != Signal::r2_limit) continue;
        EXPECT_EQ(row.pin, 11);
        EXPECT_TRUE(row.is_active_low);
        EXPECT_EQ(row.register_bit, "status 7 inv");
    }
}

TEST(PinRows, HoldTheOutputsThatProgramsSwitchWhereTheyAreWired) {
    Profile profile;
    profile.port.pins[index_of(Signal::r2_enable)] = 6;
    profile.port.pins[index_of(Signal::output_2)] = -7;
    const auto rows = pin_rows(profile);
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [](const PinRow& row) { return row.signal == Signal::output_2; });
    ASSERT_NE(found, rows.end());
    EXPECT_EQ(in_english(found->name), "Output 2");
    EXPECT_EQ(found->pin, 7);
    EXPECT_TRUE(found->is_active_low);
    EXPECT_EQ(rows.size(), kSignalCount - kSwitchedOutputCount + 1);
    EXPECT_EQ(in_english(pin_label({Signal::mist})), "Mist");
}

TEST(PinRows, HaveShortLabelsForTheConnector) {
    EXPECT_EQ(in_english(pin_label({Signal::y_dir})), "Y dir");
    EXPECT_EQ(in_english(pin_label({Signal::r1_enable, Signal::psi_enable})), "R1 Ψ en");
    EXPECT_EQ(in_english(pin_label({Signal::psi_index})), "Ψ index");
    EXPECT_EQ(in_english(pin_label({Signal::r1_enable, Signal::spindle})), "R1 en, Spindle");
    EXPECT_TRUE(pin_label({}).is_empty());
}

TEST(PinRows, TellWhichSwitchesStopTheMachine) {
    const SignalWord all = ~SignalWord{0};
    EXPECT_EQ(tripped_stops(all), bit_of(Signal::r1_limit) | bit_of(Signal::r2_limit) |
                                      bit_of(Signal::y_limit) | bit_of(Signal::estop));
    EXPECT_EQ(tripped_stops(bit_of(Signal::psi_index) | bit_of(Signal::spindle)), 0U)
        << "the index stops nothing";
    EXPECT_EQ(tripped_stops(bit_of(Signal::y_limit)), bit_of(Signal::y_limit));
}

}  // namespace
}  // namespace psicarve::session
