// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/machine_job.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using JobPointer = std::shared_ptr<const cam::PreparedJob>;

TEST(MachineJob, IsKnownOnceTheCoreHasAcceptedThatVeryOne) {
    const JobPointer job = std::make_shared<cam::PreparedJob>();
    MachineJob machine;
    EXPECT_EQ(machine.accepted(), nullptr);
    machine.take_published(4, job, {}, "cup.stl");
    EXPECT_EQ(machine.accepted(), nullptr);
    machine.note_accepted(3);
    EXPECT_EQ(machine.accepted(), nullptr);
    machine.note_accepted(4);
    EXPECT_EQ(machine.accepted(), job);
    machine.note_accepted(5);  // another program's
    EXPECT_EQ(machine.accepted(), nullptr);
}

TEST(MachineJob, ForgetsWhatAnothersJobWasMadeOf) {
    const auto mesh = std::make_shared<model::Mesh>();
    const JobPointer other = std::make_shared<cam::PreparedJob>();
    MachineJob machine;
    machine.take_published(4, std::make_shared<cam::PreparedJob>(), mesh, "cup.stl");
    EXPECT_EQ(machine.mesh(), mesh);
    EXPECT_EQ(machine.path(), "cup.stl");
    machine.take_fetched(5, other);
    machine.note_accepted(5);
    EXPECT_EQ(machine.accepted(), other);
    EXPECT_EQ(machine.generation(), 5U);
    EXPECT_EQ(machine.mesh(), nullptr);
    EXPECT_EQ(machine.path(), "");
}

TEST(MachineJob, AsksForEachGenerationOnce) {
    MachineJob machine;
    EXPECT_FALSE(machine.is_to_be_fetched(0));
    EXPECT_TRUE(machine.is_to_be_fetched(1));
    machine.note_fetch(1);
    EXPECT_FALSE(machine.is_to_be_fetched(1));
    EXPECT_FALSE(machine.is_to_be_fetched(0));
    EXPECT_TRUE(machine.is_to_be_fetched(2));
    machine.take_published(2, std::make_shared<cam::PreparedJob>(), {}, {});
    EXPECT_FALSE(machine.is_to_be_fetched(2));
    EXPECT_TRUE(machine.is_to_be_fetched(3));
}

}  // namespace
}  // namespace psicarve::session
