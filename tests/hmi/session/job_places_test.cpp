// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_places.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using DS = OpenJobState;
using S = MachineState;

MachineView machine_at(S state, std::uint64_t points_done, std::uint64_t points_total = 2000) {
    MachineView view = machine_in(state);
    view.status->points_done = points_done;
    view.status->points_total = points_total;
    return view;
}

std::string noted(const MachineView& machine) {
    return in_english(machine_job_note(machine));
}

TEST(JobPlaces, AreAskedForWhatWouldBeStartedOrRuns) {
    constexpr bool kIsKnown = true;
    EXPECT_EQ(place_in_question(machine_in(S::ready), {DS::published}, kIsKnown), JobPlace::machine);
    for (const DS other : {DS::empty, DS::opening, DS::model, DS::slicing, DS::job, DS::publishing}) {
        EXPECT_EQ(place_in_question(machine_in(S::ready), {other}, kIsKnown), JobPlace::desk);
        EXPECT_EQ(place_in_question(machine_in(S::carving), {other}, kIsKnown), JobPlace::machine);
        EXPECT_EQ(place_in_question(machine_in(S::carving), {other}, !kIsKnown), JobPlace::desk);
        EXPECT_EQ(place_in_question(machine_in(S::held), {other}, kIsKnown), JobPlace::machine);
    }
    MachineView lost = machine_in(S::carving);
    lost.life = CoreLife::none;
    EXPECT_EQ(place_in_question(lost, {DS::job}, kIsKnown), JobPlace::desk);
}

TEST(JobPlaces, TellTheMachinesJobByItsNumberAndHowFarItIs) {
    EXPECT_EQ(noted(machine_at(S::ready, 0)), "no. 3");
    EXPECT_EQ(noted(machine_at(S::carving, 801)), "no. 3, 40 % done");
    EXPECT_EQ(noted(machine_at(S::ready, 2000)), "no. 3, 100 % done");
    EXPECT_EQ(noted(machine_at(S::ready, 1999)), "no. 3, 99 % done");
    MachineView dry = machine_at(S::carving, 500);
    dry.status->is_dry = 1;
    EXPECT_EQ(noted(dry), "no. 3, dry run 25 %");
    MachineView none = machine_at(S::ready, 0);
    none.status->job_generation = 0;
    EXPECT_EQ(noted(none), "");
    none.life = CoreLife::none;
    EXPECT_EQ(noted(none), "no core");
    EXPECT_EQ(noted(MachineView{}), "no core");
    MachineView silent = machine_at(S::carving, 500);
    silent.life = CoreLife::silent;
    EXPECT_EQ(noted(silent), "no. 3, 25 % done");
}

TEST(JobPlaces, TellWhatLiesOnTheDesk) {
    const auto on_desk = [](DS state, bool was_published = false) {
        OpenJobView view{state};
        view.was_published = was_published;
        return in_english(desk_job_note(view));
    };
    EXPECT_EQ(on_desk(DS::empty), "nothing");
    EXPECT_EQ(on_desk(DS::opening), "being read");
    EXPECT_EQ(on_desk(DS::model), "not sliced");
    EXPECT_EQ(on_desk(DS::slicing), "being sliced");
    EXPECT_EQ(on_desk(DS::job), "not published");
    EXPECT_EQ(on_desk(DS::job, true), "no longer in the machine");
    EXPECT_EQ(on_desk(DS::publishing), "being published");
    EXPECT_EQ(on_desk(DS::published, true), "the same job");
}

}  // namespace
}  // namespace psicarve::session
