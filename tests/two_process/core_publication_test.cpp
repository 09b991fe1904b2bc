// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/event.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

/// The word that says which job is published, overwritten while a core serves.
class CorePublication : public CoreRig {
protected:
    void SetUp() override {
        start_core();
        ASSERT_EQ(publish(lobed_job(2, 9)), "");
        ASSERT_EQ(publish(lobed_job(3, 9)), "");
        accepted_ = status().job_generation;
    }
    AtomicWord64& word() { return segment_->header().publication.generation; }
    void set_word_and_wait_until_seen(std::uint64_t value) {
        word().store(value);
        event_signal(segment_->header().command_raised);
        if (value == 0) return;
        EXPECT_TRUE(eventually([&] {
            const auto verdict = read_record(segment_->header().verdict);
            return verdict && verdict->generation == value;
        })) << value;
    }
    std::uint64_t points_of_the_loaded_job() { return status().points_total; }

    std::uint64_t accepted_ = 0;
};

TEST_F(CorePublication, AJobThatNobodyPublishedIsNotTaken) {
    for (const std::uint64_t value : {accepted_ + 1, accepted_ + 2, accepted_ ^ (std::uint64_t{1} << 40)}) {
        set_word_and_wait_until_seen(value);
        EXPECT_EQ(read_record(segment_->header().verdict)->accepted, 2U) << value;
        EXPECT_EQ(status().job_generation, accepted_) << value;
        EXPECT_EQ(points_of_the_loaded_job(), 27U) << value;
    }
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done == 27; })) << "the job that was accepted";
    ASSERT_TRUE(reaches(MachineState::ready));
}

TEST_F(CorePublication, WhateverTheWordWasTheNextJobIsTaken) {
    std::uint32_t layers = 3;
    for (const std::uint64_t value : {std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0} - 1,
                                      std::uint64_t{1} << 63, std::uint64_t{1} << 40}) {
        set_word_and_wait_until_seen(value);
        ASSERT_EQ(publish(lobed_job(++layers, 9)), "") << value;
        EXPECT_EQ(points_of_the_loaded_job(), std::uint64_t{layers} * 9) << value;
        EXPECT_GT(status().job_generation, accepted_);
    }
}

TEST_F(CorePublication, ARefusalAfterADamagedWordIsATrueOneAndANewCoreHasTheJobBefore) {
    Profile other;
    other.r1.speed_mm_s = 9.0;
    for (const std::uint64_t value : {std::uint64_t{0}, ~std::uint64_t{0}}) {
        set_word_and_wait_until_seen(value);
        const std::string reason = publish(lobed_job(5, 9, other));
        ASSERT_NE(reason.find("axis.r1.speed_mm_s"), std::string::npos) << value << ": " << reason;
        EXPECT_EQ(word().load(), accepted_);
    }
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    start_core();
    ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
    EXPECT_EQ(status().job_generation, accepted_);
    EXPECT_EQ(points_of_the_loaded_job(), 27U);
}

}  // namespace
}  // namespace psicarve::two_process
