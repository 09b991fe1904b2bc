// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;

/// The object as a plain file, for damage.
class RawObject {
public:
    explicit RawObject(const std::string& name, int flags = 0)
        : file_(::shm_open(name.c_str(), O_RDWR | flags, 0600)) {}
    ~RawObject() { ::close(file_); }
    RawObject(const RawObject&) = delete;
    RawObject& operator=(const RawObject&) = delete;
    int get() const { return file_; }
    template <typename T>
    void put(std::size_t offset, T value) {
        EXPECT_EQ(::pwrite(file_, &value, sizeof(value), static_cast<off_t>(offset)), ssize_t{sizeof(value)});
    }
    struct stat facts() const {
        struct stat facts {};
        EXPECT_EQ(::fstat(file_, &facts), 0);
        return facts;
    }

private:
    int file_;
};

class SegmentTest : public testing::Test {
protected:
    Segment make() {
        auto made = Segment::create_or_attach(name_.options());
        EXPECT_TRUE(made.has_value()) << made.error().message;
        return std::move(made).value();
    }
    std::string refusal() {
        const auto attached = Segment::attach(name_.get());
        const auto created = Segment::create_or_attach(name_.options());
        EXPECT_FALSE(attached.has_value());
        EXPECT_FALSE(created.has_value());
        if (attached || created) return "was not refused";
        EXPECT_EQ(attached.error().message, created.error().message);
        EXPECT_THAT(attached.error().message, HasSubstr(name_.get()));
        EXPECT_THAT(attached.error().message, HasSubstr("--segment"));
        return attached.error().message;
    }
    test::SegmentName name_;
};

TEST_F(SegmentTest, FirstCreatesAndSecondAttachesToTheSame) {
    Segment first = make();
    Segment second = make();

    first.header().core_profile_hash.store(77);

    EXPECT_EQ(second.header().core_profile_hash.load(), 77U);
    EXPECT_EQ(second.capacity_layers(), 500U);
    EXPECT_EQ(second.header().creator.pid.load(), own_pid());
    EXPECT_TRUE(second.warning().empty());
}

TEST_F(SegmentTest, NobodyElseMayOpenIt) {
    const Segment segment = make();

    EXPECT_EQ(RawObject{name_.get()}.facts().st_mode & 0777U, 0600U);
}

TEST_F(SegmentTest, DefaultCapacityTakesMemoryOnlyForItsHeader) {
    SegmentOptions options;
    options.name = name_.get();
    const auto segment = Segment::create_or_attach(options);
    ASSERT_TRUE(segment.has_value());

    const struct stat facts = RawObject{name_.get()}.facts();
    EXPECT_GT(facts.st_size, 200'000'000);
    EXPECT_LT(facts.st_blocks * 512, static_cast<off_t>(sizeof(SegmentHeader)) + 1'000'000);
}

TEST_F(SegmentTest, AttachSaysThatThereIsNone) {
    const auto attached = Segment::attach(name_.get());

    ASSERT_FALSE(attached.has_value());
    EXPECT_EQ(attached.error().code, ErrorCode::no_core);
}

TEST_F(SegmentTest, NameWithASlashOrNothingInItIsWrongUsage) {
    for (const char* name : {"", "/", "/a/b", "/..", "a b", "/x\n"}) {
        const auto attached = Segment::attach(name);
        ASSERT_FALSE(attached.has_value()) << name;
        EXPECT_EQ(attached.error().code, ErrorCode::bad_usage);
    }
}

TEST_F(SegmentTest, CapacityThatCannotBeIsWrongUsage) {
    SegmentOptions options = name_.options();
    options.capacity_points = 1;

    const auto made = Segment::create_or_attach(options);

    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().code, ErrorCode::bad_usage);
}

TEST_F(SegmentTest, SmallerSegmentThanAskedForIsKeptWithAWarning) {
    const Segment small = make();
    SegmentOptions options = name_.options();
    options.capacity_layers = 501;

    const auto second = Segment::create_or_attach(options);

    ASSERT_TRUE(second.has_value());
    EXPECT_EQ(second->capacity_layers(), 500U);
    EXPECT_THAT(second->warning(), HasSubstr("500 layers x 500 points"));
}

TEST_F(SegmentTest, GarbageIsRefused) {
    RawObject raw{name_.get(), O_CREAT};
    std::string garbage(10'000, 'x');
    ASSERT_EQ(::write(raw.get(), garbage.data(), garbage.size()), 10'000);

    EXPECT_THAT(refusal(), HasSubstr("is no psicarve segment"));
}

TEST_F(SegmentTest, FewBytesOfSomebodyElseAreRefused) {
    RawObject raw{name_.get(), O_CREAT};
    ASSERT_EQ(::write(raw.get(), "hello", 5), 5);

    EXPECT_THAT(refusal(), HasSubstr("is no psicarve segment"));
}

TEST_F(SegmentTest, TruncatedIsRefused) {
    { const Segment segment = make(); }
    ASSERT_EQ(::ftruncate(RawObject{name_.get()}.get(), 1'000'000), 0);

    EXPECT_THAT(refusal(), HasSubstr("wrong size: 1000000 bytes"));
}

TEST_F(SegmentTest, OversizedIsRefused) {
    { const Segment segment = make(); }
    ASSERT_EQ(::ftruncate(RawObject{name_.get()}.get(), 1'000'000'000), 0);

    EXPECT_THAT(refusal(), HasSubstr("wrong size: 1000000000 bytes"));
}

TEST_F(SegmentTest, ForeignLayoutVersionIsRefused) {
    { const Segment segment = make(); }
    RawObject{name_.get()}.put(offsetof(SegmentHeader, layout_version), std::uint32_t{7777});

    EXPECT_THAT(refusal(), HasSubstr("layout version 7777"));
}

TEST_F(SegmentTest, ForeignAbiIsRefused) {
    { const Segment segment = make(); }
    RawObject{name_.get()}.put(offsetof(SegmentHeader, abi_hash), segment_abi_hash() + 1);

    EXPECT_THAT(refusal(), HasSubstr("another build"));
}

TEST_F(SegmentTest, CapacityThatDoesNotFitTheOffsetsIsRefused) {
    for (const std::uint32_t layers : {0U, 499U, 0xFFFFFFFFU}) {
        {
            (void)Segment::remove(name_.get()).has_value();
            const Segment segment = make();
        }
        RawObject{name_.get()}.put(offsetof(SegmentHeader, capacity_layers), layers);

        EXPECT_THAT(refusal(), HasSubstr("damaged"));
    }
}

TEST_F(SegmentTest, EmptyObjectOfADeadCreatorIsTakenOver) {
    { const RawObject raw{name_.get(), O_CREAT}; }

    EXPECT_TRUE(make().is_still_linked());
}

TEST_F(SegmentTest, SizedButUnfilledObjectOfADeadCreatorIsTakenOver) {
    { ASSERT_EQ(::ftruncate(RawObject{name_.get(), O_CREAT}.get(), 5'000'000), 0); }

    EXPECT_TRUE(make().is_still_linked());
}

TEST_F(SegmentTest, FilledObjectThatWasNeverReadyIsTakenOver) {
    { const Segment segment = make(); }
    RawObject{name_.get()}.put(offsetof(SegmentHeader, ready), std::uint32_t{0});
    EXPECT_EQ(Segment::attach(name_.get()).error().code, ErrorCode::no_core);

    EXPECT_TRUE(make().is_still_linked());
}

TEST_F(SegmentTest, OneFromAnEarlierBootIsReplaced) {
    {
        Segment old = make();
        ASSERT_TRUE(publish_job(old, test::make_job(1)).has_value());
    }
    RawObject{name_.get()}.put(offsetof(SegmentHeader, boot_id), std::uint64_t{0x3030303030303030});
    EXPECT_EQ(Segment::attach(name_.get()).error().code, ErrorCode::no_core);

    const Segment segment = make();

    EXPECT_EQ(published_generation(segment), 0U);
}

TEST_F(SegmentTest, KnowsThatItsNameWasRemovedOrReplaced) {
    const Segment first = make();
    EXPECT_TRUE(first.is_still_linked());
    ASSERT_TRUE(Segment::remove(name_.get()).has_value());
    EXPECT_FALSE(first.is_still_linked());

    const Segment second = make();
    EXPECT_FALSE(first.is_still_linked());
    EXPECT_TRUE(second.is_still_linked());
}

TEST_F(SegmentTest, KnowsThatItsHeaderWasOverwritten) {
    const Segment segment = make();
    RawObject{name_.get()}.put(offsetof(SegmentHeader, magic), std::uint64_t{1});

    EXPECT_FALSE(segment.is_still_linked());
}

TEST_F(SegmentTest, SurvivesBeingTruncatedWhileInUse) {
    Segment segment = make();
    ASSERT_TRUE(segment.claim_core().has_value());
    ASSERT_EQ(::ftruncate(RawObject{name_.get()}.get(), 0), 0);

    write_record(segment.header().status, CoreStatus{});
    append_to_ring(segment.header().recorder, FlightRecord{});

    EXPECT_FALSE(segment.is_still_linked());
    EXPECT_FALSE(publish_job(segment, test::make_job(1)).has_value());
    EXPECT_FALSE(take_command(segment).has_value());
    EXPECT_EQ(RawObject{name_.get()}.facts().st_size, 0);
    EXPECT_TRUE(Segment::create_or_attach(name_.options()).has_value());
}

TEST_F(SegmentTest, SecondCoreIsRefusedWithTheFirstOnesPid) {
    Segment first = make();
    Segment second = make();
    EXPECT_FALSE(second.core_pid().has_value());
    ASSERT_TRUE(first.claim_core().has_value());
    EXPECT_EQ(first.core_pid(), own_pid());
    EXPECT_EQ(second.core_pid(), own_pid());

    const auto refused = second.claim_core();

    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().message, HasSubstr("pid " + std::to_string(own_pid())));
    first.release_core();
    EXPECT_FALSE(second.core_pid().has_value());
    EXPECT_TRUE(second.claim_core().has_value());
}

TEST_F(SegmentTest, GlanceTellsWhetherACoreHasSigned) {
    Segment core = make();
    const Segment window = make();
    EXPECT_FALSE(window.glance_at_core());
    ASSERT_TRUE(core.take_core_lock());
    const auto starting = window.glance_at_core();
    ASSERT_TRUE(starting);
    EXPECT_EQ(starting->pid, 0U);
    EXPECT_FALSE(starting->is_signed);

    core.sign_core();

    const auto serving = window.glance_at_core();
    ASSERT_TRUE(serving);
    EXPECT_EQ(serving->pid, own_pid());
    EXPECT_TRUE(serving->is_signed);
}

TEST_F(SegmentTest, NewCoreClearsWhatTheOldOneLeftButKeepsTheJob) {
    Segment segment = make();
    const auto generation = publish_job(segment, test::make_job(1));
    ASSERT_TRUE(generation.has_value());
    ASSERT_TRUE(segment.claim_core().has_value());
    acknowledge_job(segment, *generation, true);
    CoreStatus status{};
    status.tick = 99;
    write_record(segment.header().status, status);
    append_to_ring(segment.header().recorder, FlightRecord{});
    segment.release_core();

    ASSERT_TRUE(segment.claim_core().has_value());

    EXPECT_EQ(read_record(segment.header().status).value().tick, 0U);
    EXPECT_EQ(read_record(segment.header().verdict).value().generation, 0U);
    EXPECT_FALSE((RingReader{segment.header().recorder}.next().has_value()));
    EXPECT_TRUE(take_published_job(segment, 0).value().has_value());
}

}  // namespace
}  // namespace psicarve
