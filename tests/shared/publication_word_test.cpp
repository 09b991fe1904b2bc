// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "shared/segment/layout.hpp"
#include "shared/segment/robust_mutex.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

constexpr milliseconds kShort{100};

/// Whatever the word could be overwritten with: each bit flipped, the ends, neighbours.
std::set<std::uint64_t> wrong_words(std::uint64_t right) {
    std::set<std::uint64_t> words{0, 1, ~std::uint64_t{0}, ~std::uint64_t{0} - 1, std::uint64_t{1} << 63};
    for (int bit = 0; bit < 64; ++bit) words.insert(right ^ (std::uint64_t{1} << bit));
    for (std::uint64_t away = 1; away < 9; ++away) words.insert({right + away, right - away});
    words.erase(right);
    return words;
}

class PublicationWord : public test::SegmentOfTwo {
protected:
    /// As a core does that takes and accepts it.
    void accept(std::uint64_t generation) {
        CoreStatus status{};
        status.state = MachineState::ready;
        status.job_generation = generation;
        write_record(core_->header().status, status);
        acknowledge_job(*core_, generation, true);
    }
    std::uint64_t publish(std::int32_t mark) {
        const auto generation = publish_job(*hmi_, test::make_job(mark));
        EXPECT_TRUE(generation) << (generation ? "" : generation.error().message);
        if (!generation) return 0;
        jobs_[*generation] = test::make_job(mark);
        return *generation;
    }
    /// What a core with this knowledge takes was published, and as that generation.
    void expect_only_published(std::uint64_t known_generation, std::uint64_t word) {
        const auto taken = take_published_job(*core_, known_generation);
        if (!taken || !taken->has_value()) return;
        ASSERT_TRUE(jobs_.contains((*taken)->generation)) << word << " was taken for a job";
        EXPECT_TRUE((*taken)->blob == jobs_[(*taken)->generation]) << word;
    }
    void set_word(std::uint64_t word) { hmi_->header().publication.generation.store(word); }

    std::map<std::uint64_t, std::vector<std::byte>> jobs_;
};

TEST_F(PublicationWord, WhateverItIsOverwrittenWithNoJobIsTakenThatWasNotPublished) {
    publish(1);
    const std::uint64_t last = publish(2);
    for (const std::uint64_t word : wrong_words(last)) {
        set_word(word);
        expect_only_published(0, word);
        const auto known = take_published_job(*core_, last);
        EXPECT_FALSE(known && known->has_value()) << word << " brought an old job back";
    }
}

TEST_F(PublicationWord, WhateverItIsOverwrittenWithTheNextJobIsTakenAndAccepted) {
    publish(1);
    std::uint64_t last = publish(2);
    accept(last);
    ASSERT_TRUE(core_->claim_core());
    accept(last);
    std::int32_t mark = 2;
    for (const std::uint64_t word : wrong_words(last)) {
        set_word(word);
        // As a core does that sees it.
        const auto seen = take_published_job(*core_, last);
        if (!seen) acknowledge_job(*core_, word, false, {seen.error().said});
        const std::uint64_t next = publish(++mark);
        ASSERT_GT(next, last) << word;
        EXPECT_EQ(published_generation(*hmi_), next);
        EXPECT_EQ(wait_for_acceptance(*hmi_, next, milliseconds{1}).error().code, ErrorCode::timed_out)
            << word << ": nobody has judged it";
        const auto taken = take_published_job(*core_, last);
        ASSERT_TRUE(taken && taken->has_value()) << word;
        EXPECT_TRUE((*taken)->blob == test::make_job(mark)) << word;
        accept(next);
        EXPECT_TRUE(wait_for_acceptance(*hmi_, next, kShort)) << word;
        last = next;
    }
}

TEST_F(PublicationWord, TheAcceptedJobIsThereForASnapshotWhateverTheWordIs) {
    const std::uint64_t first = publish(1);
    accept(first);
    for (const std::uint64_t word : wrong_words(first)) {
        set_word(word);
        const auto current = copy_current_job(*hmi_, kShort);
        ASSERT_TRUE(current) << word;
        EXPECT_EQ(current->generation, first) << word;
        EXPECT_TRUE(current->blob == jobs_[first]) << word;
    }
}

TEST_F(PublicationWord, WordsOfASlotThatDoNotBelongTogetherAreRefused) {
    const std::uint64_t generation = publish(1);
    SlotContent& content = hmi_->header().publication.of_slot[generation % 2];
    for (AtomicWord64* const word : {&content.bytes, &content.generation, &content.checksum, &content.seal}) {
        for (int bit = 0; bit < 64; ++bit) {
            const std::uint64_t right = word->load();
            word->store(right ^ (std::uint64_t{1} << bit));
            EXPECT_FALSE(take_published_job(*core_, 0)) << bit;
            EXPECT_FALSE(published_checksum(*hmi_)) << bit;
            word->store(right);
        }
    }
    EXPECT_TRUE(take_published_job(*core_, 0));
}

// A core started anew would take it for the job to go on with.
TEST_F(PublicationWord, ARefusedJobIsPublishedNoLonger) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t alone = publish(1);
    acknowledge_job(*core_, alone, false, {message_of(MessageId::busy_for_a_job)});
    EXPECT_EQ(wait_for_acceptance(*hmi_, alone, kShort).error().said.id, MessageId::busy_for_a_job);
    EXPECT_EQ(published_generation(*hmi_), 0U);
    EXPECT_FALSE(take_published_job(*core_, 0).value().has_value());

    const std::uint64_t good = publish(2);
    ASSERT_GT(good, alone);
    accept(good);
    const std::uint64_t bad = publish(3);
    acknowledge_job(*core_, bad, false, {message_of(MessageId::job_for_other_machine)});
    EXPECT_EQ(wait_for_acceptance(*hmi_, bad, kShort).error().said.id, MessageId::job_for_other_machine);
    EXPECT_EQ(published_generation(*hmi_), good);
    EXPECT_TRUE(take_published_job(*core_, 0).value().value().blob == jobs_[good]);
    EXPECT_GT(publish(4), bad) << "the core has judged that number";
}

TEST_F(PublicationWord, ARefusalOfAnotherJobTakesNothingBack) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t first = publish(1);
    acknowledge_job(*core_, first, false, {message_of(MessageId::busy_for_a_job)});
    const std::uint64_t second = publish(2);
    EXPECT_FALSE(wait_for_acceptance(*hmi_, first, kShort));
    EXPECT_EQ(published_generation(*hmi_), second);
    EXPECT_TRUE(take_published_job(*core_, first).value().value().blob == jobs_[second]);
}

// Its publisher was not given a processor until another's job was refused and taken back.
TEST_F(PublicationWord, AnAcceptedJobIsAcceptedWhateverWasPublishedAndRefusedSince) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t good = publish(1);
    accept(good);
    const std::uint64_t bad = publish(2);
    acknowledge_job(*core_, bad, false, {message_of(MessageId::busy_for_a_job)});
    EXPECT_TRUE(wait_for_acceptance(*hmi_, good, kShort)) << "before the other one is taken back";
    EXPECT_FALSE(wait_for_acceptance(*hmi_, bad, kShort));
    ASSERT_EQ(published_generation(*hmi_), good);
    EXPECT_TRUE(wait_for_acceptance(*hmi_, good, kShort));
}

// It may have been accepted in between: that is not known any more.
TEST_F(PublicationWord, OfAJobThatAnotherFollowedNobodyClaimsThatItWasNotLookedAt) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t first = publish(1);
    accept(first);
    accept(publish(2));
    const auto judged = wait_for_acceptance(*hmi_, first, kShort);
    ASSERT_FALSE(judged);
    EXPECT_EQ(judged.error().code, ErrorCode::machine_refused);
    EXPECT_EQ(judged.error().message.find("looked at"), std::string::npos) << judged.error().message;
}

// So it is where a core was started anew, and has only refused yet.
TEST_F(PublicationWord, ARefusedJobGivesWayToTheOneBeforeAlsoWhereNothingIsAccepted) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t before = publish(1);
    const std::uint64_t bad = publish(2);
    acknowledge_job(*core_, bad, false, {message_of(MessageId::busy_for_a_job)});
    EXPECT_FALSE(wait_for_acceptance(*hmi_, bad, kShort));
    EXPECT_EQ(published_generation(*hmi_), before);
    EXPECT_TRUE(take_published_job(*core_, 0).value().value().blob == jobs_[before]);
    const auto judged = wait_for_acceptance(*hmi_, before, kShort);
    ASSERT_FALSE(judged);
    EXPECT_EQ(judged.error().code, ErrorCode::machine_refused) << "this core comes to it no more";
}

TEST_F(PublicationWord, ARefusedJobDoesNotGiveWayToOneThatWasRefusedBefore) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t first = publish(1);
    acknowledge_job(*core_, first, false, {message_of(MessageId::busy_for_a_job)});
    const std::uint64_t second = publish(2);
    EXPECT_FALSE(wait_for_acceptance(*hmi_, first, kShort));
    acknowledge_job(*core_, second, false, {message_of(MessageId::job_for_other_machine)});
    EXPECT_FALSE(wait_for_acceptance(*hmi_, second, kShort));
    EXPECT_EQ(published_generation(*hmi_), 0U);
}

TEST_F(PublicationWord, AJobWhoseSlotWasDamagedIsTakenBackAsWell) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t good = publish(1);
    accept(good);
    const std::uint64_t bad = publish(2);
    hmi_->header().publication.of_slot[bad % 2].seal.fetch_add(1);
    acknowledge_job(*core_, bad, false, {message_of(MessageId::published_checksum_wrong)});
    EXPECT_FALSE(wait_for_acceptance(*hmi_, bad, kShort));
    EXPECT_EQ(published_generation(*hmi_), good);
}

/// Whether that thread of ours sleeps in the kernel.
bool is_asleep(pid_t thread) {
    std::ifstream stat{"/proc/self/task/" + std::to_string(thread) + "/stat"};
    std::string text;
    std::getline(stat, text);
    const std::size_t name_end = text.rfind(')');
    return name_end != std::string::npos && text.compare(name_end, 3, ") S") == 0;
}

TEST_F(PublicationWord, AJobIsNotTakenBackThatACoreStartedAnewHasAccepted) {
    ASSERT_TRUE(core_->claim_core());
    const std::uint64_t generation = publish(1);
    acknowledge_job(*core_, generation, false, {message_of(MessageId::busy_for_a_job)});
    RobustMutex mutex{hmi_->header().mutex};
    mutex.lock();
    std::atomic<pid_t> waiter_id{0};
    std::thread waiter{[&] {
        waiter_id = ::gettid();
        EXPECT_FALSE(wait_for_acceptance(*hmi_, generation, kShort));
    }};
    // For the mutex: the refusal is there already.
    while (waiter_id == 0 || !is_asleep(waiter_id)) std::this_thread::yield();
    write_record(core_->header().verdict, JobVerdict{});
    accept(generation);
    mutex.unlock();
    waiter.join();
    EXPECT_EQ(published_generation(*hmi_), generation);
    EXPECT_TRUE(take_published_job(*core_, 0).value().value().blob == jobs_[generation]);
}

// Killed between the last word of its slot and the one that publishes it.
TEST_F(PublicationWord, AJobThatWasNotQuitePublishedCostsThePublishedOneNothing) {
    const std::uint64_t first = publish(1);
    publish(2);
    set_word(first);
    const std::uint64_t third = publish_job(*hmi_, test::make_job(3)).value();
    EXPECT_NE(third % 2, first % 2) << "it was written over the published one";
}

}  // namespace
}  // namespace psicarve
