// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "shared/segment/layout.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"
#include "tests/shared/segment_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

class SegmentJobs : public test::SegmentOfTwo {};

TEST_F(SegmentJobs, NothingIsPublishedAtFirst) {
    EXPECT_FALSE(take_published_job(*core_, 0).value().has_value());
    EXPECT_TRUE(copy_current_job(*hmi_, milliseconds{100}).value().blob.empty());
}

TEST_F(SegmentJobs, CoreTakesWhatWasPublishedOnce) {
    const auto job = test::make_job(1234, 500, 500);

    const auto generation = publish_job(*hmi_, job);

    ASSERT_TRUE(generation.has_value()) << generation.error().message;
    const auto taken = take_published_job(*core_, 0).value();
    ASSERT_TRUE(taken.has_value());
    EXPECT_EQ(taken->generation, *generation);
    EXPECT_EQ(taken->blob, job);
    EXPECT_FALSE(take_published_job(*core_, *generation).value().has_value());
    EXPECT_EQ(copy_current_job(*hmi_, milliseconds{100}).value().blob, job);
}

TEST_F(SegmentJobs, TheAcceptedJobOutlivesAllThatAreRefusedAfterIt) {
    const auto accepted = test::make_job(1, 100, 100);
    const auto first = publish_job(*hmi_, accepted).value();
    acknowledge_job(*core_, first, true);
    CoreStatus status{};
    status.state = MachineState::ready;
    status.job_generation = first;
    write_record(core_->header().status, status);
    for (int seed = 2; seed < 6; ++seed) {
        const auto refused = publish_job(*hmi_, test::make_job(seed, 50, 50)).value();
        EXPECT_GT(refused, first);
        acknowledge_job(*core_, refused, false, {message_of(MessageId::busy_for_a_job)});
        const auto current = copy_current_job(*hmi_, milliseconds{100}).value();
        EXPECT_EQ(current.generation, first);
        EXPECT_EQ(current.blob, accepted);
    }
}

TEST_F(SegmentJobs, RemarksOnAnAcceptedJobArriveAsTheyWereSaid) {
    const auto accepted = publish_job(*hmi_, test::make_job(1, 50, 50)).value();
    EXPECT_TRUE(job_remarks(*hmi_).empty());
    const std::vector<Message> said{
        message_of(MessageId::segment_and_disk_disagree, count_argument(7), count_argument(4)),
        message_of(MessageId::begun_with_other_profile)};
    acknowledge_job(*core_, accepted, true, said);
    const std::vector<Message> remarks = job_remarks(*hmi_);
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_EQ(remarks[0].arguments[1].bits, 4U);
    EXPECT_EQ(in_words(remarks),
              "segment: layer 7, disk: 4; where this piece goes on the two disagree, the lower one is taken; "
              "this piece was begun with another profile of the machine");
    // More than there is room for, and a count that is damaged.
    acknowledge_job(*core_, accepted, true, std::vector<Message>(5, said[1]));
    EXPECT_EQ(job_remarks(*hmi_).size(), kVerdictMessages);
    auto verdict = read_record(core_->header().verdict).value();
    verdict.said_count = 0xFFFFFFFFU;
    write_record(core_->header().verdict, verdict);
    EXPECT_EQ(job_remarks(*hmi_).size(), kVerdictMessages);
}

TEST_F(SegmentJobs, ARefusalWithoutAMessageSaysSo) {
    const auto refused = publish_job(*hmi_, test::make_job(1, 50, 50)).value();
    acknowledge_job(*core_, refused, false);
    EXPECT_EQ(wait_for_acceptance(*hmi_, refused, milliseconds{1000}).error().said.id,
              MessageId::job_refused_without_reason);
    const auto also = publish_job(*hmi_, test::make_job(2, 50, 50)).value();
    acknowledge_job(*core_, also, false, {psicarve::Message{}});
    EXPECT_EQ(wait_for_acceptance(*hmi_, also, milliseconds{1000}).error().said.id,
              MessageId::job_refused_without_reason);
}

TEST_F(SegmentJobs, ARefusedJobAloneIsNoCurrentJob) {
    const auto refused = publish_job(*hmi_, test::make_job(1, 100, 100)).value();
    acknowledge_job(*core_, refused, false, {message_of(MessageId::busy_for_a_job)});
    EXPECT_TRUE(copy_current_job(*hmi_, milliseconds{100}).value().blob.empty());
}

TEST_F(SegmentJobs, NothingIsPublishedWhileAJobRuns) {
    ASSERT_TRUE(core_->claim_core());
    const auto first = publish_job(*hmi_, test::make_job(1, 100, 100)).value();
    acknowledge_job(*core_, first, true);
    CoreStatus status{};
    status.state = MachineState::carving;
    status.job_generation = first;
    write_record(core_->header().status, status);
    const auto second = publish_job(*hmi_, test::make_job(2, 50, 50));
    ASSERT_FALSE(second.has_value());
    EXPECT_EQ(second.error().code, ErrorCode::machine_refused);
    EXPECT_NE(second.error().message.find("carving"), std::string::npos);
    EXPECT_EQ(published_generation(*hmi_), first);
}

// Each of the two slots is written to again while the core still copies it.
TEST_F(SegmentJobs, WhatIsTakenIsOfOnePieceAndOfItsGenerationHoweverFastOthersFollow) {
    const std::array<std::vector<std::byte>, 3> jobs{test::make_job(1, 300, 300), test::make_job(2, 300, 300),
                                                     test::make_job(3, 300, 300)};
    const int rounds = test::is_thorough() ? 400 : 40;
    std::atomic<bool> is_over{false};
    std::thread publisher{[&] {
        for (std::uint64_t next = 1; !is_over; ++next) {
            const auto generation = publish_job(*hmi_, jobs[next % 3]);
            EXPECT_TRUE(generation && *generation == next) << (generation ? "" : generation.error().message);
            // Now and then the core may be quicker.
            if (next % 16 == 0) std::this_thread::sleep_for(milliseconds{1});
        }
    }};
    int taken_count = 0;
    const auto latest = std::chrono::steady_clock::now() + std::chrono::minutes{2};
    while (taken_count < rounds && std::chrono::steady_clock::now() < latest) {
        const auto taken = take_published_job(*core_, 0);
        EXPECT_TRUE(taken) << taken.error().message;
        if (!taken) break;
        if (!taken->has_value()) continue;  // not begun yet, or each of its attempts was overtaken
        ++taken_count;
        EXPECT_TRUE((*taken)->blob == jobs[(*taken)->generation % 3]) << (*taken)->generation;
    }
    is_over = true;
    publisher.join();
    EXPECT_EQ(taken_count, rounds);
}

TEST_F(SegmentJobs, NewerJobReplacesAnOlderWhichMayBeLarger) {
    ASSERT_TRUE(publish_job(*hmi_, test::make_job(1, 100, 100)).has_value());
    ASSERT_TRUE(publish_job(*hmi_, test::make_job(2, 50, 50)).has_value());
    ASSERT_TRUE(publish_job(*hmi_, test::make_job(3, 4, 5)).has_value());

    const auto taken = take_published_job(*core_, 1).value();

    ASSERT_TRUE(taken.has_value());
    EXPECT_EQ(taken->generation, 3U);
    EXPECT_EQ(taken->blob, test::make_job(3, 4, 5));
}

TEST_F(SegmentJobs, JobThatFillsTheCapacityFits) {
    EXPECT_TRUE(publish_job(*hmi_, test::make_job(1, 500, 500)).has_value());
}

TEST_F(SegmentJobs, JobLargerThanASlotIsRefusedWithSizesAndRemedy) {
    const auto refused = publish_job(*hmi_, test::make_job(1, 600, 500));

    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
    EXPECT_THAT(refused.error().message, HasSubstr("500 layers x 500 points"));
    EXPECT_THAT(refused.error().message, HasSubstr("--capacity"));
    EXPECT_EQ(published_generation(*core_), 0U);
}

TEST_F(SegmentJobs, DamagedContentIsRefused) {
    ASSERT_TRUE(publish_job(*hmi_, test::make_job(1)).has_value());
    auto other = test::make_job(2);
    ASSERT_TRUE(hmi_->write_slot(1, other).has_value());

    const auto taken = take_published_job(*core_, 0);

    ASSERT_FALSE(taken.has_value());
    EXPECT_THAT(taken.error().message, HasSubstr("checksum"));
}

TEST_F(SegmentJobs, SizesThatCannotBeAreRefused) {
    ASSERT_TRUE(publish_job(*hmi_, test::make_job(1)).has_value());
    for (const std::uint64_t bytes : {std::uint64_t{0}, hmi_->slot_bytes() + 1, ~std::uint64_t{0}}) {
        hmi_->header().publication.of_slot[1].bytes.store(bytes);

        EXPECT_FALSE(take_published_job(*core_, 0).has_value()) << bytes;
    }
}

TEST_F(SegmentJobs, GarbageInThePublicationNeverBringsTheCoreDown) {
    ASSERT_TRUE(publish_job(*hmi_, test::make_job(1)).has_value());
    std::uint64_t word = 0x9E3779B97F4A7C15ULL;
    for (int round = 0; round < 200; ++round) {
        word = word * 6364136223846793005ULL + 1442695040888963407ULL;
        Publication& publication = hmi_->header().publication;
        publication.generation.store(word);
        publication.of_slot[round % 2].bytes.store(word >> (round % 60));
        publication.of_slot[round % 2].checksum.store(~word);
        const auto taken = take_published_job(*core_, 0);
        EXPECT_TRUE(!taken.has_value() || !taken->has_value());
    }
}

TEST_F(SegmentJobs, PublishingGoesOnAfterTheLastGeneration) {
    hmi_->header().publication.generation.store(~std::uint64_t{0});

    EXPECT_NE(publish_job(*hmi_, test::make_job(1)).value(), 0U);
}

TEST_F(SegmentJobs, AcceptanceAndRefusalReachThePublisher) {
    ASSERT_TRUE(core_->claim_core().has_value());
    const auto first = publish_job(*hmi_, test::make_job(1)).value();
    acknowledge_job(*core_, first, true);
    EXPECT_TRUE(wait_for_acceptance(*hmi_, first, milliseconds{1000}).has_value());

    const auto second = publish_job(*hmi_, test::make_job(2)).value();
    acknowledge_job(*core_, second, false,
                    {with_text(message_of(MessageId::job_unsound), "layer 3, point 4: \x1b[31mtoo far out")});
    const auto refused = wait_for_acceptance(*hmi_, second, milliseconds{1000});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::machine_refused);
    EXPECT_EQ(refused.error().message, "layer 3, point 4: ?[31mtoo far out");
    EXPECT_EQ(refused.error().said.id, MessageId::job_unsound);

    EXPECT_EQ(wait_for_acceptance(*hmi_, first, milliseconds{1000}).error().code, ErrorCode::machine_refused);
}

TEST_F(SegmentJobs, WaitingEndsWithItsLimitOrWithTheCore) {
    const auto generation = publish_job(*hmi_, test::make_job(1)).value();
    EXPECT_EQ(wait_for_acceptance(*hmi_, generation, milliseconds{5}).error().code, ErrorCode::no_core);

    ASSERT_TRUE(core_->claim_core().has_value());
    EXPECT_EQ(wait_for_acceptance(*hmi_, generation, milliseconds{5}).error().code, ErrorCode::timed_out);
}

TEST_F(SegmentJobs, CoreTakesWholeJobsOnlyWhilePublishersAreBusy) {
    constexpr int kJobs = 200;
    std::atomic<bool> is_done{false};
    std::thread publisher{[&] {
        for (int mark = 1; mark <= kJobs; ++mark) {
            EXPECT_TRUE(publish_job(*hmi_, test::make_job(mark, 40, 40)).has_value());
        }
        is_done.store(true);
    }};

    std::uint64_t known = 0;
    while (!is_done.load() || known < kJobs) {
        const auto taken = take_published_job(*core_, known);
        ASSERT_TRUE(taken.has_value()) << taken.error().message;
        if (!taken->has_value()) continue;
        known = (*taken)->generation;
        ASSERT_EQ((*taken)->blob, test::make_job(static_cast<std::int32_t>(known), 40, 40));
    }
    publisher.join();
}

}  // namespace
}  // namespace psicarve
