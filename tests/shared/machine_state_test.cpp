// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/machine_state.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace psicarve {
namespace {

// What each state allows, in the operator's words: "event > state". Whatever is not here is refused.
const std::map<std::string, std::map<std::string, std::string>> kAllowed{
    {"off",
     {{"home", "homing"},
      {"reset height", "homing"},
      {"begin test", "testing"},
      {"stop", "off"},
      {"fail", "alarm"}}},
    {"testing", {{"begin test", "testing"}, {"end test", "off"}, {"stop", "off"}, {"fail", "alarm"}}},
    {"homing",
     {{"home done", "ready"},
      {"home done, an axis not homed", "off"},
      {"stop", "stopping"},
      {"fail", "alarm"}}},
    {"ready",
     {{"start", "positioning"},
      {"move", "moving"},
      {"home", "homing"},
      {"reset height", "homing"},
      {"drives off", "off"},
      {"run program", "carving"},
      {"stop", "ready"},
      {"fail", "alarm"}}},
    {"moving", {{"move done", "ready"}, {"stop", "stopping"}, {"fail", "alarm"}}},
    {"positioning", {{"positioned", "waiting"}, {"stop", "stopping"}, {"fail", "alarm"}}},
    {"waiting", {{"start interpolation", "carving"}, {"stop", "stopping"}, {"fail", "alarm"}}},
    {"carving",
     {{"hold", "holding"},
      {"last point done", "finishing"},
      {"program done", "ready"},
      {"stop", "stopping"},
      {"fail", "alarm"}}},
    {"holding", {{"at rest", "held"}, {"resume", "carving"}, {"stop", "stopping"}, {"fail", "alarm"}}},
    {"held", {{"resume", "carving"}, {"stop", "stopping"}, {"fail", "alarm"}}},
    {"finishing", {{"finished", "ready"}, {"stop", "stopping"}, {"fail", "alarm"}}},
    {"stopping",
     {{"at rest", "stopping"},
      {"stopped", "ready"},
      {"stopped, an axis not homed", "off"},
      {"stop", "stopping"},
      {"fail", "alarm"}}},
    {"alarm",
     {{"reset alarm, position unknown", "off"},
      {"reset alarm, position known", "ready"},
      {"back off", "backing off"},
      {"stop", "alarm"},
      {"fail", "alarm"}}},
    {"backing off", {{"back off done", "alarm"}, {"stop", "alarm"}, {"fail", "alarm"}}}};

TEST(MachineState, EveryPairOfStateAndEventDoesWhatIsListed) {
    int allowed = 0;
    for (std::uint8_t s = 0; s < kMachineStateCount; ++s) {
        const auto from = static_cast<MachineState>(s);
        const auto& row = kAllowed.at(std::string(name_of(from)));
        for (std::uint8_t e = 0; e < kMachineEventCount; ++e) {
            const auto event = static_cast<MachineEvent>(e);
            const auto listed = row.find(std::string(name_of(event)));
            const auto to = next_state(from, event);
            EXPECT_EQ(to ? name_of(*to) : "refused", listed == row.end() ? "refused" : listed->second)
                << name_of(from) << " + " << name_of(event);
            if (to) ++allowed;
        }
    }
    int listed = 0;
    for (const auto& [state, row] : kAllowed) listed += static_cast<int>(row.size());
    EXPECT_EQ(allowed, listed) << "the list names an event that does not exist";
}

TEST(MachineState, AtRestAreTheStatesThatWaitForACommand) {
    const std::set<std::string> resting{"off", "ready", "waiting", "held", "alarm"};
    for (std::uint8_t s = 0; s < kMachineStateCount; ++s) {
        const auto state = static_cast<MachineState>(s);
        EXPECT_EQ(is_at_rest(state), resting.contains(std::string(name_of(state)))) << name_of(state);
    }
}

TEST(MachineState, ANumberThatIsNoStateHasANameAndGoesNowhere) {
    const auto foreign = static_cast<MachineState>(200);
    EXPECT_EQ(name_of(foreign), "unknown");
    EXPECT_FALSE(next_state(foreign, MachineEvent::home));
    EXPECT_EQ(name_of(static_cast<MachineEvent>(200)), "unknown");
}

TEST(AlarmCause, EachHasItsOwnNameAndRemedy) {
    std::set<std::string_view> names;
    std::set<std::string_view> remedies;
    for (std::uint8_t c = 0; c < kAlarmCauseCount; ++c) {
        const auto cause = static_cast<AlarmCause>(c);
        names.insert(name_of(cause));
        remedies.insert(remedy_of(cause));
        EXPECT_NE(name_of(cause), "unknown");
        EXPECT_TRUE(remedy_of(cause).ends_with('.'));
    }
    EXPECT_EQ(names.size(), kAlarmCauseCount);
    EXPECT_EQ(remedies.size(), kAlarmCauseCount);
    EXPECT_EQ(name_of(AlarmCause::steps_lost), "steps lost");
    EXPECT_EQ(name_of(static_cast<AlarmCause>(99)), "unknown");
}

TEST(MachineState, AJobRunsFromItsStartToItsRetraction) {
    using S = MachineState;
    for (std::uint8_t i = 0; i < kMachineStateCount; ++i) {
        const auto state = static_cast<S>(i);
        const bool can_stop_job = next_state(state, MachineEvent::stop) == S::stopping;
        const bool is_ending = state == S::finishing || state == S::stopping;
        const bool moves_without_job = state == S::homing || state == S::moving;
        if (moves_without_job) {
            EXPECT_FALSE(runs_job(state)) << name_of(state);
        } else {
            EXPECT_EQ(runs_job(state), can_stop_job || is_ending) << name_of(state);
        }
    }
}

}  // namespace
}  // namespace psicarve
